"""Held out: the whole procedure without the last 30 % of strokes, then simulated through them.

Source: Hampel, "The influence curve and its role in robust estimation", Journal of the American Statistical Association
69, 1974 (the median of distances as their spread); Gasser, Sroka and Jennen-Steinmetz, "Residual variance and residual
pattern in nonlinear regression", Biometrika 73, 1986 (noise from second differences).
"""

from typing import Literal, NotRequired, TypedDict

import numpy as np
from numpy.typing import NDArray

from ...ground.kinematics import Array
from ..choice.outcome import Study, rms
from ..document.effects_named import Location
from ..fit.flexible import foretold
from ..fit.problem import Problem, State
from ..recording.working_samples import Record, wild
from .engine import fine_floor, study
from .polish import polished
from .rivals import refitted

WORSE = 1.02  # times the other error: less may be chance
LAST = 0.3  # of the strokes, held out at the end
TARE_S = 1.0  # at its beginning, over which the zero of a run is taken that no fit has seen
LEFT = 1.3  # times the noise: above it a regression without physics is asked
LEAST_TRAINING = 0.4  # of the samples: least part that must remain to learn from


class Left(TypedDict):
    """Where a regression without physics still finds something, and which driver that follows."""

    location: Location  # as `locate.box` says it
    driver: str


class Tied(TypedDict):
    """An explanation that was likely beside the best one without the last strokes, and its error on these."""

    ids: list[str]
    explained: float  # rms in the channel's unit
    state: State  # it has not seen those strokes


class Errors(TypedDict):
    """Errors on strokes that no fit has seen, rms in the channel's unit, of each simulator; and which strokes."""

    split: str
    nominal: float
    calibrated: float
    explained: float
    without_physics: NotRequired[float]  # with what a regression adds, where it was asked
    left: NotRequired[Left]
    chosen: list[str]  # effects that the procedure named without those strokes
    closest: list[str]  # effects of which the error is though it named none of them; those of `Study.closest`
    state: State  # the explained simulator that has not seen those strokes
    until_s: float  # where they begin, on the clock of the joined runs
    tied: list[Tied]  # the other explanations that were likely without those strokes
    decided: NotRequired[list[list[str]]]  # where those strokes decided: the others that were likely without them


FITTED: tuple[Literal["calibrated", "explained"], ...] = ("calibrated", "explained")


def worse_than_nominal(errors: Errors) -> list[str]:
    """The simulators, calibrated or explained, that are worse than the nominal one on unseen strokes."""
    return [name for name in FITTED if errors[name] > WORSE * errors["nominal"]]


def first_held_out(problem: Problem) -> int | None:
    """First sample of the last 30 % of strokes (at least one), or None when too little is left to learn from."""
    strokes = np.unique(problem.record.stroke)
    strokes = strokes[strokes > 0]
    count = max(1, round(LAST * len(strokes)))
    if len(strokes) - count < 1:
        return None
    row = int(np.argmax(problem.record.stroke >= strokes[-count]))
    return row if row >= LEAST_TRAINING * len(problem.record) else None


def decided(errors: Errors, named: list[str]) -> Errors:
    """The errors of what all strokes name, where it was likely without the last ones too: these decided then.

    A run that is made to decide between explanations comes last, and contradicts none of them.
    """
    of_named = [tied for tied in errors["tied"] if set(tied["ids"]) == set(named)]
    if not of_named or set(errors["chosen"]) == set(named):
        return errors
    others = [errors["chosen"], *(tied["ids"] for tied in errors["tied"] if tied is not of_named[0])]
    return {
        "split": errors["split"],
        "nominal": errors["nominal"],
        "calibrated": errors["calibrated"],
        "explained": of_named[0]["explained"],
        "chosen": named,
        "closest": [],
        "state": of_named[0]["state"],
        "until_s": errors["until_s"],
        "tied": errors["tied"],
        "decided": others,
    }


def quick(fine: Problem, state: State, rows: NDArray[np.bool_]) -> float:
    """Noise from one sample to the next, rms: slower structure does not count as noise.

    In the reading's unit; `rows` is a mask of shape (samples,).
    """
    bends = np.diff((fine.measured - fine.simulate(state))[rows], n=2)  # of white noise the root of 6 as large
    return float(1.4826 * np.median(np.abs(bends)) / np.sqrt(6.0))


def runs_of(record: Record, until_s: float) -> list[int]:
    """Numbers of the runs, from 0, that have strokes which are held out: those from `until_s` on, on their clock."""
    return [int(number) for number in np.unique(record.run_index[record.time_s >= until_s])]


def held_out(problem: Problem, fine: Problem, to_polish: Problem) -> tuple[Errors | None, Study | None]:
    """Errors (rms) on strokes that no fit has seen: nominal, calibrated, explained; and the study they came from.

    `fine` is the same recording at its own rate, on which the errors are measured, lonely wild readings left out;
    `to_polish` is the one that the explanation is refitted to.
    """
    row = first_held_out(problem)
    if row is None:
        return None, None
    unseen, polish_unseen = (sampled.record.time_s >= problem.record.time_s[row] for sampled in (fine, to_polish))
    studied = polished(study(problem.until(row)), to_polish.until(int(np.argmax(polish_unseen))))

    def error(state: State, added: Array | float = 0.0) -> float:
        residual = fine.measured - fine.simulate(state) - added
        for number in range(fine.runs if fine.system.free_zero else 0):
            own = fine.record.run_index == number
            if unseen[own].all():  # of a run that no fit has seen, nobody knows the zero
                time_s = fine.record.time_s[own]
                residual[own] -= np.median(residual[own][time_s - time_s[0] <= TARE_S])
        return rms(residual[unseen & ~wild(residual)[0]])

    errors: Errors = {
        "split": "last 30 % of strokes",
        "nominal": error(studied.nominal),
        "calibrated": error(studied.base),
        "explained": error(studied.simulator),
        "chosen": [act.id for act in studied.state.acts if act not in studied.problem.included],
        "closest": list(studied.best_ids) if studied.closest else [],
        "state": studied.simulator,
        "until_s": float(problem.record.time_s[row]),
        "tied": [],
    }
    for explanation in studied.sets[1:] if studied.verdict == "ambiguous" else []:
        state = refitted(studied, explanation)
        errors["tied"].append({"ids": list(explanation.ids), "explained": error(state), "state": state})
    if errors["explained"] > LEFT * min(fine_floor(fine, studied), quick(fine, studied.simulator, unseen)):
        later = problem.record.time_s >= problem.record.time_s[row]
        states = [studied.base] if studied.simulator is studied.base else [studied.base, studied.simulator]
        tried = [foretold(problem, fine, state, later) for state in states]
        sizes = [error(state, without.added) for state, without in zip(states, tried, strict=True)]
        without = tried[int(np.argmin(sizes))]
        errors["without_physics"] = min(sizes)
        errors["left"] = {"location": without.location, "driver": without.driver}
    return errors, studied
