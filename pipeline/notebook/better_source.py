"""What the equations know of a load, how they and a model err, and what knows more than they do: the simulator."""

from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path

import pandas as pd

from ..ground.command import command, quoted
from ..ground.errors import BadInput
from ..ground.model_errors import Errors
from ..models.parts.saved_files import RAW, material_of
from ..run.folder import read_run

THINNER = "The equations know of a load that it makes the string thinner, and they know no stretch"
HELD_OUT = "on held-out points, under recorded loads, {model} errs by {its:.2g} mm, {equations} by {theirs:.2g} mm"
KNOWS = "A stretch that a diagnosis has named is known to the simulator"
PLANNED = "--motion PLAN.csv --out FILE.csv"  # as the page of an adopted diagnosis has it
ANY = "RUN"  # the folder of the run, where none of the string's has adopted effects


@dataclass(frozen=True)
class Beside:
    """What stands beside answers: errors of models in mm, of the material's page, and the run folder to simulate.

    It is the folder of a run of the strings asked about whose run.yaml has adopted effects, None where there is none.
    """

    errors_mm: Errors
    adopted: Path | None

    def of_equations(self, model: str, equations: str) -> str:
        """What the equations know of a load and, where the page has both, the held-out errors of both models."""
        its, theirs = self.errors_mm.get((model, "within")), self.errors_mm.get((equations, "within"))
        if its is None or theirs is None:
            return f"{THINNER}."
        return f"{THINNER}; {HELD_OUT.format(model=model, its=its, equations=equations, theirs=theirs)}."

    @property
    def of_simulator(self) -> str:
        """What the simulator knows of a load, and the command that asks it of a planned motion."""
        folder, once = (quoted(str(self.adopted)), "") if self.adopted else (ANY, ", once it is adopted")
        return f"{KNOWS}{once}: {command('simulate')} {folder} {PLANNED}"


def adopted_run(path: Path, dataset: pd.DataFrame, strings: Collection[str]) -> Path | None:
    """The first run folder of one of the strings whose run.yaml has adopted effects; None where there is none.

    `path` is that of the `dataset`, beside whose `processed/` the recordings lie.
    """
    if not material_of(path):
        return None
    raw = path.resolve().parents[2] / RAW
    raw = RAW if raw == RAW.resolve() else raw
    for run in sorted(set(dataset["run"][dataset["string"].astype(str).isin(strings)].astype(str))):
        try:
            if read_run(raw / run).adopted:
                return raw / run
        except (BadInput, OSError):
            continue
    return None
