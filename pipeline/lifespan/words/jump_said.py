"""A jump within a run in words: by how much, at which stroke, that it is no wear, and the command that names it."""

import shlex
from collections.abc import Sequence
from pathlib import Path

from ...ground.command import command
from ..stroke_health.health import Health
from ..stroke_health.reading_jump import JUMPING, Step, steps

MANY = 1000.0  # times the noise: more is not counted


def jump_lines(health: Health, folders: Sequence[Path], out: Path) -> list[str]:
    """What each jump is, and, on a line of its own, the command that diagnoses its run; none where nothing jumped.

    `folders` are those of the string's runs, `out` the folder of the answer.
    """
    rests, tops = (steps(health.strokes, name) for name in JUMPING)
    lines = [*(_at_rest(step) for step in rests), *(_of_stroke(step) for step in tops)]
    if not lines:
        return []
    runs = dict.fromkeys(step.run for step in (*rests, *tops))
    asked_about = [str(folder) for run in runs for folder in folders if folder.resolve().name == run]
    diagnose = f"{command('diagnose')} {shlex.join(asked_about)} --out {shlex.quote(str(out / 'jump'))}"
    return [
        *lines,
        "A jump is no wear: a clamp or the counter may have slipped. This command tells which, if it can:",
        f"  {diagnose}",
    ]


def _at_rest(step: Step) -> str:
    change = f"{'fell' if step.moved_mm < 0.0 else 'rose'} by {abs(step.moved_mm):.2g} mm at once"
    return f"Jump: at stroke {step.stroke} ({step.run}) the reading at rest {change}, {_noise(step)}."


def _of_stroke(step: Step) -> str:
    change = f"{'longer' if step.moved_mm > 0.0 else 'shorter'} by {abs(step.moved_mm):.2g} mm at once"
    between = f"from stroke {step.stroke} to {step.stroke + 1} ({step.run})"
    return f"Jump: {between} the stroke got {change}, {_noise(step)}."


def _noise(step: Step) -> str:
    many = f"{step.floors:.0f}" if step.floors < MANY else f"more than {MANY:.0f}"
    return f"{many} times the noise from stroke to stroke"
