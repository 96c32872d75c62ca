"""Where something is, in words: motion, strokes and phase; what spans everything is not said."""

from typing import Any

from .quantity import span
from .vocabulary import Vocabulary

EVERYWHERE = "over the whole range"
NEARLY_ALL = 0.75  # of the range of motion, and of the strokes


def place(location: dict[str, Any], evidence: dict[str, Any], words: Vocabulary) -> str:
    """A box as `at 0 to 12 turns, in strokes 2 to 9, while winding`."""
    low, high = evidence[words.driver]
    start, end = location[words.driver]
    said = []
    if end - start < NEARLY_ALL * (high - low):
        said.append(f"at {span(start, end, words.motion_unit, high - low)}")
    first, last = location["strokes"]
    earliest, latest = evidence["strokes"]
    if last - first + 1 < NEARLY_ALL * (latest - earliest + 1):
        said.append(f"in stroke {first}" if first == last else f"in strokes {first} to {last}")
    if location["phase"] != "all":
        said.append(words.phase(location["phase"]))
    return ", ".join(said) or EVERYWHERE
