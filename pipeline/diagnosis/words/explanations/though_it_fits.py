"""The closest explanation fits but is no name: what it would do on this rig, and why it is no name."""

import re

from ....ground.units import unit_of
from ...document.content import Included, Verdict
from ...mechanisms.library import mechanisms
from ..language.explained_words import meaning, on_rig
from ..language.quantity import number, percent, quantity, said_unit
from ..language.vocabulary import Vocabulary
from .probability import likeliest
from .rivals import called, entries

WHY = (
    "{} fits and is no name: a formula with free numbers can copy other physics. Of simulated recordings like this one "
    "about {} were physics that the library lacks, {} were {}."
)
LOOKS = "The pattern of what is missing is unlike the one that {} leaves in simulated recordings."
SHOWS = "What would show it: {}."


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """Why the likeliest explanation is no name though it fits, then what it would be; nothing where none is weighed."""
    first = next(iter(likeliest(entries(content, "not enough"))), None)
    none = content["evidence"].get("probability_of_none")
    share = first.get("probability") if first else None
    if first is None or none is None or share is None:
        return []
    name, looks = called(first["ids"]), content["evidence"].get("looks_like", {})
    why = WHY.format(name, percent(none), percent(share), name)
    if set(first["ids"]) < set(looks) and len(first["ids"]) == 1 and looks[name] < looks["outside"]:
        why += f" {LOOKS.format(name)}"
    return [why, *would_be(content, words)]


def would_be(content: Verdict, words: Vocabulary) -> list[str]:
    """What each effect of the closest explanation does, its fitted numbers, and what would show it, a line each.

    Nothing where none does.
    """
    closest = content["closest"]["simulation"] if "closest" in content else []
    acts = [(act, mechanisms()[act["id"]].told_apart_by) for act in closest if act["id"] in mechanisms()]
    return [f"{act['id']}: {_does(act, words)}. {SHOWS.format(on_rig(sign, words))}" for act, sign in acts]


def constants(content: Verdict) -> list[str]:
    """The fitted numbers of what comes closest, in a line; nothing where nothing does."""
    acts = content["closest"]["simulation"] if "closest" in content else []
    each = [f"{act['id']} {', '.join(_constant(*constant) for constant in act['parameters'].items())}" for act in acts]
    head = "Fitted constants of what comes closest, which are no result (docs/physics.md has each formula)"
    return [f"{head}: {'; '.join(each)}."] if each else []


def _does(act: Included, words: Vocabulary) -> str:
    """What an effect does, without a full stop, with the first detail whose numbers were all fitted."""
    does = on_rig(meaning(act["id"]), words).rstrip(".")
    fitted = {name: value for name, value in act["parameters"].items() if value}
    for template in mechanisms()[act["id"]].details:
        names = re.findall(r"{(\w+)}", template)
        if all(name in fitted for name in names):
            spelled = {name: quantity(fitted[name], unit_of(name), 3) for name in names}
            return f"{does}; as fitted, {template.format(**spelled)}"
    return does


def _constant(name: str, value: float) -> str:
    unit = said_unit(unit_of(name))
    return f"{name} {number(value, 3)}{f' {unit}' if unit and unit not in name else ''}"
