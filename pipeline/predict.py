"""Questions → answers with intervals: the contraction for a twist, or the twist for a contraction, of a material.

The model is fitted to the points of the material's dataset, held out or not, and to parts of them to learn how it errs
(`models/parts/prediction_intervals.py`). A question outside the range of what was recorded, or further ahead of the
last recorded stroke than errors could be learnt, is answered, flagged (`inside` false) and given infinite bounds. With
`--saved` a model that was fitted before answers, as its export does and without intervals.
"""

import sys
from pathlib import Path

import numpy as np
import pandas as pd

from .export.asked import MAPS
from .export.asked import answers as saved_answers
from .ground import schemas
from .ground.command import HOUSE, command
from .ground.errors import BadInput, program
from .ground.files import write_text
from .ground.given_table import opened
from .ground.outputs import file_to_write
from .ground.parser import Parser
from .models.interface import about, usual
from .models.parts.box import COLUMNS
from .models.parts.conditions import Conditions
from .models.parts.prediction_intervals import GIVEN, Intervals, TooFew
from .models.parts.question_table import question_table, refuse_cells
from .models.parts.settings import shown
from .models.parts.unanswered import reasons
from .stages.train import configured, fitting, seed
from .string.jump_notes import NAME, read_jumps

ASKED = ("stroke", "direction")  # every question must tell
WAYS = (1, -1)
MOST_STROKE = 10**9  # that a question may be about: any number that a person means
MOST_POINTS = 5000  # evenly thinned; more tell no more, and cost minutes


def read_questions(path: Path, dataset: pd.DataFrame) -> tuple[pd.DataFrame, str]:
    """Questions as points with the dataset's columns, and which of twist and contraction they tell.

    What does not vary in the dataset need not be told. Raises BadInput naming the column.
    """
    questions = question_table(path, list(dataset.columns))
    known = [name for name in MAPS if name in questions.columns]
    if len(known) != 1:
        given = (
            f"are {', '.join(map(repr, questions.columns))}: {'both' if known else 'neither'} of {' and '.join(MAPS)}"
        )
        raise BadInput(path, "columns", given, "tell one of the two, and the other is answered; commas part columns")
    if questions.empty:
        raise BadInput(path, "rows", "there are none", "write one question a line")
    points = pd.DataFrame(index=range(len(questions)))
    for name in dataset.columns:
        if name in questions.columns:
            refuse_cells(path, questions[name], dataset[name], numeric=name in (*COLUMNS, *ASKED))
            points[name] = questions[name].to_numpy()
        elif name == GIVEN[known[0]]:
            points[name] = np.nan
        elif name == "load_n" and not Conditions.of(dataset, ("load_n",)).names:
            points[name] = dataset[name].median()  # what little it varies is its cell's noise
        elif name in (*COLUMNS, "actuator", "string") and dataset[name].nunique(dropna=False) > 1:
            raise BadInput(path, name, "is missing, and varies in the recordings", "add the column")
        else:
            points[name] = dataset[name].iloc[0]
    strange = sorted(set(points["actuator"].astype(str)) - set(dataset["actuator"]))
    if strange:
        given = f"is {shown(strange[0])}, and the recordings are of {' and '.join(sorted(set(dataset['actuator'])))}"
        raise BadInput(path, "actuator", given, "ask a dataset of that actuator")
    strokes = points["stroke"].to_numpy(float)
    if not (((strokes == np.floor(strokes)) & (strokes >= 1.0) & (strokes <= MOST_STROKE)).all()):
        raise BadInput(path, "stroke", "is no whole number from 1 somewhere", "the first stroke of a new string is 1")
    points["stroke"] = strokes.astype(np.int64)
    if not points["direction"].isin(WAYS).all():
        raise BadInput(path, "direction", "is neither 1 nor -1 somewhere", "1 is winding, -1 unwinding")
    return points, known[0]


def answers(intervals: Intervals, points: pd.DataFrame, known: str, level: float) -> pd.DataFrame:
    """Value, low and high in the answer's unit, and whether the question lies inside."""
    interval, wanted = getattr(intervals, MAPS[known])(points, level), GIVEN[known]
    return interval.rename(columns={"value": wanted, "low": f"{wanted}_low", "high": f"{wanted}_high"})


def beside_questions(points: pd.DataFrame, known: str, answered: pd.DataFrame) -> pd.DataFrame:
    """What was asked beside its answer; of the other columns, such as the load, those in which the questions differ."""
    others = [name for name in points if name not in (known, GIVEN[known], *ASKED) and points[name].nunique() > 1]
    return pd.concat([points[[known, *ASKED, *others]], answered], axis=1)


@program
def main() -> None:
    """Write the answers to a csv of questions."""
    parser = Parser(prog=command("predict"), description=__doc__)
    parser.add_argument("dataset", type=Path, help="processed/<material>/dataset.parquet")
    parser.add_argument(
        "questions",
        type=Path,
        help="csv: motor_turns or displacement_mm; stroke; direction, 1 winding or -1 unwinding; and what differs "
        "among the recordings, such as load_n",
    )
    parser.add_argument(
        "--model",
        help=f"a file of {HOUSE}/models, without .py; fitted anew, no saved file is read; default: {usual()}",
    )
    saved = "this fitted model answers, as its export: processed/<material>/<model>/<split>-<seed>.model"
    parser.add_argument("--saved", type=Path, metavar="FILE", help=saved)
    parser.add_argument("--settings", default="{}", metavar="JSON", help="the model's settings")
    parser.add_argument("--level", type=float, default=0.9, help="probability that an interval holds the truth")
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
    dataset = opened(arguments.dataset, schemas.DATASET, "name processed/<material>/dataset.parquet")
    for note in read_jumps([arguments.dataset.with_name(NAME)]):
        print(f"beware: {note}", file=sys.stderr)
    points, known = read_questions(arguments.questions, dataset)
    if arguments.saved:
        answered, why_not = saved_answers(arguments.saved, points, known, arguments.dataset)
        table = beside_questions(points, known, answered)
        write_text(arguments.out, table.to_csv(index=False, float_format="%.6g"))
        held_back = int((~table["inside"]).sum())
        print(f"{len(table)} answers of {arguments.saved} in {arguments.out}, without intervals", end="")
        print(f"; its export does not answer {held_back} of them" if held_back else "")
        print("".join(f"  {reason}\n" for reason in why_not), end="")
        return
    intervals = Intervals(lambda: configured(arguments.model, arguments.settings))
    try:
        with fitting(arguments.model):
            intervals.fit(dataset.iloc[:: -(-len(dataset) // MOST_POINTS)].reset_index(drop=True), arguments.seed)
            table = beside_questions(points, known, answers(intervals, points, known, arguments.level))
    except TooFew as error:
        raise BadInput(
            arguments.dataset, "points", str(error), "record more strokes, or more samples a stroke"
        ) from None
    write_text(arguments.out, table.to_csv(index=False, float_format="%.6g"))
    outside = int((~table["inside"]).sum())
    print(f"{len(table)} answers in {arguments.out}", end="")
    print(f", {outside} of them without an interval: outside what was recorded, or too far ahead" if outside else "")
    for reason in reasons(intervals, points, GIVEN[known], table["inside"].to_numpy(bool)):
        print(f"  {reason}")


if __name__ == "__main__":
    main()
