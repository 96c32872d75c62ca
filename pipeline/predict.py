"""Questions → answers with intervals: the contraction for a twist, or the twist for a contraction, of a material.

The model is fitted to the points of the material's dataset, held out or not, and to parts of them to learn how it errs
(`models/parts/prediction_intervals.py`). A question outside the range of what was recorded, at a twist or in a stroke
that was not recorded around its load, or further ahead than errors could be learnt, is answered, flagged
(`inside` false, its reason in `why`) and has no bounds: their cells are empty. Between recorded loads the interval is
wider: by the errors at recorded loads that were left out whole, or, of two loads, over the answers at both. A row that
is no question has no answer, and its reason in `why`; the others are answered, and the exit status is 2. With `--saved`
a model that was fitted before answers, as its export does and without intervals; the same questions are flagged. No
question tells how long the string has stood: holds and rests are asked of `simulate --motion`.
"""

import math
import sys
from collections.abc import Callable
from pathlib import Path

import pandas as pd

from .export.asked import MAPS
from .export.asked import answers as saved_answers
from .export.interface import names as exported
from .export.source import Beside
from .export.source import opened as opened_model
from .ground import schemas
from .ground.command import HOUSE, command
from .ground.counts import counted
from .ground.errors import BadInput, program
from .ground.files import write_text
from .ground.given_table import opened
from .ground.jump_notes import NAME, read_jumps
from .ground.outputs import file_to_write
from .ground.parser import Parser
from .models.interface import about, usual
from .models.parts.bad_rows import reason, refusal
from .models.parts.configured import configured, fitting
from .models.parts.foreseen import GIVEN
from .models.parts.prediction_intervals import Intervals, TooFew
from .models.parts.question_points import ASKED, EITHER, Questions, by_known, read_questions
from .models.parts.recorded_pairs import pairs_of
from .models.parts.recorded_strokes import Under
from .models.parts.rolling_origin import last_strokes
from .models.parts.saved_files import check_own, datasets, listed
from .models.parts.thinned import thinned
from .models.parts.unanswered import first_of, reasons
from .stages.train import seed


def answers(intervals: Intervals, points: pd.DataFrame, known: str, level: float) -> pd.DataFrame:
    """Value, low and high in the answer's unit, whether the question lies inside, and why not.

    Where there is no interval low and high are no numbers.
    """
    interval, wanted = getattr(intervals, MAPS[known])(points, level), GIVEN[known]
    why = reasons(intervals, points, wanted, interval["inside"].to_numpy(bool), level)
    interval = interval.replace([-math.inf, math.inf], math.nan)
    answered = interval.rename(columns={"value": wanted, "low": f"{wanted}_low", "high": f"{wanted}_high"})
    return answered.assign(why=why)


def beside_questions(questions: Questions, answer: Callable[[pd.DataFrame, str], pd.DataFrame]) -> pd.DataFrame:
    """What was asked beside its answer; of the other columns, such as the load, those that the questions tell.

    Where some rows ask for the twist and others for the contraction, the column `asked_for` says which. A row that is
    no question stays in its place, without an answer: its reason is in `why`.
    """
    points = questions.points
    others = [name for name in points if name not in (*EITHER, *ASKED) and name in questions.columns]
    tables = {}
    for known, rows, part in by_known(points):
        tables[known] = pd.concat([part[[known, *ASKED, *others]], answer(part, known)], axis=1)
        tables[known].index = rows
    if len(tables) == 1:
        return _with_bad(next(iter(tables.values())), questions)
    whole = pd.concat([table.assign(asked_for=GIVEN[known]) for known, table in tables.items()]).sort_index()
    first = ["asked_for", *EITHER, *ASKED, *others]
    last = ["inside", "why"]
    return _with_bad(whole[[*first, *(name for name in whole if name not in (*first, *last)), *last]], questions)


def _with_bad(table: pd.DataFrame, questions: Questions) -> pd.DataFrame:
    """The answers in the order of the file's rows, and what stands in the bad ones beside what is wrong with it."""
    if not questions.bad:
        return table
    why = [reason(entry) for entry in questions.bad]
    given = questions.cells[[name for name in questions.cells if name in table]]
    both = pd.concat([table.set_axis(questions.rows[table.index], axis=0), given.assign(inside=False, why=why)])
    return both[list(table.columns)].sort_index().astype({"inside": bool})


