"""Where something is, in words: motion, strokes and phase; what spans everything is not said."""

from ..content import Part, Verdict
from .quantity import duration, ends, span
from .vocabulary import Vocabulary

EVERYWHERE = "over the whole range"
NEARLY_ALL = 0.75  # of the range of motion, and of the strokes


def place(location: Part, evidence: Part, words: Vocabulary) -> str:
    """A box as `at 0 to 12 turns, in strokes 2 to 9, while winding`."""
    low, high = evidence[words.driver]
    start, end = location[words.driver]
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


def recorded(content: Verdict, words: Vocabulary) -> str:
    """What was recorded of motion, speeds, loads and stands, in brackets; nothing where an older file lacks it."""
    known = content["evidence"].get("covered")
    if known is None:
        return ""
    (low, high), (slow, fast) = content["evidence"][words.driver], known["speed_per_s"]
    parts = [span(low, high, words.motion_unit, high - low), ends(slow, fast, f"{words.motion_unit}/s")]
    if words.load is not None and known["load"][1] > 0.0:
        least, most = known["load"]
        parts.append(ends(least, most, words.load_unit))
    parts += [f"{name}s of up to {duration(known[f'longest_{name}_s'])}" for name in ("hold", "rest")]
    return f" ({', '.join(parts)})"
