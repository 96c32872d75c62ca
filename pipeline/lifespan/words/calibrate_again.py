"""How to calibrate a model again on a string's newest strokes: the command to paste, and the next step."""

import shlex
from collections.abc import Sequence
from pathlib import Path

from ...ground.command import INSTALLED, command
from ...ground.model_names import USUAL
from ..forecast.strokes_left import LEAST_STROKES

AFTERWARDS = (
    f"After a calibration name only the runs recorded since: a forecast of them needs {LEAST_STROKES} strokes again."
)


def calibrate_by(material: str, runs: Sequence[Path], out: Path) -> list[str]:
    """Which program fits a model to a string's runs, and, on a line of its own, the command.

    In raw/ of a checkout it is the workflow's; elsewhere a diagnosis calibrates the dimensions of the simulator.
    """
    in_raw = not INSTALLED and all(run.resolve().parent == Path("raw").resolve() for run in runs)
    if in_raw:
        model = f"processed/{material}/{USUAL}/within-0.model"
        fit = f"snakemake --cores 2 -- {shlex.quote(model)}"
        what = f"it fits the {USUAL} of {material} to all of its runs in raw/"
        return [f"Calibrate it by this command ({what}):", f"  {fit}"]
    named = " ".join(shlex.quote(str(run)) for run in runs)
    together = " --together" if len(runs) > 1 else ""
    fit = f"{command('diagnose')} {named}{together} --out {shlex.quote(str(out / 'calibrated'))}"
    return ["Calibrate it by this command (it calibrates the simulator's dimensions on these runs):", f"  {fit}"]
