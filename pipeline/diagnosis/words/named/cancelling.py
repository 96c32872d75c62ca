"""Effects of one explanation together: their sizes do not add up, loops may partly cancel, and slow effects nearly."""

from ...document.content import Verdict
from ...document.effects_named import MechanismEntry
from ...document.made_keys import amount, by_name, interval
from ...facts.extents import BOTH
from ..language.quantity import listing, size
from ..language.vocabulary import Vocabulary
from ..measured.dimensions import far_moved

ADD_UP = 0.05  # of what is missing: sizes whose sum is so near to it need no word
NEARLY = (
    "{} nearly cancel: the recording shows their sum, which moves the reading by {} in a run, and cannot tell them "
    "apart. What can: {}."
)
FAR = 2.0  # times the recorded loop: effects that open wider ones must take most of each other back


def lines(content: Verdict, entries: list[MechanismEntry], words: Vocabulary) -> list[str]:
    """The joint action of several effects, and the remarks on those that cancel; nothing for one effect."""
    return [
        *_together(content, entries, words),
        *_cancel(content, entries, words),
        *_slow_cancel(content, entries, words),
    ]


def _together(content: Verdict, entries: list[MechanismEntry], words: Vocabulary) -> list[str]:
    """The joint action of several effects: their sizes do not add up, though a reader may try it."""
    missing = amount(content["mismatch"], f"rms_{words.ending}") if content["mismatch"] else 0.0
    sizes = [interval(entry, f"rms_{words.ending}")["value"] for entry in entries]
    if len(entries) < 2 or max(sizes) > missing or content["verdict"] != "explained" or far_moved(content):
        return []
    if abs(sum(sizes) - missing) < ADD_UP * missing:
        return []
    return [f"Sizes in rms do not add up: together the effects make the {size(missing, words.unit)} that is missing."]


def _cancel(content: Verdict, entries: list[MechanismEntry], words: Vocabulary) -> list[str]:
    """The remark that loops partly cancel; nothing unless two or more are far wider than the visible loop."""
    seen = ((content["evidence"].get("expected") or {}).get("recorded") or {}).get(f"loop_{words.ending}") or 0.0
    opened = content["evidence"].get("loops") or {}
    by_id = {
        entry["id"]: amount(opened[entry["id"]], f"width_{words.ending}") for entry in entries if entry["id"] in opened
    }
    wide = {id_: width for id_, width in by_id.items() if width > FAR * seen > 0.0}
    if len(wide) < 2:
        return []
    (first, its), *others = ((id_, size(width, words.unit)) for id_, width in wide.items())
    loops = listing([f"{first} would open a loop of {its}", *(f"{id_} one of {width}" for id_, width in others)])
    return [f"Alone {loops}; they partly cancel, so that the recorded loop is {size(seen, words.unit)}."]


def _slow_cancel(content: Verdict, entries: list[MechanismEntry], words: Vocabulary) -> list[str]:
    """The remark on each two slow effects that nearly cancel, with the run that tells; nothing within the noise."""
    evidence, named = content["evidence"], {entry["id"] for entry in entries}
    alone, sentences = by_name(evidence, f"spans_{words.ending}"), []
    for both, together in by_name(evidence, f"sums_{words.ending}").items():
        pair = both.split(BOTH)
        if not named.issuperset(pair) or min(alone[id_] for id_ in pair) <= amount(evidence, f"floor_{words.ending}"):
            continue
        sentences.append(NEARLY.format(listing(pair), size(together, words.unit), _run_that_tells(content, words)))
    return sentences


def _run_that_tells(content: Verdict, words: Vocabulary) -> str:
    """The run that parts slow effects: under another load where one load was recorded, or with a long rest."""
    under = "" if words.load is None or content["evidence"]["loaded"] else "under another load or "
    return f"a run {under}with a long rest"
