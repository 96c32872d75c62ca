"""The entries `simulation:` of a run.yaml or a diagnosis → the acts in the simulator, and back."""

import re
import sys
from collections.abc import Sequence
from typing import Any

from ...ground.errors import BadInput
from ...ground.input.complaint import key_name, short
from ...ground.input.strict_yaml import write_yaml
from ...run.description import Included
from ..document.adopted_run import as_list
from ..document.content import Adoption, Verdict
from ..mechanisms.library import mechanisms
from ..recording.drivers import Drivers
from .problem import Act

DIGITS = 6
NO_USE = "Hardly worth making"  # what `next_experiment` says of a run that decides nothing
NOTE = {
    "simulation": "  # numbers of the library's formulas, as a diagnosis found them: not to be edited by hand",
    "adopted": "  # where they are from, and the dimensions that fit with them (scale: the sensor's gain)",
}


def entries(acts: tuple[Act, ...], drivers: Drivers) -> list[Included]:
    """One entry for each time a mechanism acts: its id, nonlinear parameters, and coefficients other than zero."""
    included: list[Included] = []
    for act in acts:
        mechanism, at = mechanisms()[act.id], 0
        for nonlinear in act.nonlinear:
            terms = mechanism.terms(drivers, nonlinear)
            values = act.coefficients[at : at + len(terms)]
            at += len(terms)
            coefficients = {term.name: value for term, value in zip(terms, values, strict=True) if value != 0.0}
            parameters = {
                drivers.units.name(name): float(f"{value:.{DIGITS}g}")
                for name, value in {**nonlinear, **coefficients}.items()
            }
            included.append({"id": act.id, "parameters": parameters})
    return included


def block(entries: Sequence[Included | Adoption], key: str = "simulation") -> str:
    """Lines for a run.yaml that hold its entries under `simulation`, or another key, ready to be pasted."""
    head, _, rest = write_yaml({key: entries}).partition("\n")
    return f"{head}{NOTE.get(key, '')}\n{rest}"


def fitted(content: Verdict, run: str) -> dict[str, dict[str, float]]:
    """The dimensions of a diagnosis for a run, by name: the values of run.yaml, and those fitted with the effects.

    A run that was diagnosed together with others may have a zero of the motor of its own, which is added; those of the
    later runs up to it stand beside it, as they are. The zero of the reading comes only with its own run.
    """
    parameters = content.get("parameters", {})
    runs = content.get("run")
    number = runs.index(run) + 1 if isinstance(runs, list) and run in runs else 0
    own, zero = f"_{number}" if number > 1 else None, f"zero_{number}_" if number else "zero"
    fitted_values = {}
    for name, entry in parameters.items() if isinstance(parameters, dict) else []:
        nominal: Any = entry.get("nominal") if isinstance(entry, dict) else None
        value: Any = entry.get("value") if isinstance(entry, dict) else None
        if (
            (name.startswith("zero") and not (name.startswith(zero) and (number or runs == run)))
            or ((later := re.search(r"_(\d+)$", name)) and not 1 < int(later[1][:DIGITS]) <= number)
            or not (is_number(nominal) and is_number(value))
        ):
            continue
        other = parameters.get(f"{name}{own}", {}) if own else {}
        more = other.get("value", 0.0) if isinstance(other, dict) else 0.0
        total = float(value) + (float(more) if is_number(more) else 0.0)
        fitted_values[name] = {"nominal": float(nominal), "fitted": float(f"{total:.{DIGITS}g}")}
    return fitted_values


def adoptions(content: Verdict, where: str, run: str = "", against: Sequence[str] = ()) -> list[Adoption]:
    """The key `adopted` of a run.yaml after a diagnosis: what was adopted before, then what it names.

    `run` is the run that adopts; `against` is what its verdict advises instead. A file that tells no verdict adds
    nothing. Raises BadInput for sets of mechanisms that are none.
    """
    before, named = content.get("adopted", []), content.get("mechanisms", [])
    if not isinstance(before, list):
        raise BadInput(where, "adopted", f"is {short(before)}, not a list", "give a diagnosis.json as it was made")
    if content.get("verdict") not in ("explained", "ambiguous") or not isinstance(named, list):
        return before
    effects: list[Any] = [entry.get("id") if isinstance(entry, dict) else None for entry in named]
    tied = content.get("alternatives", [])
    sets = [effects, *tied] if isinstance(tied, list) else [None]
    for ids in sets:
        if not isinstance(ids, list) or not all(isinstance(id_, str) and id_ in mechanisms() for id_ in ids):
            problem = f"holds {short(ids)}, which is no list of mechanisms of the library"
            raise BadInput(where, "mechanisms, alternatives", problem, "give a diagnosis.json as it was made")
    adoption: Adoption = {"effects": effects, "verdict": content["verdict"], "tied": tied}
    if against:
        adoption["against_advice"] = list(against)
    adoption["diagnosis"] = where
    runs, experiment = content.get("run"), content.get("next_experiment")
    if runs:
        adoption["runs"] = [runs] if isinstance(runs, str) else runs
    dimensions = fitted(content, run)
    if dimensions:
        adoption["dimensions"] = dimensions
    if isinstance(experiment, str) and tied:
        useless = [f"{NO_USE}: no run that was tried decides"]
        adoption["next_experiment"] = useless if NO_USE in experiment else as_list(experiment)
    return [*before, adoption]


