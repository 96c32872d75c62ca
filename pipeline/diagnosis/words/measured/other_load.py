"""Whether a recording has one load, or a second one in too few of its strokes to be told apart by, in words."""

from ...document.content import Verdict
from ..language.quantity import ends, listing
from ..language.vocabulary import Vocabulary

MOST_TOLD = 4  # strokes that a sentence names; of more it says how many


def only_in(content: Verdict) -> str:
    """The few strokes that had another load, after `only in`; nothing where none had."""
    other = content["evidence"].get("other_load")
    if other is None:
        return ""
    count, numbers = len(other["strokes"]), [str(stroke) for stroke in other["strokes"]]
    if count > MOST_TOLD:
        return f"{count} strokes"
    return f"stroke{'s' * (count > 1)} {listing(numbers)}"


def size(content: Verdict, words: Vocabulary) -> str:
    """The load of these strokes, with its unit; nothing where there are none."""
    other = content["evidence"].get("other_load")
    return ends(min(other["load"]), max(other["load"]), words.load_unit, 2) if other else ""


def usual(content: Verdict) -> float | None:
    """The load of the other strokes, in the load channel's unit; None where all had one."""
    other = content["evidence"].get("other_load")
    return other["usual"] if other else None


def single(content: Verdict) -> str:
    """What slow effects cannot be told apart by, as the subject of a sentence."""
    return f"a second load only in {only_in(content)}" if only_in(content) else "one load"


def under_single(content: Verdict) -> str:
    """As `single`, as the begin of a sentence."""
    return f"With {single(content)}" if only_in(content) else "Under one load"
