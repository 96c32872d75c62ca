"""A study whose simulator is fitted again to the recording at its own rate, and trusts it only as far as it should."""

from dataclasses import replace

from ..choice.outcome import Study
from ..fit import calibrate
from ..fit.problem import Problem
from .engine import noise_of
from .tempered import tempered


def polished(studied: Study, fine: Problem) -> Study:
    """The study with its simulator refitted to the problem from `to_polish`, and tempered."""
    own = studied.problem  # a zero of the motor that the study held stays, and so does a stand-in
    fine = replace(fine, parameters=own.parameters, included=own.included, beside=own.beside)
    return tempered(_refitted(studied, fine), fine)


def _refitted(studied: Study, fine: Problem) -> Study:
    """The study with its explanation refitted to the problem from `to_polish`, since averaging flattens ripples."""
    acts = tuple(act for act in studied.best.acts if act not in fine.included and act.id not in studied.random)
    if not acts or len(fine.record) == len(studied.problem.record):
        return studied
    fine, _ = calibrate.without_outliers(fine, studied.best)
    noise = noise_of(fine, studied.best)
    best = calibrate.calibrate(fine, noise, studied.best, acts)
    best = replace(best, acts=(*best.acts, *(act for act in studied.best.acts if act.id in studied.random)))
    closest = best if studied.closest is studied.best else studied.closest
    return replace(studied, best=best, state=best if studied.state is studied.best else studied.state, closest=closest)
