"""Stand-ins of a simulator beside the named effects; no run.yaml gave them."""

from ..choice.outcome import Study, rms
from ..document.effects_named import StandIn
from ..document.made_keys import Made, with_made
from ..fit import locate
from . import extents
from .mechanism_entries import effect_of


def stand_ins(study: Study, ending: str) -> list[StandIn]:
    """An entry each: `id`, `rms` and `span` (from the lowest to the highest value) in the reading's unit, `location`.

    `ending` is that of the keys.
    """
    problem, entries = study.problem, list[StandIn]()
    for act in problem.beside:
        effect = effect_of(problem, study.best, act)
        rms_alone = {"value": rms(effect)}
        sizes: dict[str, Made] = {f"rms_{ending}": rms_alone, f"span_{ending}": extents.spans({act.id: effect})[act.id]}
        entry: StandIn = {"id": act.id, "parameters": {}, "location": locate.box(effect, problem)}
        entries.append(with_made(entry, sizes, "parameters"))
    return entries
