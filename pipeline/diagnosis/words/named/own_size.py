"""The size of a named effect in a cell: the part that no dimension could imitate, the whole, and a remark."""

from ...document.content import Verdict
from ...document.effects_named import MechanismEntry
from ...document.made_keys import by_name, interval
from ..language import sized
from ..language.quantity import listing, size
from ..language.vocabulary import Vocabulary
from ..measured.dimensions import far_moved
from . import certainty

POORLY, HIDDEN, PARTLY = ", poorly known", ", mostly hidden", ", partly hidden"
PART = "the part that no wrong dimension can make"
TO_REPORT = "Of {} report the last column, not the size before it: {} could make the rest."
OWN = 0.8  # of an effect's size: a part that no dimension could do stands first if it is less


def own_size(entry: MechanismEntry, content: Verdict, words: Vocabulary) -> str:
    """How much an effect moves the reading, with its interval if it has one, and a remark on it."""
    rms = interval(entry, f"rms_{words.ending}")
    if not rms["value"]:
        return "none"
    if rms["high"] <= rms["low"]:
        return size(rms["value"], words.unit)
    if own_part(entry, content, words):
        poorly = POORLY if certainty.wide(rms) else ""
        return f"{own_with_interval(entry, content, words)}, in all {size(rms['value'], words.unit)}{poorly}"
    return f"{with_interval(entry, words)}{doubt_of(entry, content, words)}"


def in_columns(entry: MechanismEntry, content: Verdict, words: Vocabulary, parts: bool, short: bool) -> list[str]:
    """The whole size of an effect in a cell; in a table with `parts`, a second cell for the part of its own.

    The part of its own is the part that no dimension could imitate. `short`: a partly hidden size is marked as not to
    be quoted, since the page says no more on it.
    """
    rms = interval(entry, f"rms_{words.ending}")
    if not rms["value"]:
        return ["none", *["–"] * parts]
    whole = size(rms["value"], words.unit) if rms["high"] <= rms["low"] else with_interval(entry, words)
    part = own_part(entry, content, words)
    doubt = doubt_of(entry, content, words)
    if part:  # it says by itself that the rest is hidden
        doubt = POORLY if certainty.wide(rms) else ""
    elif short and doubt == PARTLY:  # an interval would promise more
        whole, doubt = f"{size(rms['value'], words.unit)} in this fit", f"{PARTLY}: do not quote"
    return [f"{whole}{doubt}", *[size(part or rms["value"], words.unit)] * parts]


def with_interval(entry: MechanismEntry, words: Vocabulary, factor: float = 1.0) -> str:
    """All of an effect with its 90 % interval, or a part of it, `factor` of all: 0.25 mm (0.21 to 0.32 mm)."""
    value, low, high = (factor * interval(entry, f"rms_{words.ending}")[end] for end in ("value", "low", "high"))
    own, range_ = sized.sized(value, low, high, words)
    return f"{own} ({range_})"


def own_with_interval(entry: MechanismEntry, content: Verdict, words: Vocabulary) -> str:
    """The part of an effect that no dimension could imitate; its relative uncertainty is the effect's."""
    own = own_part(entry, content, words)
    return with_interval(entry, words, own / interval(entry, f"rms_{words.ending}")["value"])


def reportable(entry: MechanismEntry, content: Verdict, words: Vocabulary) -> bool:
    """Whether an effect has a size to report: the whole, or the part that no dimension could imitate.

    One that is more likely absent than at work has none.
    """
    if certainty.known(content).get(entry["id"], 1.0) < certainty.EVEN:
        return False
    doubt = doubt_of(entry, content, words)
    narrow = not certainty.wide(interval(entry, f"rms_{words.ending}"))
    return narrow and (not doubt or own_part(entry, content, words) > 0.0)


def to_report(content: Verdict, entries: list[MechanismEntry], words: Vocabulary, instead: str) -> list[str]:
    """Which of two sizes to report, where effects have two and each can be reported; else nothing.

    `instead` are the dimensions that could make the rest.
    """
    if far_moved(content) or not all(reportable(entry, content, words) for entry in entries):
        return []
    ids = [entry["id"] for entry in entries if own_part(entry, content, words)]
    return [TO_REPORT.format(listing(ids), instead)] if ids else []


def doubt_of(entry: MechanismEntry, content: Verdict, words: Vocabulary) -> str:
    """The remark on an effect's size: poorly known, or hidden; nothing where it is known."""
    rms = interval(entry, f"rms_{words.ending}")
    much = content["mismatch"] and certainty.hidden(rms["value"], content, words)
    partly = entry["id"] in certainty.partly_hidden(content, words)
    return HIDDEN if much else POORLY if certainty.wide(rms) else PARTLY if partly else ""


def own_part(entry: MechanismEntry, content: Verdict, words: Vocabulary) -> float:
    """The rms of an effect that no dimension could imitate, if clearly less than the whole; else 0."""
    own_rms = by_name(content["evidence"], f"beyond_dimensions_{words.ending}").get(entry["id"])
    return float(own_rms) if own_rms and own_rms < OWN * interval(entry, f"rms_{words.ending}")["value"] else 0.0
