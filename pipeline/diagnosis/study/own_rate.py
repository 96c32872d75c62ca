"""A recording at its own rate: for simulation, for scoring errors, and for refitting explanations."""

from ..fit.problem import Problem
from ..recording.recorded_run import RecordedRun
from .engine import make_problem

POLISHED_SAMPLES = 100_000  # that an explanation is refitted to: a longer recording is averaged to so many
SCORED_SAMPLES = 1_000_000  # that an error is told from


def at_own_rate(recorded: list[RecordedRun], thin: bool = True, to_fit: bool = True) -> Problem:
    """The problem at the recording's own rate, for simulation only; `thin`: at most at the system's working rate.

    Unless `to_fit`, the motion may be too short to be diagnosed: one stroke will do.
    """
    return make_problem(recorded, most=samples_of(recorded), thin=thin, to_fit=to_fit)


def to_score(recorded: list[RecordedRun]) -> Problem:
    """The problem that an error is scored on: the recording's own samples, of a very long one every nth.

    Where a system follows derivatives, the samples are averaged to its working rate, and none is left out.
    """
    step = 1 if recorded[0].run.system.differentiates else -(-samples_of(recorded) // SCORED_SAMPLES)
    return at_own_rate(recorded if step < 2 else [each.each(step) for each in recorded])


def to_polish(recorded: list[RecordedRun], fine: Problem) -> Problem:
    """The problem that an explanation is refitted to: `fine`, at the recording's own rate; averages if it is long."""
    return fine if len(fine.record) <= POLISHED_SAMPLES else make_problem(recorded, most=POLISHED_SAMPLES)


def samples_of(recorded: list[RecordedRun]) -> int:
    """How many samples the runs have in all."""
    return sum(len(each.samples) for each in recorded)