def is_number(value: Any) -> bool:
    """Whether a value of JSON or YAML is a number that a float can hold; whole ones may have any number of digits."""
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= sys.float_info.max


def checked(entry: Any, field: str, where: str) -> tuple[str, dict[str, float]]:
    """Id and parameters of an entry; raises BadInput where it is not what a diagnosis of this library gives."""
    mend = "paste the entry as a diagnosis gives it"
    if not isinstance(entry, dict) or not set(entry) <= {"id", "parameters"}:
        raise BadInput(where, field, f"is {short(entry)}, not an id with its parameters", mend)
    id_, parameters = entry.get("id"), entry.get("parameters", {})
    if not isinstance(id_, str) or not isinstance(parameters, dict):
        raise BadInput(where, field, f"is {short(entry)}, not an id with its parameters", mend)
    if id_ not in mechanisms():
        mend = f"use one of {', '.join(mechanisms())}"
        raise BadInput(where, f"{field}.id", f"{short(id_)} is not a mechanism of the library", mend)
    for name, value in parameters.items():
        if not is_number(value):
            problem = f"is {short(value)}, not a number"
            raise BadInput(where, f"{field}.parameters.{key_name(name)}", problem, mend)
    return id_, parameters


def acts_from(content: Any, drivers: Drivers, where: str = "run.yaml") -> tuple[Act, ...]:
    """The acts that a list of entries describes; raises BadInput for anything unknown in it."""
    acts = []
    if not isinstance(content, list):
        raise BadInput(where, "simulation", f"is {short(content)}, not a list", "paste the list of a diagnosis.json")
    for number, entry in enumerate(content):
        field = f"simulation[{number}]"
        id_, parameters = checked(entry, field, where)
        mechanism = mechanisms()[id_]
        mend = "paste the entry as a diagnosis gives it"
        options = mechanism.candidates(drivers) or ([dict.fromkeys(mechanism.units, 0.0)] if mechanism.units else [])
        if not options:
            raise BadInput(where, f"{field}.id", f"{id_!r} has no place in this rig or this recording", "remove it")
        name_of = drivers.units.name
        more = [name for name in mechanism.optional if name_of(name) in parameters]
        orders = [[name for name in nonlinear if name not in mechanism.optional] + more for nonlinear in options]
        names = [{name_of(name) for name in order} for order in orders] or [set()]
        fitting = [keys for keys in names if keys <= set(parameters)]
        if not fitting:
            raise BadInput(where, f"{field}.parameters", f"lacks one of {', '.join(sorted(names[0]))}", mend)
        keys = max(fitting, key=len)
        order = next(order for order in orders or [[]] if {name_of(name) for name in order} == keys)
        nonlinear = {name: float(parameters[name_of(name)]) for name in order}
        try:
            terms = mechanism.terms(drivers, nonlinear)
        except (ArithmeticError, LookupError, ValueError) as error:
            problem = f"cannot act in {id_!r} ({type(error).__name__}: {short(str(error))})"
            raise BadInput(where, f"{field}.parameters", problem, mend) from None
        unknown = set(parameters) - keys - {name_of(term.name) for term in terms}
        if unknown:
            parameter_names = ", ".join(name_of(name) for name in [*order, *(term.name for term in terms)])
            wrong = key_name(sorted(unknown)[0])
            raise BadInput(where, f"{field}.parameters.{wrong}", f"is not one of {parameter_names}", mend)
        acts.append(Act(id_, (nonlinear,), tuple(float(parameters.get(name_of(term.name), 0.0)) for term in terms)))
    return tuple(acts)
