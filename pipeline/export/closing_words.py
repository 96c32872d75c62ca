"""The screen's words after an export: its place, its error, and how to try it; the file has the rest."""

import re
import shlex
from pathlib import Path

from ..ground.command import HOUSE, command
from ..models.interface import about
from .caveats import facts
from .held_out import ANEW
from .inputs import MEANING
from .interface import Source
from .trained_on import ALIKE, NO_STRING

EXAMPLE = Path("examples/control_loop.c")
USUAL = "tsa"  # the name that the example is written for
MADE_UP = "Synthetic: do not drive a real rig by this."
SENTENCE = re.compile(r"(?<=\.) (?=[A-Z])")


def lines(source: Source) -> list[str]:
    """That the model is older than its dataset; what the zero did; the error, a line each split; and remarks.

    Remarks: strings with one answer, synthetic, a small fit.
    """
    sentences = facts(source)
    errors = [text for text in SENTENCE.split((source.errors or "").replace(ANEW, "").strip()) if text]
    together = [text for text in SENTENCE.split(source.trained or "") if text.endswith(ALIKE)]
    synthetic = [MADE_UP] if NO_STRING in (source.trained or "") else []
    unusual = (
        [sentences["fit"]] if not sentences["fit"].startswith(("Made with the usual", "This model has no")) else []
    )
    beware = [f"beware: {words}" for words in (source.older, source.jumped) if words]
    return [*beware, *errors, *together, *synthetic, *unusual]


def compiled(header: Path, name: str) -> list[str]:
    """The command that compiles and runs the example, where it lies here and is written for the export's name."""
    if name != USUAL or header.name != f"{USUAL}.h" or not EXAMPLE.is_file():
        return []
    return [f"To try it: cc -I {shlex.quote(str(header.parent))} {EXAMPLE} -lm && ./a.out"]


def columns(source: Source, from_column: str) -> str:
    """The columns of a graph's input in their order with units; `from_column` is the first, twist or contraction."""
    units = (
        (field.name, MEANING[field.name] if field.unit == "1" else field.unit)
        for field in source.inputs.columns(from_column)
    )
    return f"Columns of `queries`, in order: {'; '.join(f'{name} ({unit})' for name, unit in units)}."


def in_python(source: Source, file: Path) -> str:
    """How to get the same answers in Python: other commands fit the model anew, to more points.

    Where no dataset lies beside the model, a notebook asks it.
    """
    dataset = file.parent.parent / "dataset.parquet"
    if not dataset.is_file():
        model = f'{HOUSE}.load("{source.name}", "{file}")'
        return f"The same answers in Python: {model}, then .forward(points) or .inverse(points)."
    alone = source.string and not about(source.name).each_string_apart
    by = f"--each-string --model {source.name}" if alone else f"--saved {shlex.quote(str(file))}"
    ask = f"{command('predict')} {shlex.quote(str(dataset))} questions.csv {by}"
    return f"The same answers in Python: {ask} --out answers.csv"
