"""The explanations that come closest where none is good enough: what each takes away and leaves, and why it fails."""

import re

from ....ground.outside_library import is_outside
from ....ground.words.glossary import MEANING
from ...choice.judged import UNKNOWN
from ...choice.search import EXPLAINED
from ...document.content import Verdict
from ...document.explanations import ExplanationEntry
from ...document.made_keys import amount, amount_or_none
from ...mechanisms.interface import physics
from ...mechanisms.library import mechanisms
from ..language.quantity import listing, percent, size, times
from ..language.text_table import UNKNOWN as NOT_KNOWN
from ..language.text_table import within
from ..language.vocabulary import Vocabulary
from . import not_named, probability, though_it_fits
from .rivals import called, entries

CLOSEST = 4  # explanations that are shown
HEAD = ["tried instead", "takes away", "leaves (× noise)", "probability", "why it is no name"]
STAND_IN = "no physics of the library"
UNLIKELY, LARGER = "not likely enough", "adds too little"
STAND_INS = "No name, but a stand-in that fits the data and is no physics of the library: {}."
ENOUGH = "To be named, an explanation must take away {} of what is missing (of its energy, the mean of its square)"


def insufficient(content: Verdict, words: Vocabulary) -> list[str]:
    """A table of the closest explanations where none is good enough, with the share of the mismatch's energy."""
    ending, floor = words.ending, amount(content["evidence"], f"floor_{words.ending}")
    nothing = next(iter(entries(content, "nothing")), None)
    if nothing is None:
        return []
    alone = float(
        amount_or_none(nothing, f"approximated_{ending}") or amount(nothing, f"left_{ending}")
    )  # as what the others leave
    energy, rows, reasons = alone**2 - floor**2, [HEAD], list[str]()
    shown = probability.likeliest(entries(content, "not enough", "beaten", "not needed"))[:CLOSEST]
    for explanation in shown:
        left_rms, share = amount(explanation, f"left_{ending}"), explanation.get("probability")
        taken = min(max((alone**2 - left_rms**2) / energy, 0.0), 1.0) if energy > 0.0 else 0.0
        cells = [f"{100.0 * taken:.0f} %", f"{size(left_rms, words.unit)} ({times(left_rms / floor)})"]
        likely = NOT_KNOWN if share is None else percent(share)
        rows.append([called(explanation["ids"]), *cells, likely, _why_not(explanation, taken)])
        reason = not_named.reason_of(content, explanation["ids"])
        reasons += [reason.replace("It is", f"{called(explanation['ids'])} is")] if reason else []
    rows.append([called([]), "0 %", f"{size(alone, words.unit)} ({times(alone / floor)})", NOT_KNOWN, ""])
    if all(row[3] == NOT_KNOWN for row in rows[1:]):
        rows = [[*row[:3], row[4]] for row in rows]
    sets = [explanation["ids"] for explanation in shown]
    why = though_it_fits.lines(content, words) if rows[1][-1] == UNLIKELY else []
    return [*within(rows, 0), *why, *reasons, *stand_ins(sets), _rule(content)]


def stand_ins(sets: list[list[str]]) -> list[str]:
    """What each stand-in of some explanations does, in one line; nothing where none is among them."""
    does = [f"{id_} ({plainly(id_)})" for id_ in dict.fromkeys(id_ for ids in sets for id_ in ids) if plainly(id_)]
    return [STAND_INS.format(listing(does))] if does else []


def not_told(text: str) -> list[str]:
    """What each stand-in does that a text names without saying what it does."""
    words = " ".join(text.split())
    named = [id_ for id_ in mechanisms() if re.search(rf"\b{id_}\b", words) and plainly(id_)]
    return stand_ins([[id_ for id_ in named if plainly(id_) not in words]])


def plainly(id_: str) -> str:
    """What a stand-in does, in words without its id; empty for any other effect."""
    is_stand_in = is_outside(id_) and id_ in MEANING and id_ in mechanisms()
    return MEANING[id_].partition(";")[0].rstrip(".") if is_stand_in else ""


def _rule(content: Verdict) -> str:
    """The rule by which an explanation becomes a name, and by which nothing is named."""
    none = content["evidence"].get("probability_of_none")
    rule = ENOUGH.format(percent(EXPLAINED))
    if none is None or not probability.known(content):
        return f"{rule}."
    if none >= UNKNOWN:
        lacks = f"Where physics that the library lacks has {percent(UNKNOWN)} or more"
        return f"{rule}, and be likely. {lacks}, nothing is named."
    return f"{rule}, and be likely. Physics that the library lacks has a probability of {percent(none)} here."


def _why_not(explanation: ExplanationEntry, taken: float) -> str:
    """Why an explanation is not good enough, in a few words."""
    if not physics(tuple(explanation["ids"])):
        return STAND_IN
    if taken < EXPLAINED:
        return "takes away too little"
    if explanation.get("balanced"):
        return "its effects cancel each other"
    helpers = [id_ for id_ in explanation["ids"] if id_ in mechanisms() and mechanisms()[id_].helper]
    if helpers:
        return f"{listing(helpers)} fits nearly anything"
    return LARGER if explanation["standing"] == "not needed" else UNLIKELY
