"""The words of `simulate` on a planned motion's columns: where it leaves the recordings, its band, and ties."""

import shlex
from pathlib import Path

from ..ground.command import command
from .planned_columns import PlannedColumns
from .prediction.planned_motion import Plan, expected_error
from .simulate_options import SimulateOptions
from .words.foretold.prediction import (
    AFTER_RECORDING,
    in_one_number,
    no_band,
    of_band,
    of_half_speed,
    of_rivals,
    of_state,
    stretches,
)
from .words.foretold.residual import RESIDUAL
from .words.language.quantity import listing
from .words.language.vocabulary import Vocabulary


def of_outside(plan: Plan, path: Path | None) -> list[str]:
    """The warning that a plan, from a file, leaves the recorded range; nothing where it stays inside."""
    if not plan.outside or not plan.outside.asks:
        return []
    when = stretches(plan.outside.rows, plan.samples["time_s"].to_numpy())
    asks = f"it asks for {'. It asks for '.join(plan.outside.asks)}. Nothing says how well the simulator does "
    asks += f"there, {when}. Mend: {listing(plan.outside.mends)}, or record a stroke that does as the plan, "
    return [f"{path}: {asks}diagnose both recordings together, and predict with that"]


def of_columns(plan: Plan, planned: PlannedColumns, options: SimulateOptions) -> list[str]:
    """What is said of the columns of a plan, a sentence or two an entry."""
    called, channel = Vocabulary.of(plan.run.system), plan.run.system.channel
    unit, inside, ending = called.unit, plan.inside(), channel.rpartition("_")[2]
    expected = expected_error(planned.width, inside)
    if planned.diagnosis is None or planned.width is None:
        words = [no_band(str(planned.place), shlex.quote(str(options.run_dir)), options.simulation is None)]
    else:
        gaps = [curve - plan.predicted for curve in planned.rivals.values()]
        words = in_one_number(planned.width, inside, gaps, len(plan.tied), channel, unit)
        words += of_band(planned.width, inside, f"low_{ending}", f"high_{ending}", called)
        words += of_rivals(plan.predicted, planned.rivals, inside, channel, unit)
        slow = plan.outside.too_slow_below if plan.outside else 0.0
        words += of_half_speed(planned.diagnosis, slow, ending, plan.problem.drivers.units.motion, unit)
    gap = plan.changed_by_recording(expected)
    return [*words, *([] if gap is None else [of_state(gap, expected, called, _after_recording(options))])]


def _after_recording(options: SimulateOptions) -> str:
    """The command that simulates the same plan after the recorded motion."""
    words = [str(options.run_dir), *(["--simulation", str(options.simulation)] if options.simulation else [])]
    words += ["--motion", str(options.motion), AFTER_RECORDING, *([RESIDUAL] if options.residual else [])]
    return f"{command('simulate')} {shlex.join([*words, '--out', str(options.out)])}"
