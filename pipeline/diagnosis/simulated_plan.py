"""A motion that is planned for a run, with its simulator: a table of time and motion → `Plan`."""

from collections.abc import Sequence
from pathlib import Path

import pandas as pd

from ..run.description import Run
from ..run.planned_motion.planned import planned
from ..run.table.file_lines import Where, by_row
from .prediction.later_run import before_of
from .prediction.planned_motion import Plan, recorded_beside, tied_with
from .recording.recorded_run import RecordedRun
from .simulator import Simulator


def simulated_plan(
    run: Run, folder: Path, recorded: RecordedRun | None, simulator: Simulator, motion: pd.DataFrame, path: Path,
    after: bool = False, at_hand: Sequence[RecordedRun] | None = None, where: Where = by_row,
) -> Plan:  # fmt: skip
    """The plan that a table of a motion gives for a run, which messages call `path`.

    `recorded` is the recording of the run in `folder`, if it has one; `after`: it goes before the plan. `at_hand`:
    the other recordings of its diagnosis; None where they lie beside its folder. `where` says where a row of the motion
    stands. Raises BadInput for a table that is no motion of this rig.
    """
    samples, drawn = planned(run, motion, path, recorded and recorded.samples, where)
    content, adopted = simulator.content, simulator.given is None
    tied = tied_with(run, content, adopted)
    beside = at_hand
    if beside is None:
        beside = recorded_beside(folder, run, content, adopted) if recorded else []
    together = run.adopted[-1].runs if run.adopted and adopted else content.get("run")
    before = before_of({**content, "run": together or run.run}, run.run, beside)
    return Plan(run, samples, drawn, recorded, content, simulator.source, after, tied, beside, before)
