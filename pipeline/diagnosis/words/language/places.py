"""The place of something, in words: motion, strokes and phase; a range that spans everything is left out."""

from ...document.effects_named import Location
from ...document.evidence import Evidence
from ...document.made_keys import extent
from .quantity import span
from .vocabulary import Vocabulary

EVERYWHERE = "over the whole range"
NEARLY_ALL = 0.75  # of the range of motion, and of the strokes


def lying(location: Location, evidence: Evidence, words: Vocabulary) -> str:
    """The place where a mismatch lies: `mostly at 0 to 12 turns`, or spread."""
    where = place(location, evidence, words)
    return "spread over the whole range" if where == EVERYWHERE else f"mostly {where}"


def place(location: Location, evidence: Evidence, words: Vocabulary) -> str:
    """A box as `at 0 to 12 turns, in strokes 2 to 9, while winding`."""
    low, high = extent(evidence, words.driver)
    start, end = extent(location, words.driver)
    parts = []
    if end - start < NEARLY_ALL * (high - low):
        parts.append(f"at {span(start, end, words.motion_unit, high - low)}")
    first, last = location["strokes"]
    earliest, latest = evidence["strokes"]
    if last - first + 1 < NEARLY_ALL * (latest - earliest + 1):
        parts.append(f"in stroke {first}" if first == last else f"in strokes {first} to {last}")
    if location["phase"] != "all":
        parts.append(words.phase(location["phase"]))
    return ", ".join(parts) or EVERYWHERE
