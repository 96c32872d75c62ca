"""The first lines of a material's page: the model to take, and the commands for a diagnosis of its runs."""

import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path

from markupsafe import Markup

from ...ground.model_errors import errors_in
from ...ground.words.counts import counted
from ..model_to_take.model_advice import advice_on
from ..model_to_take.usual_model import uses
from ..web.page import paragraph, together

NAMED = 4  # runs that a command names
TOGETHER = (
    " The runs of one string in one diagnosis tell more than each alone, above all under several loads;"
    " of {}: <code>{}</code>."
)


def model_to_take(folder: Path) -> Markup:
    """Which model to take of `reports/<material>/`, why, and how to export it; empty where no errors are known."""
    models_csv = folder / "models.csv"
    advice = advice_on(sorted({model for model, _ in errors_in(models_csv)}), models_csv)
    if not advice.reason:
        return Markup("")
    ways = [
        Markup("To {}: <code>{}</code>").format(where, uses(folder.name, model)[0])
        for where, model in advice.controllers.items()
    ]
    ways.append(Markup("To ask it: <code>{}</code>").format(uses(folder.name, advice.model)[1]))
    name, _, because = advice.reason.partition(". ")
    first = paragraph(Markup("<b>{}{}.</b> {} {}").format(name[:1].upper(), name[1:], because, advice.at_inverse))
    return together([first, paragraph(Markup("<br>").join(ways))])


def left_out_of(runs_of: Mapping[str, Sequence[str]]) -> Markup:
    """The commands that find what the simulator leaves out, for the runs of each string; empty without runs.

    The verdict itself would make another page wherever a diagnosis lies beside it.
    """
    runs = [run for own in runs_of.values() for run in own]
    if not runs:
        return Markup("")
    more = f" (and {counted(len(runs) - NAMED, 'more run')})" if len(runs) > NAMED else ""
    shape = Markup(
        "What the simulator leaves out of {}{}: <code>{}</code> writes it into reports/mine/&lt;run&gt;/verdict.txt."
        " The main job shows it on the page of all reports.{}"
    )
    several = [(string, own) for string, own in runs_of.items() if 1 < len(own) <= NAMED]
    as_one = Markup("").join(
        Markup(TOGETHER).format(string, _diagnose(own, f"reports/mine/{string}", "--together "))
        for string, own in several[:1]
    )
    each = _diagnose(runs[:NAMED], "reports/mine")
    return paragraph(shape.format("this run" if len(runs) == 1 else "these runs", more, each, as_one))


def _diagnose(runs: Sequence[str], out: str, options: str = "") -> str:
    """The command that diagnoses runs into the folder `out`, for a shell."""
    folders = " ".join(shlex.quote(f"raw/{run}") for run in runs)
    return f"python -m pipeline.diagnose {folders} {options}--out {shlex.quote(out)}"
