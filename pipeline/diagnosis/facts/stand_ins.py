"""Stand-ins that a simulator has beside what is named, and that no run.yaml gave it."""

from ..choice.outcome import Study, rms
from ..document.content import Part
from ..fit import locate
from . import extents
from .mechanism_entries import effect_of


def stand_ins(study: Study, ending: str) -> list[Part]:
    """An entry each: `id`, `rms` and `span` (from the lowest to the highest value) in the reading's unit, `location`.

    `ending` is that of the keys.
    """
    problem, entries = study.problem, list[Part]()
    for act in problem.beside:
        effect = effect_of(problem, study.best, act)
        sizes = {f"rms_{ending}": {"value": rms(effect)}, f"span_{ending}": extents.spans({act.id: effect})[act.id]}
        entries.append({"id": act.id, **sizes, "parameters": {}, "location": locate.box(effect, problem)})
    return entries
