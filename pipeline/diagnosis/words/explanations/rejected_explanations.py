"""Why each explanation that was beaten was, and what comes closest where none explains, in words."""

import math

from ...choice.search import EXPLAINED
from ...document.content import Part, Verdict
from ...mechanisms.interface import physics
from ...mechanisms.library import mechanisms
from ..language.places import EVERYWHERE, place
from ..language.quantity import listing, percent, size, times
from ..language.vocabulary import Vocabulary
from . import left_out, less_likely, probability
from .reasons import why
from .rivals import ALIKE, ALLOWED, called, entries, left, no_less, told

CLOSEST = 4  # explanations that are shown where none does
SHOWN = 8  # of those that were beaten
RARE = 0.01  # a probability below which an explanation needs no further word
VISIBLE = 0.4  # noise floors: smaller gains need no further word
DEVIATIONS = "standard deviations"
COUNTS = (
    "Standard deviations count the noise alone, and a formula that is wrong by a few per cent makes many of them. So "
    "they are no odds: the probabilities, learnt on recordings with such formulas, allow for that."
)
UNWEIGHED = "It was not weighed: the recording lacks a mark of its effects, or cheaper ones of its size are many. "


def rejected(content: Verdict, words: Vocabulary) -> list[str]:
    """Why each explanation that was beaten was: how much worse it is, where, and following what."""
    first = next(iter(entries(content, "named", "not enough")), None)
    beaten = [explanation for explanation in entries(content, "beaten") if first and explanation is not first]
    listed = likeliest([*beaten, *entries(content, "not needed")])[:SHOWN]
    shown, larger = ([each for each in listed if (each["standing"] == "beaten") == is_it] for is_it in (True, False))
    weighed = [each for each in likeliest([*shown, *larger]) if each.get("probability") is not None]
    lines: list[str] = []
    if first and less_likely.known(weighed, first, content):
        lines = _in_table(weighed, first, content, words)
        shown, larger = ([each for each in group if each not in weighed] for group in (shown, larger))
    sentences = [(explanation, _beaten(explanation, first, content, words)) for explanation in shown if first]
    sentences += [(explanation, _not_needed(explanation, content, words)) for explanation in larger]
    lines += [_with_rule(with_why(sentence, each, first), each, content) for each, sentence in sentences]
    lines += [COUNTS] if any(DEVIATIONS in line for line in lines) else []
    lines += [
        f"{called([])}: leaves {left(explanation, content, words)}." for explanation in entries(content, "nothing")
    ]
    return lines


def _in_table(shown: list[Part], first: Part, content: Verdict, words: Vocabulary) -> list[str]:
    """The rivals in a table, then a sentence of each that is worth one: what is hardly likely has its row alone."""
    lines = less_likely.table(shown, first, content, words)
    for explanation in shown:
        remark = ""
        if explanation["probability"] >= RARE and explanation["standing"] == "not needed":
            remark = _not_needed(explanation, content, words)
        elif explanation["probability"] >= RARE:
            remark = f"{called(explanation['ids'])}: {_differs(explanation, first, content, words)}"
        rule = left_out.reason_of(content, explanation["ids"])
        remark = remark or (f"{called(explanation['ids'])}:" if rule else "")
        lines += [" ".join(part for part in (remark, rule) if part)] if remark else []
    return lines


def with_why(sentence: str, explanation: Part, first: Part | None) -> str:
    """What is said of an explanation, and then why it is less likely than the first one."""
    return " ".join(part for part in (sentence, why(explanation, first)) if part)


def _with_rule(sentence: str, explanation: Part, content: Verdict) -> str:
    """What is said of an explanation, and then the rule that leaves it out, if one does."""
    return " ".join(part for part in (sentence, left_out.reason_of(content, explanation["ids"])) if part)


def likeliest(explanations: list[Part]) -> list[Part]:
    """Explanations by falling probability; those without one as they came, last."""
    return sorted(explanations, key=lambda explanation: -(explanation.get("probability") or 0.0))


def insufficient(content: Verdict, words: Vocabulary) -> list[str]:
    """What comes closest where nothing explains, with the share of the mismatch's energy that it takes."""
    ending, floor = words.ending, content["evidence"][f"floor_{words.ending}"]
    nothing = next(iter(entries(content, "nothing")), None)
    if nothing is None:
        return []
    alone = float(nothing.get(f"approximated_{ending}") or nothing[f"left_{ending}"])  # as what the others leave
    energy, lines = alone**2 - floor**2, []
    for explanation in likeliest(entries(content, "not enough", "beaten", "not needed"))[:CLOSEST]:
        taken = (alone**2 - explanation[f"left_{ending}"] ** 2) / energy if energy > 0.0 else 0.0
        likely = probability.said(explanation)
        share = f"{100.0 * min(max(taken, 0.0), 1.0):.0f} % of the mismatch's energy"
        sentence = f"{called(explanation['ids'])}: {likely}{'; ' if likely else ''}takes {share}"
        summary = f"{sentence}{_why_not(explanation, taken)}."
        lines.append(_with_rule(summary, explanation, content))
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


