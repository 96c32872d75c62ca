"""The named mechanisms, each with its size, parameters and place, as `diagnosis.json` lists them."""

import numpy as np

from ...ground.kinematics import Array
from ..choice import chance
from ..choice.outcome import Study, rms
from ..document import made_keys
from ..document.effects_named import Loop, MechanismEntry, Quantity
from ..fit import locate
from ..fit.adopt import entries
from ..fit.intervals import Interval, Intervals
from ..fit.problem import Act, Problem, State
from ..mechanisms.interface import Term
from ..mechanisms.library import mechanisms
from ..recording.drivers import Drivers
from ..recording.system_units import Units
from . import loops

RANDOM_ENDS = (0.85, 1.15)  # of the size of a random effect, which is what fits and floor leave
EVENT = "at_s"  # the time at which something happens suddenly
HALF_LOOP = "half_loop_mm"  # of the sums, the one that is the same at every load
HalfWidths = dict[tuple[str, int, str], float]  # by id, number and name: half the relative width of an interval


def as_entry(interval: Interval) -> made_keys.Interval:
    """A value with its 90 % interval, as an entry."""
    return {"value": interval.value, "low": interval.low, "high": interval.high}


def effect_of(problem: Problem, state: State, act: Act) -> Array:
    """The prediction with an act less the prediction without it, all else held.

    Shape (samples,), in the reading's unit.
    """
    rest = State(state.values, state.zeros, tuple(other for other in state.acts if other is not act))
    return problem.simulate(state) - problem.simulate(rest)


def parameters_of(
    problem: Problem, act: Act, relative: tuple[float, float], half_widths: HalfWidths, half_loop: float | None = None
) -> dict[str, Quantity]:
    """Parameters of an act by name, with 90 % intervals and units; strengths are as uncertain as the effect's size.

    `half_loop`, in the reading's unit, stands in the place of sums that are a part of the loop alone.
    """
    names, parameters = problem.drivers.units, dict[str, Quantity]()
    for number, entry in enumerate(entries((act,), problem.drivers)):
        terms = problem.terms(mechanisms()[act.id], act.nonlinear[number])
        units = {names.name(term.name): names.unit(term.unit) for term in terms}
        sums = totals(terms, entry["parameters"], names, half_loop)
        coefficients = {term.name: entry["parameters"].get(names.name(term.name), 0.0) for term in terms}
        for name, derive in mechanisms()[act.id].derived.items():
            value = derive(coefficients | act.nonlinear[number])
            if value:
                sums[names.name(name)] = (value, names.unit(unit_of_nonlinear(name)))
        units |= {name: unit for name, (_, unit) in sums.items()}
        own = {names.name(name): name for name in act.nonlinear[number]}
        for name, value in (entry["parameters"] | {name: value for name, (value, _) in sums.items()}).items():
            half = half_widths.get((act.id, number, own.get(name, name)), 0.0)  # none where it was chosen from a few
            low, high = sorted(value * factor for factor in (relative if name in units else (1.0 - half, 1.0 + half)))
            nonlinear = own.get(name, name)
            if nonlinear == EVENT and value >= 0.0:
                begin, end = recorded_about(problem.drivers, value)
                low, high = min(max(low, begin), value), max(min(high, end), value)
            unit = units.get(name, names.unit(mechanisms()[act.id].units.get(nonlinear, unit_of_nonlinear(nonlinear))))
            label = name if number == 0 else f"{name}_{number + 1}"
            parameters[label] = {"value": value, "low": low, "high": high, "unit": unit}
    return parameters


def listed(study: Study, fine: Problem, bands: Intervals, unit: str) -> list[MechanismEntry]:
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
            own = bands.sizes[act.id]
            size = Interval(*(own_rate * end for end in (own.value, own.low, own.high)))
        loop = loops.widest(problem, effect)
        relative = (size.low / size.value, size.high / size.value) if size.value else (1.0, 1.0)
        half_loop = loop.width / 2 if loop else None
        entry: MechanismEntry = {
            "id": act.id,
            "confidence": confidence(study, act.id),
            "parameters": parameters_of(problem, act, relative, bands.half_widths, half_loop),
            "location": locate.box(effect, problem),
        }
        entries_.append(made_keys.with_made(entry, {f"rms_{unit}": as_entry(size)}, "parameters"))
    return entries_


def named_effects(study: Study) -> dict[str, Array]:
    """What each named mechanism does to the reading, by id; random effects are left out.

    Each of shape (samples,), in the reading's unit.
    """
    problem, best = study.problem, study.best
    acts = [act for act in best.acts if act not in problem.included and act.id not in study.random]
    return {act.id: effect_of(problem, best, act) for act in acts}


def opened(problem: Problem, effects: dict[str, Array], reading: str, driver: str) -> dict[str, Loop]:
    """The loop of each effect that has one, by id: its width as `reading`, and where it is, as `driver`.

    `by_load`: where strokes were made under several loads, the lowest and the highest, with the width under each.
    Each effect has the shape (samples,), in the reading's unit.
    """
    open_by_id: dict[str, Loop] = {}
    for id_, effect in effects.items():
        loop = loops.widest(problem, effect)
        if loop:
            by_load: Loop = {"by_load": [list(pair) for pair in loop.by_load]} if loop.by_load else {}
            open_by_id[id_] = made_keys.with_made(by_load, {reading: loop.width, driver: loop.motion}, "by_load")
    return open_by_id


def recorded_about(drivers: Drivers, at_s: float) -> tuple[float, float]:
    """Begin and end, in s, of the run that holds a time: nothing is known of the time between runs."""
    run = int(np.searchsorted(drivers.elapsed_s[drivers.breaks], at_s, side="right"))
    ends = [0, *drivers.breaks, len(drivers.elapsed_s)]
    return float(drivers.elapsed_s[ends[run]]), float(drivers.elapsed_s[ends[run + 1] - 1])


def totals(
    terms: list[Term], parameters: dict[str, float], names: Units, half_loop: float | None = None
) -> dict[str, tuple[float, str]]:
    """Sums of the coefficients that share a `total`, with their units.

    Where a term without a total is at work beside them the sums are parts of the loop alone: none is given. Where more
    than this one sum is at work the one that is the same everywhere gives way to `half_loop`, in the reading's unit.
    """
    at_work = [term for term in terms if names.name(term.name) in parameters]
    sums: dict[str, tuple[float, str]] = {}
    if all(term.total for term in at_work):
        for term in at_work:
            name, coefficient = names.name(term.total or ""), parameters[names.name(term.name)]
            sums[name] = (sums.get(name, (0.0, ""))[0] + coefficient, names.unit(term.unit))
    if len(sums) == 1:
        return sums
    if half_loop and HALF_LOOP in [term.total for term in terms]:
        sums[names.name(HALF_LOOP)] = (half_loop, names.reading)
    else:
        sums.pop(names.name(HALF_LOOP), None)
    return sums


def unit_of_nonlinear(name: str) -> str:
    """Unit of a nonlinear parameter, from its name."""
    endings = {"_turns_per_s": "turns/s", "_s": "s", "_mm": "mm", "_turns": "turns", "_hz": "Hz"}
    return next((unit for ending, unit in endings.items() if name.endswith(ending)), "1")


def confidence(study: Study, id_: str) -> float:
    """How likely the mechanism is at work: the judge's probability; 1 for a random effect that was seen."""
    return 1.0 if id_ in study.random else float(np.clip(study.judged.confidence(id_), 0.0, 1.0))
