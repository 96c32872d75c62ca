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
Shapes = dict[tuple[str, int, str], float]  # by id, number and name: half the relative width of an interval


def as_entry(found: Interval) -> dict[str, float]:
    """A value with its 90 % interval, as an entry."""
    return {"value": found.value, "low": found.low, "high": found.high}


def effect_of(problem: Problem, state: State, act: Act) -> Array:
    """The prediction with an act less the prediction without it, all else held.

    Shape (samples,), in the reading's unit.
    """
    rest = State(state.values, state.zeros, tuple(other for other in state.acts if other is not act))
    return problem.simulate(state) - problem.simulate(rest)


def parameters_of(
    problem: Problem, act: Act, relative: tuple[float, float], shapes: Shapes
) -> dict[str, dict[str, Any]]:
    """Parameters of an act by name, with 90 % intervals and units; strengths are as uncertain as the effect's size."""
    said, found = problem.drivers.units, {}
    for number, entry in enumerate(entries((act,), problem.drivers)):
        terms = problem.terms(mechanisms()[act.id], act.shapes[number])
        units = {said.name(term.name): said.unit(term.unit) for term in terms}
        sums = totals(terms, entry["parameters"], said)
        units |= {name: unit for name, (_, unit) in sums.items()}
        own = {said.name(name): name for name in act.shapes[number]}
        for name, value in (entry["parameters"] | {name: value for name, (value, _) in sums.items()}).items():
            half = shapes.get((act.id, number, own.get(name, name)), 0.0)  # none where it was chosen from a few
            low, high = sorted(value * factor for factor in (relative if name in units else (1.0 - half, 1.0 + half)))
            shape = own.get(name, name)
            unit = units.get(name, said.unit(mechanisms()[act.id].units.get(shape, unit_of_shape(shape))))
            label = name if number == 0 else f"{name}_{number + 1}"
            found[label] = {"value": value, "low": low, "high": high, "unit": unit}
    return found


def listed(found: Study, fine: Problem, sizes: dict[str, Interval], shapes: Shapes, unit: str) -> list[dict[str, Any]]:
    """All that is named; `fine` is the problem at the recording's own rate, `unit` the ending of the channel."""
    problem, entries_ = found.problem, []
    for act in found.best.acts:
        if act in problem.included:
            continue
        effect = effect_of(problem, found.best, act)
        if act.id in found.random:
            effect = chance.trace(problem, found.best, found.floor)
            size = Interval(*(found.random_rms * end for end in (1.0, *RANDOM_ENDS)))
        else:
            own_rate = rms(effect_of(fine, found.best, act)) / (rms(effect) or 1.0)
            size = Interval(*(own_rate * end for end in (sizes[act.id].value, sizes[act.id].low, sizes[act.id].high)))
        relative = (size.low / size.value, size.high / size.value) if size.value else (1.0, 1.0)
        entries_.append(
            {
                "id": act.id,
                "confidence": confidence(found, act.id),
                f"rms_{unit}": as_entry(size),
                "parameters": parameters_of(problem, act, relative, shapes),
                "location": locate.box(effect, problem),
            }
        )
    return entries_


def totals(terms: list[Term], parameters: dict[str, float], said: Units) -> dict[str, tuple[float, str]]:
    """Sums of the coefficients that share a `total`, with their units, where more than one is at work."""
    found: dict[str, list[tuple[float, str]]] = {}
    for term in terms:
        name = said.name(term.name)
        if term.total and name in parameters:
            found.setdefault(said.name(term.total), []).append((parameters[name], said.unit(term.unit)))
    return {name: (sum(value for value, _ in parts), parts[0][1]) for name, parts in found.items()}


def unit_of_shape(name: str) -> str:
    """Unit of a shape's value, from its name."""
    endings = {"_turns_per_s": "turns/s", "_s": "s", "_mm": "mm", "_turns": "turns", "_hz": "Hz"}
    return next((unit for ending, unit in endings.items() if name.endswith(ending)), "1")


def confidence(found: Study, id_: str) -> float:
    """How likely the mechanism is at work: the judge's probability; 1 where its every move is chance and was seen."""
    return 1.0 if id_ in found.random else float(np.clip(found.judged.confidence(id_), 0.0, 1.0))
