"""Questions → answers with intervals: the contraction for a twist, or the twist for a contraction, of a material.

The model is fitted to the points of the material's dataset, held out or not, and to parts of them to learn how it errs
(`models/parts/questions/prediction_intervals.py`). A question outside the range of what was recorded, at a twist or in
a stroke that was not recorded around its load, or further ahead than errors could be learnt, is answered, flagged
(`inside` false, its reason in `why`) and has no bounds: their cells are empty. Between recorded loads the interval is
wider: by the errors at recorded loads that were left out whole, or, of two loads, over the answers at both. In a stroke
that errs more than others it is wider by that stroke's own errors. A row that
is no question has no answer, and its reason in `why`; the others are answered, and the exit status is 2. With `--saved`
a model that was fitted before answers, as its export does and without intervals; the same questions are flagged. Where
no size sets strings apart they have one answer, and the column `answer_of` names them; with `--each-string` the model
is fitted to the points of each string alone. No question tells how long the string has stood: holds and rests are asked
of `simulate --motion`.
"""

import sys
from pathlib import Path

import pandas as pd

from .export.all_points import string_alone
from .export.asked_saved import keeps_strings_apart, model_of, saved_answers, seen_points
from .export.interface import names as exported
from .ground.command import HOUSE, INSTALLED, command, make_command, quoted
from .ground.errors import program
from .ground.input.outputs import file_to_write
from .ground.input.parser import Parser
from .ground.model_errors import Errors, chosen_of, errors_in
from .ground.model_names import EQUATIONS, NOMINAL, USUAL
from .ground.stored import schemas
from .ground.stored.files import write_text
from .ground.stored.given_table import opened
from .ground.words.counts import counted
from .ground.words.jump_notes import NAME, beside_answers
from .models.interface import names_with_motion
from .models.parts.fitted_to import apart
from .models.parts.inside.why import Kind
from .models.parts.newer_recordings import beware_of_newer
from .models.parts.questions.bad_rows import first_of, refusal
from .models.parts.questions.question_points import read_questions
from .models.parts.questions.strings_alike import ANSWER_OF, one_answer, strings_alike
from .models.parts.saved_files import DATASET_FILE, MAKE_DATASET, MODEL_FILE, dataset_mend, listed, material_of
from .notebook.asked_model import LEVEL, Fitted, refuse
from .notebook.better_source import Beside, adopted_run
from .notebook.far_off import far_off
from .stages.train import seed

ALONE = f"--each-string, or --model {EQUATIONS}"  # the options that answer for one string alone
NOTED = {  # of answers with an interval, how many are said to be so
    Kind.BETWEEN: "between what was recorded",
    Kind.ERRS_MORE: "in a stroke that errs more than others",
}
ZERO = (
    "Contractions have the model's zero, not the sensor's: the rest before a string's first stroke is set to what the "
    "paper's equation gives there."
)
BRIEFLY = (
    "Questions → answers with intervals: the contraction for a twist, or the twist for a contraction, of a material. A "
    "question that was not recorded so is answered without an interval: `inside` is false, and `why` says the reason. "
    "A row that is no question is left unanswered, and the exit status is 2."
)


