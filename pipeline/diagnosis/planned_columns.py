"""The columns of a planned motion beside its reading: without effects, the band, and the tied explanations."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..ground.kinematics import Array
from .document.content import Verdict
from .prediction.planned_motion import Plan
from .prediction.prediction_band import Foretold
from .simulator import Simulator
from .words.foretold.prediction import OUTSIDE, column_of


@dataclass(frozen=True)
class PlannedColumns:
    """The columns of a plan by name, each of shape (samples,) in its unit, and the objects they are made from.

    `diagnosis` is the one that foretells the error, in the file `place`; None where there is none. `width` is the error
    that it foretells, None where it does not; then there is no band. `rivals` are the readings of the explanations that
    tie, by their mechanisms.
    """

    columns: dict[str, Array]
    diagnosis: Verdict | None
    place: Path
    width: Foretold | None
    rivals: dict[str, Array]


def planned_columns(plan: Plan, simulator: Simulator) -> PlannedColumns:
    """The columns of a planned motion beside its reading; raises BadInput for an unusable diagnosis.json."""
    channel = plan.run.system.channel
    ending = channel.rpartition("_")[2]
    columns = {OUTSIDE: (~plan.inside()).astype(float)} if plan.outside else {}
    columns[f"without_effects_{ending}"] = plan.without_effects
    place, diagnosis = simulator.diagnosis(plan.run)
    width = plan.band(diagnosis, place) if diagnosis else None
    if diagnosis is None or width is None:
        return PlannedColumns(columns, diagnosis, place, None, {})
    half, rivals = np.where(plan.inside(), width.half_width, np.nan), plan.curves(diagnosis, place)
    band = {f"low_{ending}": plan.predicted - half, f"high_{ending}": plan.predicted + half}
    tied = {column_of(ids, channel): curve for ids, curve in rivals.items()}
    return PlannedColumns(band | columns | tied, diagnosis, place, width, rivals)
