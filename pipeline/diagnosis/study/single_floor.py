"""The noise of single samples, where a rig is scored in averages but `simulate` and `adopt` count single samples."""

import math

from ..choice.outcome import Study, rms
from ..fit.problem import Problem
from ..numerics.noise import robust
from ..recording.recorded_run import RecordedRun
from .own_rate import SCORED_SAMPLES, at_own_rate, samples_of


def single_floor(study: Study, fine: Problem, recorded: list[RecordedRun], floor: float) -> dict[str, float]:
    """`scored_step_s`, the time over which `fine` averages, and `single_floor_…`, both for the `evidence`.

    `floor` is the noise of `fine`, in the reading's unit. Empty where `fine` holds the single samples.
    `single_floor_…` is left out where the samples are too many to simulate at once. It is also left out where a system
    follows derivatives: averages count everywhere there, as a noisy motion spoils single predictions.
    """
    count, ending = samples_of(recorded), study.problem.system.channel.rpartition("_")[2]
    if study.problem.system.working_hz is None or len(fine.record) == count:
        return {}
    evidence: dict[str, float] = {"scored_step_s": fine.drivers.step_s}
    if count > SCORED_SAMPLES or study.problem.system.differentiates:
        return evidence
    single = at_own_rate(recorded, thin=False, to_fit=False)
    robust_rms = [rms(robust(each.measured - each.simulate(study.best))) for each in (single, fine)]
    taken_off = math.sqrt(max(robust_rms[0] ** 2 - robust_rms[1] ** 2, 0.0))
    return evidence | {f"single_floor_{ending}": math.hypot(floor, taken_off)}