@program
def main() -> None:
    """Write the answers to a file of questions as a csv."""
    parser = Parser(prog=command("predict"), description=BRIEFLY)
    parser.ending = listed(exported())
    make = MAKE_DATASET if INSTALLED else make_command(Path(DATASET_FILE))
    parser.add_argument("dataset", type=Path, help=f"{DATASET_FILE}; made alone by: {make}")
    parser.add_argument(
        "questions",
        type=Path,
        help="csv (parted by commas, semicolons or tabs) or .xlsx: motor_turns or displacement_mm, each row one of "
        "them; stroke; direction, 1 winding or -1 unwinding; and what differs among the recordings, such as load_n",
    )
    parser.add_argument(
        "--model",
        help=f"a file of {HOUSE}/models, without .py; fitted anew, no saved file is read; default: {USUAL}",
    )
    saved = f"this fitted model answers, as its export: {MODEL_FILE}"
    parser.add_argument("--saved", type=Path, metavar="FILE", help=saved)
    parser.add_argument(
        "--each-string",
        action="store_true",
        help="fit the model to the recordings of each string alone; default: strings of the same sizes have one answer",
    )
    parser.add_argument("--settings", default="{}", metavar="JSON", help="the model's settings")
    parser.add_argument(
        "--level", type=float, help=f"probability that an interval holds one measured reading; default: {LEVEL:g}"
    )
    parser.add_argument("--seed", type=seed, default=0)
    parser.add_argument("--out", type=Path, required=True, help="the file of the answers, csv; required")
    arguments = parser.parse_args()
    anew = arguments.model, arguments.settings != "{}", arguments.each_string, arguments.level is not None
    if arguments.saved and any(anew):
        parser.error("--saved takes a model as it is: leave out --model, --settings, --each-string and --level")
    arguments.level = LEVEL if arguments.level is None else arguments.level
    is_named, arguments.model = bool(arguments.model), arguments.model or USUAL
    refuse(arguments.model, arguments.settings, arguments.level)
    reads = [arguments.dataset, arguments.questions, *([arguments.saved] if arguments.saved else [])]
    file_to_write(arguments.out, reads=reads)
    dataset = opened(arguments.dataset, schemas.DATASET, dataset_mend(arguments.dataset))
    if beware := beware_of_newer(arguments.dataset):
        print(beware, file=sys.stderr)
    if arguments.saved:
        is_apart = keeps_strings_apart(arguments.saved)
        questions = read_questions(arguments.questions, dataset, is_apart)
        table = saved_answers(arguments.saved, dataset, questions, arguments.dataset)
        if older := apart(arguments.saved, arguments.dataset):
            print(f"beware: {older.sentence}", file=sys.stderr)
            dataset = seen_points(older, dataset)
        else:
            _tell_of_zero(arguments.dataset, dataset, questions.points, is_apart, string_alone(arguments.saved))
        arguments.model = model_of(arguments.saved)
        by, less = f"by {arguments.saved}, without intervals", "outside of its export or of what was recorded"
    else:
        options = arguments.model, arguments.settings, arguments.seed, arguments.level, arguments.each_string
        fitted = Fitted(dataset, *options, arguments.dataset)
        questions = read_questions(arguments.questions, dataset, fitted.apart)
        learns = arguments.model != NOMINAL
        _tell_of_zero(arguments.dataset, dataset, questions.points, fitted.apart or not learns)
        table = fitted.answered(questions)
        to = f"each string of {arguments.dataset} alone" if fitted.apart else str(arguments.dataset)
        of_what = f"fitted anew to {to}" if learns else "which learns nothing"
        by, less = f"by the {arguments.model} model, {of_what}", "without an interval"
        if arguments.each_string and dataset["string"].nunique() == 1:
            print(f"note: --each-string changes nothing: {arguments.dataset} is of one string.", file=sys.stderr)
    if ANSWER_OF in table:
        strings = set(questions.points["string"].astype(str))
        alike = {string: words for string, words in strings_alike(dataset).items() if string in strings}
        if beware := one_answer(arguments.model, alike, ALONE):
            print(beware, file=sys.stderr)
    why = table["why"].map(str)
    write_text(arguments.out, table.assign(why=why).to_csv(index=False, float_format="%.6g"))
    outside = int((~table["inside"]).sum()) - len(questions.bad)
    noted = {kind: sum(each.tells(kind) for each in table["why"][table["inside"]]) for kind in NOTED}
    counts = [f"{outside} of them {less}"] * (outside > 0)
    counts += [f"{noted[kind]} {words}" for kind, words in NOTED.items() if noted[kind]]
    none = sum(each.tells(Kind.IMPOSSIBLE) for each in table["why"])
    counts += [f"{none} of them without a number: no string can do what the model answers"] * bool(none)
    counts += [f"{counted(len(questions.bad), 'row')} without an answer"] * bool(questions.bad)
    print("; ".join([f"{counted(len(questions.points), 'answer')} in {arguments.out}, {by}", *counts]), end="")
    refused = {entry.row for entry in questions.bad}  # said once, at the end
    whys = ["" if row in refused else each for row, each in enumerate(why, start=1)]
    sentences = first_of(whys, ", each with its reason in the column `why`")
    end = "; row 1 is the first question:" if sentences else "."
    print(f". The column `why` says why{end}" if counts else "")
    for sentence in sentences:
        print(f"  {sentence}")
    typed = parser.typed_without(("--model", "--saved", "--settings", "--out"))
    errors_mm, asked_strings = _errors_of_page(arguments.dataset), set(questions.points["string"].astype(str))
    beside = Beside(errors_mm, adopted_run(arguments.dataset, dataset, asked_strings))
    for sentence, compare in far_off(questions, dataset, table, arguments.model, beside):
        print(sentence)
        if compare:
            out = ["--out", str(arguments.out.with_stem(f"{arguments.out.stem}-{compare}"))]
            print(f"  {' '.join([command('predict'), '--model', compare, *map(quoted, [*out, *typed])])}")
    print(ZERO)
    if not (arguments.saved or is_named) and (taken := _taken_by(errors_mm)) not in ("", arguments.model):
        print(f"The page of {material_of(arguments.dataset)} takes {taken}: --model {taken} asks that one.")
    if questions.bad:
        raise refusal(arguments.questions, questions.bad, len(questions.points), arguments.out)


def _tell_of_zero(path: Path, dataset: pd.DataFrame, asked_points: pd.DataFrame, apart: bool, alone: str = "") -> None:
    """Print what the zero did of the strings that are asked about, and of which others that the model learnt.

    `path` is that of the `dataset`. The model is fitted to each string `apart`, or to one `alone`, or to all.
    """
    strings = set(asked_points["string"].astype(str))
    learnt = {alone} if alone else set() if apart else set(dataset["string"].astype(str))
    for line in beside_answers(path.with_name(NAME), strings, learnt):
        print(line, file=sys.stderr)


def _errors_of_page(dataset: Path) -> Errors:
    """The errors in mm on the page of a dataset's material, by model and split; none where there is no such page."""
    if not material_of(dataset):
        return {}
    return errors_in(dataset.resolve().parents[2] / "reports" / material_of(dataset) / "models.csv")


def _taken_by(errors_mm: Errors) -> str:
    """The model that a page with these errors takes; empty where there are none.

    A page of an earlier version does not say which models need a whole motion: their own files do.
    """
    return chosen_of({model for model, _ in errors_mm} - set(names_with_motion()), errors_mm)


if __name__ == "__main__":
    main()
