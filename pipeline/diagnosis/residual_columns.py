"""What a black box adds to a simulated motion, as columns of the answer, and what is said of it."""

import shlex
from collections.abc import Sequence
from pathlib import Path

from ..ground.command import command
from ..ground.errors import BadInput
from ..ground.kinematics import Array
from ..run.description import Run
from .fit.problem import Problem
from .prediction.planned_motion import Plan
from .prediction.prediction_band import adopted_diagnosis
from .prediction.residual import residual
from .recording.made_of import recordings_of
from .recording.recorded_run import RecordedRun
from .simulator import Simulator
from .words.foretold.residual import RESIDUAL, columns_of, of_residual


def black_box(
    problem: Problem,
    run: Run,
    plan: Plan | None,
    folder: Path,
    simulator: Simulator,
    read_already: Sequence[RecordedRun] = (),
) -> tuple[dict[str, Array], list[str]]:
    """Columns of a black box beside a reading, each of shape (samples,) in its unit; and what is said of them.

    `problem` is what the simulator has simulated of a run in `folder`, of which a plan's rows are the last; what was
    `read_already` of its recordings is not read again. Raises BadInput where a diagnosis does not hold what that takes.
    """
    place, diagnosis = (simulator.source, simulator.given) if simulator.given is not None else adopted_diagnosis(run)
    again = f"{command('diagnose')} {shlex.quote(str(folder))} --out DIR"
    mend = f"diagnose again, {again}, and give its diagnosis.json by --simulation"
    if diagnosis is None:
        raise BadInput(place, RESIDUAL, "needs the diagnosis.json that was adopted, and there is none", mend)
    answer = residual(problem, diagnosis, place, recordings_of(diagnosis, place, folder, read_already), mend)
    answer = answer.within(plan.inside()) if plan else answer
    columns = dict(zip(columns_of(run.system.channel), (answer.added, answer.low, answer.high), strict=True))
    return columns, of_residual(answer, run.system.channel, problem.drivers.units.reading)
