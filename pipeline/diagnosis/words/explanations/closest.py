"""What comes closest where nothing explains a recording, and why it does not do, in words."""

from ...choice.search import EXPLAINED
from ...document.content import Part, Verdict
from ...mechanisms.interface import physics
from ...mechanisms.library import mechanisms
from ..language.quantity import listing, percent
from ..language.vocabulary import Vocabulary
from . import left_out, probability
from .rivals import called, entries

CLOSEST = 4  # explanations that are shown


def insufficient(content: Verdict, words: Vocabulary) -> list[str]:
    """What comes closest where nothing explains, with the share of the mismatch's energy that it takes."""
    ending, floor = words.ending, content["evidence"][f"floor_{words.ending}"]
    nothing = next(iter(entries(content, "nothing")), None)
    if nothing is None:
        return []
    alone = float(nothing.get(f"approximated_{ending}") or nothing[f"left_{ending}"])  # as what the others leave
    energy, lines = alone**2 - floor**2, []
    for explanation in probability.likeliest(entries(content, "not enough", "beaten", "not needed"))[:CLOSEST]:
        taken = (alone**2 - explanation[f"left_{ending}"] ** 2) / energy if energy > 0.0 else 0.0
        likely = probability.said(explanation)
        share = f"{100.0 * min(max(taken, 0.0), 1.0):.0f} % of the mismatch's energy"
        sentence = f"{called(explanation['ids'])}: {likely}{'; ' if likely else ''}takes {share}"
        summary = f"{sentence}{_why_not(explanation, taken)}."
        lines.append(" ".join(filter(None, (summary, left_out.reason_of(content, explanation["ids"])))))
    none = content["evidence"].get("probability_of_none")
    also = [] if none is None else [f"Physics that the library lacks has a probability of {percent(none)} here."]
    rule = f"To be named, an explanation must take {100.0 * EXPLAINED:.0f} % of that energy and be likely."
    return [*lines, " ".join([rule, *also])]


def _why_not(explanation: Part, taken: float) -> str:
    """Why an explanation does not do, where the share of the energy that it takes does not tell; ends a phrase."""
    if not physics(tuple(explanation["ids"])):
        return ", and is no physics of the library"
    if taken < EXPLAINED:
        return ""
    if explanation.get("balanced"):
        return ", but its effects are large and cancel each other almost fully"
    helpers = [id_ for id_ in explanation["ids"] if id_ in mechanisms() and mechanisms()[id_].helper]
    if helpers:
        return f", but {listing(helpers)} would fit nearly anything"
    return ", but is too unlikely"