@program
def main() -> None:
    """Write the answers to a csv of questions."""
    parser = Parser(prog=command("predict"), description=__doc__)
    parser.ending = listed(exported())
    parser.add_argument("dataset", type=Path, help="processed/<material>/dataset.parquet")
    parser.add_argument(
        "questions",
        type=Path,
        help="csv: motor_turns or displacement_mm, each row one of them; stroke; direction, 1 winding or -1 unwinding; "
        "and what differs among the recordings, such as load_n",
    )
    parser.add_argument(
        "--model",
        help=f"a file of {HOUSE}/models, without .py; fitted anew, no saved file is read; default: {usual()}",
    )
    saved = "this fitted model answers, as its export: processed/<material>/<model>/<split>-<seed>.model"
    parser.add_argument("--saved", type=Path, metavar="FILE", help=saved)
    parser.add_argument("--settings", default="{}", metavar="JSON", help="the model's settings")
    parser.add_argument(
        "--level", type=float, default=0.9, help="probability that an interval holds the truth; default: %(default)s"
    )
    parser.add_argument("--seed", type=seed, default=0)
    parser.add_argument("--out", type=Path, required=True, help="the file of the answers, csv; required")
    arguments = parser.parse_args()
    if not 0.0 < arguments.level < 1.0:
        raise BadInput("--level", str(arguments.level), "is no probability", "give a number between 0 and 1")
    if arguments.saved and (arguments.model or arguments.settings != "{}"):
        parser.error("--saved takes a model as it is: leave out --model and --settings")
    arguments.model = arguments.model or usual()
    configured(arguments.model, arguments.settings)  # complains before anything is fitted
    if about(arguments.model).needs_motion:
        problem = "answers along a whole motion, which single questions do not tell"
        raise BadInput("--model", arguments.model, problem, f"choose another, such as {usual()}")
    reads = [arguments.dataset, arguments.questions, *([arguments.saved] if arguments.saved else [])]
    file_to_write(arguments.out, reads=reads)
    near = ", ".join(map(str, datasets())) or "processed/<material>/dataset.parquet, which the main job makes"
    dataset = opened(arguments.dataset, schemas.DATASET, f"name {near}")
    for note in read_jumps([arguments.dataset.with_name(NAME)]):
        print(f"beware: {note}", file=sys.stderr)
    questions = read_questions(arguments.questions, dataset)
    if arguments.saved:
        check_own(arguments.saved, arguments.dataset)
        strings = questions.points["string"].unique()
        beside = Beside(dataset=arguments.dataset, string=str(strings[0]) if len(strings) == 1 else None)
        source = opened_model(arguments.saved, None, beside)
        pairs, strokes = pairs_of(dataset), last_strokes(dataset)
        under = Under.of(dataset, source.foreseen[1] if source.foreseen else 0)
        table = beside_questions(
            questions, lambda part, known: saved_answers(source, part, known, arguments.saved, pairs, strokes, under)
        )
        by, less = f"by {arguments.saved}, without intervals", "outside of its export or of what was recorded"
    else:
        intervals = Intervals(lambda: configured(arguments.model, arguments.settings))
        try:
            with fitting(arguments.model):
                intervals.fit(thinned(dataset), arguments.seed)
                table = beside_questions(
                    questions, lambda part, known: answers(intervals, part, known, arguments.level)
                )
        except TooFew as error:
            mend = "record more strokes, or more samples a stroke"
            raise BadInput(arguments.dataset, "points", str(error), mend) from None
        by, less = f"by a {arguments.model} fitted anew to {arguments.dataset}", "without an interval"
    write_text(arguments.out, table.to_csv(index=False, float_format="%.6g"))
    outside = int((~table["inside"]).sum()) - len(questions.bad)
    noted = int((table["inside"] & (table["why"] != "")).sum())
    counts = [f"{outside} of them {less}"] * (outside > 0) + [f"{noted} between what was recorded"] * (noted > 0)
    counts += [f"{counted(len(questions.bad), 'row')} without an answer"] * bool(questions.bad)
    print("; ".join([f"{counted(len(questions.points), 'answer')} in {arguments.out}, {by}", *counts]), end="")
    print(". The column `why` says why; row 1 is the first question:" if counts else "")
    for sentence in first_of(table["why"].tolist()):
        print(f"  {sentence}")
    if questions.bad:
        raise refusal(arguments.questions, questions.bad, len(questions.points))


if __name__ == "__main__":
    main()
