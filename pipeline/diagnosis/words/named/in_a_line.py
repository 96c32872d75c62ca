"""The action of an effect in one line: its largest size, or the time and size of sudden events."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from ....run.description import Included
from ...document.content import Verdict
from ...document.effects_named import MechanismEntry
from ...mechanisms.library import mechanisms
from ..language.explained_words import meaning, of_effect, on_rig
from ..language.quantity import listing, number, size
from ..language.vocabulary import Vocabulary
from . import effect_sentence
from .effect_sentence import AT
from .own_size import doubt_of, own_part

MOST, EXACT_S = 3, 100.0  # events that are told, the largest; from when on a time is told to the second
LARGEST = re.compile(r"up to \d.*?(?=, [a-z]| \(|\.$|\. )|\d[^,(]* in all")  # of an effect's sentence
HALF = re.compile(r"half [^.]*? \d.*?\)")
WITHIN, EACH = "within_s", "_per_stroke"  # of an event: how fast; of a size: at every stroke


def of_named(entry: MechanismEntry, content: Verdict, words: Vocabulary) -> str:
    """The action of an effect of the best explanation; with its largest size only where that is well known."""
    does, mechanism = of_effect(entry, words), mechanisms()[entry["id"]]
    calculated = "a temperature that is calculated from the motion, not measured"
    does = does.replace("the temperature", calculated) if effect_sentence.calculated(mechanism, entry) else does
    events = _events(content.get("simulation", []), entry["id"], words)
    if events or own_part(entry, content, words) or doubt_of(entry, content, words):
        return _joined(does, events, ", ")
    return _joined(does, _largest(entry.get("sentence", "")), "; here ")


def of_open(id_: str, content: Verdict, words: Vocabulary) -> str:
    """The action of an effect that only other explanations have, as the first kept one has it."""
    kept = [rival["simulation"] for rival in content.get("rivals", []) if id_ in rival["ids"]]
    return _joined(on_rig(meaning(id_), words), _events(kept[0], id_, words) if kept else "", "; if so, ")


def _largest(sentence: str) -> str:
    """The largest size of an effect, under each load where loads differ, and half a play or a loop."""
    sizes = (LARGEST.search(sentence), HALF.search(sentence))
    return "; ".join(size_said[0] for size_said in sizes if size_said)


@dataclass(frozen=True, order=True)
class _Event:
    """A sudden event: its `size` in `unit`, at a time since the start of the recording, or at `each` stroke."""

    size: float
    unit: str
    at_s: float
    each: bool

    def __str__(self) -> str:
        much = size(self.size, self.unit)
        at = f"{self.at_s:.0f}" if self.at_s >= EXACT_S else number(self.at_s, 3)
        return f"{much} at every stroke" if self.each else f"{much} at {at} s"


def _events(simulation: Sequence[Included], id_: str, words: Vocabulary) -> str:
    """The largest events of an effect in the order of their times; nothing for an effect that goes on."""
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


def _joined(does: str, size_or_events: str, link: str) -> str:
    return f"{does.rstrip('.')}{link}{size_or_events}." if size_or_events else does
