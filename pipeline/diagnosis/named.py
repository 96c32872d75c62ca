"""What is named: each mechanism at work with its size, parameters and place, as `diagnosis.json` lists it."""

from typing import Any

import numpy as np

from ..ground.kinematics import Array
from . import chance, locate
from .adopt import entries
from .interface import Term
from .intervals import Interval
from .library import mechanisms
from .naming import Units
from .outcome import Study, rms
from .problem import Act, Problem, State

RANDOM_ENDS = (0.85, 1.15)  # of the size of a random effect, which is what fits and floor leave
HalfWidths = dict[tuple[str, int, str], float]  # by id, number and name: half the relative width of an interval


def as_entry(interval: Interval) -> dict[str, float]:
    """A value with its 90 % interval, as an entry."""
    return {"value": interval.value, "low": interval.low, "high": interval.high}


def effect_of(problem: Problem, state: State, act: Act) -> Array:
    """The prediction with an act less the prediction without it, all else held.

    Shape (samples,), in the reading's unit.
    """
    rest = State(state.values, state.zeros, tuple(other for other in state.acts if other is not act))
    return problem.simulate(state) - problem.simulate(rest)


def parameters_of(
    problem: Problem, act: Act, relative: tuple[float, float], half_widths: HalfWidths
) -> dict[str, dict[str, Any]]:
    """Parameters of an act by name, with 90 % intervals and units; strengths are as uncertain as the effect's size."""
    names, parameters = problem.drivers.units, {}
    for number, entry in enumerate(entries((act,), problem.drivers)):
        terms = problem.terms(mechanisms()[act.id], act.shapes[number])
        units = {names.name(term.name): names.unit(term.unit) for term in terms}
        sums = totals(terms, entry["parameters"], names)
        units |= {name: unit for name, (_, unit) in sums.items()}
        own = {names.name(name): name for name in act.shapes[number]}
        for name, value in (entry["parameters"] | {name: value for name, (value, _) in sums.items()}).items():
            half = half_widths.get((act.id, number, own.get(name, name)), 0.0)  # none where it was chosen from a few
            low, high = sorted(value * factor for factor in (relative if name in units else (1.0 - half, 1.0 + half)))
            nonlinear = own.get(name, name)
            unit = units.get(name, names.unit(mechanisms()[act.id].units.get(nonlinear, unit_of_nonlinear(nonlinear))))
            label = name if number == 0 else f"{name}_{number + 1}"
            parameters[label] = {"value": value, "low": low, "high": high, "unit": unit}
    return parameters


def listed(
    study: Study, fine: Problem, sizes: dict[str, Interval], half_widths: HalfWidths, unit: str
) -> list[dict[str, Any]]:
    """All that is named; `fine` is the problem at the recording's own rate, `unit` the ending of the channel."""
    problem, entries_ = study.problem, []
    for act in study.best.acts:
        if act in problem.included:
            continue
        effect = effect_of(problem, study.best, act)
        if act.id in study.random:
            effect = chance.trace(problem, study.best, study.floor)
            size = Interval(*(study.random_rms * end for end in (1.0, *RANDOM_ENDS)))
        else:
            own_rate = rms(effect_of(fine, study.best, act)) / (rms(effect) or 1.0)
            size = Interval(*(own_rate * end for end in (sizes[act.id].value, sizes[act.id].low, sizes[act.id].high)))
        relative = (size.low / size.value, size.high / size.value) if size.value else (1.0, 1.0)
        entries_.append(
            {
                "id": act.id,
                "confidence": confidence(study, act.id),
                f"rms_{unit}": as_entry(size),
                "parameters": parameters_of(problem, act, relative, half_widths),
                "location": locate.box(effect, problem),
            }
        )
    return entries_


def totals(terms: list[Term], parameters: dict[str, float], names: Units) -> dict[str, tuple[float, str]]:
    """Sums of the coefficients that share a `total`, with their units, where more than one is at work."""
    parts_by_total: dict[str, list[tuple[float, str]]] = {}
    for term in terms:
        name = names.name(term.name)
        if term.total and name in parameters:
            parts_by_total.setdefault(names.name(term.total), []).append((parameters[name], names.unit(term.unit)))
    return {name: (sum(value for value, _ in parts), parts[0][1]) for name, parts in parts_by_total.items()}


def unit_of_nonlinear(name: str) -> str:
    """Unit of a nonlinear parameter, from its name."""
    endings = {"_turns_per_s": "turns/s", "_s": "s", "_mm": "mm", "_turns": "turns", "_hz": "Hz"}
    return next((unit for ending, unit in endings.items() if name.endswith(ending)), "1")


def confidence(study: Study, id_: str) -> float:
    """How likely the mechanism is at work: the judge's probability; 1 where its every move is chance and was seen."""
    return 1.0 if id_ in study.random else float(np.clip(study.judged.confidence(id_), 0.0, 1.0))
