"""`simulation:` of run.yaml, and of a diagnosis, to what acts in the simulator, and back."""

from typing import Any

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.library import mechanisms
from pipeline.diagnosis.problem import Act
from pipeline.errors import BadInput

DIGITS = 6


def entries(acts: tuple[Act, ...], drivers: Drivers) -> list[dict[str, Any]]:
    """One entry a shape: its id and, by name, the shape's values and the coefficients that are not zero."""
    found = []
    for act in acts:
        mechanism, at = mechanisms()[act.id], 0
        for shape in act.shapes:
            terms = mechanism.terms(drivers, shape)
            values = act.coefficients[at : at + len(terms)]
            at += len(terms)
            held = {term.name: value for term, value in zip(terms, values, strict=True) if value != 0.0}
            parameters = {name: float(f"{value:.{DIGITS}g}") for name, value in {**shape, **held}.items()}
            found.append({"id": act.id, "parameters": parameters})
    return found


def acts_from(content: list[dict[str, Any]], drivers: Drivers, where: str = "run.yaml") -> tuple[Act, ...]:
    """The acts that a list of entries describes; raises BadInput for an id or a parameter that is not known."""
    found = []
    for number, entry in enumerate(content):
        field = f"simulation[{number}]"
        id_, given = entry.get("id"), entry.get("parameters", {})
        if id_ not in mechanisms():
            mend = f"use one of {', '.join(mechanisms())}"
            raise BadInput(where, f"{field}.id", f"{id_!r} is not a mechanism of the library", mend)
        mechanism = mechanisms()[id_]
        mend = "paste the entry as a diagnosis gives it"
        options = mechanism.shapes(drivers) or [dict.fromkeys(mechanism.units, 0.0)]
        names = [set(shape) for shape in options] or [set()]
        fitting = [keys for keys in names if keys <= set(given)]
        if not isinstance(given, dict) or not fitting:
            raise BadInput(where, f"{field}.parameters", f"lacks one of {', '.join(sorted(names[0]))}", mend)
        keys = max(fitting, key=len)
        order = next((list(shape) for shape in options if set(shape) == keys), sorted(keys))
        shape = {name: float(given[name]) for name in order}
        terms = mechanism.terms(drivers, shape)
        unknown = set(given) - keys - {term.name for term in terms}
        if unknown:
            known = ", ".join([*order, *(term.name for term in terms)])
            raise BadInput(where, f"{field}.parameters.{sorted(unknown)[0]}", f"is not one of {known}", mend)
        found.append(Act(id_, (shape,), tuple(float(given.get(term.name, 0.0)) for term in terms)))
    return tuple(found)
