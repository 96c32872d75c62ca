"""The size of a named effect in a cell: what no dimension could do of it, all of it, and what to think of that."""

from ..content import Part, Verdict
from . import certainty
from .quantity import size
from .vocabulary import Vocabulary

POORLY, HIDDEN, PARTLY = ", poorly known", ", poorly known: mostly hidden", ", partly hidden"
OWN = 0.8  # of an effect's size: a part that no dimension could do stands first if it is less


def own_size(entry: Part, content: Verdict, words: Vocabulary) -> str:
    """How much an effect moves the reading, with its interval if it has one, and what to think of it."""
    known = entry[f"rms_{words.ending}"]
    if not known["value"]:
        return "none"
    if known["high"] <= known["low"]:
        return size(known["value"], words.unit)
    within, doubt = certainty.span(known["low"], known["high"], words), doubt_of(entry, content, words)
    whole, own = size(known["value"], words.unit), own_part(entry, content, words)
    return f"{size(own, words.unit)} (of {whole}: {within}){doubt}" if own else f"{whole} ({within}){doubt}"


def doubt_of(entry: Part, content: Verdict, words: Vocabulary) -> str:
    """What to think of an effect's size: that it is poorly known, or hidden; nothing where it is known."""
    known = entry[f"rms_{words.ending}"]
    much = content["mismatch"] and certainty.hidden(known["value"], content, words)
    partly = entry["id"] in certainty.partly_hidden(content, words)
    return HIDDEN if much else POORLY if certainty.wide(known) else PARTLY if partly else ""


def own_part(entry: Part, content: Verdict, words: Vocabulary) -> float:
    """How much of an effect no dimension could do, rms, where that is clearly less than all of it; else 0."""
    left = content["evidence"].get(f"beyond_dimensions_{words.ending}", {}).get(entry["id"])
    return float(left) if left and left < OWN * entry[f"rms_{words.ending}"]["value"] else 0.0
