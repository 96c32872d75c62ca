"""What an effect does, in a line: the times and sizes of what happens suddenly; whether a temperature was measured."""

from collections.abc import Sequence
from dataclasses import dataclass

from ....run.description import Included
from ...document.content import Verdict
from ...document.effects_named import MechanismEntry
from ...mechanisms.library import mechanisms
from ..language.explained_words import meaning, of_effect, on_rig
from ..language.quantity import listing, number, size
from ..language.vocabulary import Vocabulary
from . import effects

MOST, EXACT_S = 3, 100.0  # events that are told, the largest; from when on a time is told to the second
AT, WITHIN, EACH = "at_s", "within_s", "_per_stroke"  # of an event: when, how fast; of a size: at every stroke


def of_named(entry: MechanismEntry, content: Verdict, words: Vocabulary) -> str:
    """What an effect of the best explanation does."""
    does, mechanism = of_effect(entry, words), mechanisms()[entry["id"]]
    calculated = "a temperature that is calculated from the motion, not measured"
    does = does.replace("the temperature", calculated) if effects.calculated(mechanism, entry) else does
    return _joined(does, _events(content.get("simulation", []), entry["id"], words), ", ")


def of_open(id_: str, content: Verdict, words: Vocabulary) -> str:
    """What an effect does that another explanation has alone, as the first of these has it that was kept."""
    kept = [rival["simulation"] for rival in content.get("rivals", []) if id_ in rival["ids"]]
    return _joined(on_rig(meaning(id_), words), _events(kept[0], id_, words) if kept else "", "; if so, ")


@dataclass(frozen=True, order=True)
class _Event:
    """What happens suddenly: its `size` in `unit`, at a time since the start of the recording, or at `each` stroke."""

    size: float
    unit: str
    at_s: float
    each: bool

    def __str__(self) -> str:
        much = size(self.size, self.unit)
        at = f"{self.at_s:.0f}" if self.at_s >= EXACT_S else number(self.at_s, 3)
        return f"{much} at every stroke" if self.each else f"{much} at {at} s"


def _events(simulation: Sequence[Included], id_: str, words: Vocabulary) -> str:
    """The events of an effect, the largest of them in the order of their times; nothing of an effect that goes on."""
    events = []
    for entry in simulation:
        values = entry.get("parameters", {})
        sizes = [(name, value) for name, value in values.items() if name not in (AT, WITHIN)]
        if entry["id"] == id_ and AT in values and sizes:
            name, value = sizes[0]
            unit = words.unit if name == words.ending else name.removesuffix(EACH)
            events.append(_Event(abs(value), unit, values[AT], name.endswith(EACH)))
    largest = sorted(sorted(events)[-MOST:], key=lambda event: event.at_s)
    fewer = [f"{len(events) - MOST} smaller"] if len(events) > MOST else []
    return f"by {listing([*map(str, largest), *fewer])}" if largest else ""


def _joined(does: str, events: str, link: str) -> str:
    return f"{does.rstrip('.')}{link}{events}." if events else does
