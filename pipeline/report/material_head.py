"""The first lines of a material's page: the model to take, and how to ask what the simulator leaves out of its runs."""

import shlex
from collections.abc import Sequence
from pathlib import Path

from markupsafe import Markup

from . import inverse_beside
from .fitted import FLOORS
from .usual_model import chosen_of, errors_in, uses, why
from .web.page import paragraph, together

NAMED = 4  # runs that a command names


def model_to_take(folder: Path) -> Markup:
    """Which model to take of `reports/<material>/`, why, and how to export it; empty where no errors are known."""
    errors_mm = errors_in(folder / "models.csv")
    models = sorted({model for model, _ in errors_mm} - set(FLOORS))
    chosen = chosen_of(models, errors_mm)
    reason = why(chosen, models, errors_mm)
    if not reason:
        return Markup("")
    errors_turns = errors_in(folder / "models.csv", "inverse")
    at_inverse = inverse_beside.sentences(chosen, {model: model for model in models}, errors_turns, errors_mm)
    commands = {"a controller": chosen, "a position controller": inverse_beside.better(chosen, models, errors_turns)}
    ways = [
        Markup("To {}: <code>{}</code>").format(where, uses(folder.name, model)[0])
        for where, model in commands.items()
        if model
    ]
    name, _, because = reason.partition(". ")
    first = paragraph(Markup("<b>{}{}.</b> {} {}").format(name[:1].upper(), name[1:], because, at_inverse))
    return together([first, paragraph(Markup("<br>").join(ways))])


def left_out_of(runs: Sequence[str]) -> Markup:
    """The command that says what the simulator leaves out of some runs; empty of none.

    The verdict itself would make another page wherever a diagnosis lies beside it.
    """
    if not runs:
        return Markup("")
    folders = " ".join(shlex.quote(f"raw/{run}") for run in runs[:NAMED])
    more = f" (and {len(runs) - NAMED} more runs)" if len(runs) > NAMED else ""
    command = f"python -m pipeline.diagnose {folders} --out reports/mine"
    shape = Markup(
        "What the simulator leaves out of {}{}: <code>{}</code> writes it into reports/mine/&lt;run&gt;/verdict.txt."
        " The main job shows it on the page of all reports."
    )
    return paragraph(shape.format("this run" if len(runs) == 1 else "these runs", more, command))