def _beaten(explanation: Part, first: Part, content: Verdict, words: Vocabulary) -> str:
    """What a beaten explanation leaves, and how its prediction differs from the best one."""
    summary = told(explanation, content, words)
    if explanation.get("probability") is not None and explanation["probability"] < RARE:
        return f"{summary}."
    if no_less(explanation, content, words):
        return f"{summary}."
    if explanation[f"left_{words.ending}"] <= ALIKE * first[f"left_{words.ending}"] and (
        explanation["worse"] > 0.0 or not explanation.get("balanced")
    ):
        summary += f", {_beside(explanation, first, words)}"
    return f"{summary}. {_differs(explanation, first, content, words)}"


def _differs(explanation: Part, first: Part, content: Verdict, words: Vocabulary) -> str:
    """How the prediction of a beaten explanation differs from the best one, and how much nearer that is."""
    ending = words.ending
    where = place(explanation["location"], content["evidence"], words)
    where = where if where == EVERYWHERE else f"mostly {where}"
    follows = f" This difference follows {words.follows(explanation['driver'])}." if explanation["driver"] else ""
    gap = size(explanation[f"gap_{ending}"], words.unit)
    differs = f"Its prediction differs from the best one by {gap} rms, {where}.{follows}"
    if explanation[f"left_{ending}"] > ALIKE * first[f"left_{ending}"]:
        return differs
    if explanation["worse"] > 0.0:
        far = f"by {times(math.sqrt(explanation['worse']))} {DEVIATIONS}"
        return f"Weighed sample by sample, the best one is nearer to the recording {far}. {differs}"
    if explanation.get("balanced"):
        return "Its effects are large and cancel each other almost fully: that is no explanation."
    return f"{UNWEIGHED if explanation.get('probability') is None else ''}{differs}"


def _beside(explanation: Part, first: Part, words: Vocabulary) -> str:
    """What an explanation leaves beside what the best one does, which is hardly another size."""
    mine, best = (size(each[f"left_{words.ending}"], words.unit) for each in (explanation, first))
    if mine == best:
        return "the same as the best one"
    more = explanation[f"left_{words.ending}"] > first[f"left_{words.ending}"]
    return f"{'hardly more' if more else 'even less'} than the best one ({best})"


def _saved(base: Part, larger: Part, key: str) -> float:
    """What a larger explanation takes away of what a smaller one leaves, rms."""
    return math.sqrt(max(base[key] ** 2 - larger[key] ** 2, 0.0))


def _not_needed(larger: Part, content: Verdict, words: Vocabulary) -> str:
    """What a larger explanation takes away beyond the one that it contains."""
    ending, shown = words.ending, content["evidence"]["explanations"]
    smaller = [other for other in shown if set(other["ids"]) < set(larger["ids"]) and other["standing"] != "not needed"]
    base = min(smaller, key=lambda other: float(other[f"left_{ending}"]), default=None)
    if base is None:
        return f"{told(larger, content, words)}: too little less for one mechanism more."
    saved, with_discrepancy = (_saved(base, larger, f"{key}_{ending}") for key in ("left", "bent"))
    further = [id_ for id_ in larger["ids"] if id_ not in base["ids"]]
    likely = probability.said(larger)
    added = f"{listing(further)}, added to {called(base['ids'])}{f' ({likely})' if likely else ''}"
    if not saved:
        return f"{added}: explains nothing more."
    takes = "takes" if len(further) == 1 else "take"
    more = f"{takes} away {size(saved, words.unit)} rms more and {'leaves' if takes == 'takes' else 'leave'}"
    summary = f"{added}: {more} {left(larger, content, words)}"
    if saved > VISIBLE * content["evidence"][f"floor_{ending}"] and with_discrepancy < saved:
        allowed = f"{ALLOWED[0].lower()}{ALLOWED[1:]}"
        all_of_it, sure = size(saved, words.unit), size(with_discrepancy, words.unit)
        summary += f". Of the {all_of_it} only {sure} are sure {allowed}" if sure != all_of_it else ""
    kept = [other for other in entries(content, "tied") if len(other["ids"]) >= len(larger["ids"])]
    if any(other[f"left_{ending}"] >= larger[f"left_{ending}"] for other in kept):
        return f"{summary}. Some that are likely leave as much, and are ranked before it all the same."
    return f"{summary}. That is too little for {'one mechanism' if len(further) == 1 else 'so many mechanisms'} more."
