"""What no row of the explanations' table can say: why a rival is less likely, where it differs, what it adds."""

import math
from collections.abc import Callable

from ....ground.words.counts import consecutive
from ...document.content import Verdict, left_with_discrepancy
from ...document.explanations import ExplanationEntry
from ...document.made_keys import amount
from ..language.places import EVERYWHERE, place
from ..language.quantity import listing, size, times
from ..language.vocabulary import Vocabulary
from . import probability, rivals
from .other_effects import ADDS
from .reasons import chiefly, less_often

RARE = 0.01  # a probability below which an explanation needs no further word
VISIBLE = 0.4  # noise floors: smaller gains need no further word
NEARER = "By the noise of the samples alone, explanation 1 fits better than {} standard deviations. {}"
COUNTS = (
    "They count the noise alone, and a formula that is wrong by a few per cent makes many of them; the probabilities "
    "allow for that."
)
UNWEIGHED = "Not weighed, since the recording lacks a mark of its effects, or cheaper ones of its size are many: {}."
BALANCED = "No explanation, since its effects are large and cancel each other almost fully: {}."
Numbered = dict[int, ExplanationEntry]  # explanations by the number of their row


def remarks(content: Verdict, rows: Numbered, kept: int, words: Vocabulary) -> list[str]:
    """A line for each question that the table leaves, its rows called by their numbers; the first `kept` are kept."""
    worth = {number: each for number, each in rows.items() if _worth(each)}
    return [
        *_no_common(content),
        *_less_likely(rows),
        *_where(worth, content, words),
        *_nearly_as_good(worth, words),
        *_larger(content, rows, words),
        *_allowed(content, dict(list(rows.items())[:kept]), rows, words),
    ]


def _worth(explanation: ExplanationEntry) -> bool:
    """Whether an explanation is worth more than its row."""
    share = explanation.get("probability")
    return share is None or share >= RARE


def numbers(of: list[int]) -> str:
    """Rows by their numbers: 2; 2 and 3; 4 to 7 and 9."""
    spans: list[str] = []
    for run in consecutive(of):
        spans += [f"{run[0]} to {run[-1]}"] if len(run) > 2 else map(str, run)
    return listing(spans)


def _grouped(rows: Numbered, phrase: Callable[[ExplanationEntry], str]) -> list[str]:
    """Each phrase with the numbers of the rows that it is said of; a row with an empty phrase is left out."""
    of: dict[str, list[int]] = {}
    for number, each in rows.items():
        if words := phrase(each):
            of.setdefault(words, []).append(number)
    return [f"{words} (no. {numbers(places)})" for words, places in of.items()]


def _less_likely(rows: Numbered) -> list[str]:
    """Why each rival is less likely than the best one, once for all that share a reason; nothing without a reason."""

    def reason(each: ExplanationEntry) -> str:
        if each.get("probability") == 0.0:
            return f"since {probability.LARGER_LEAVES_LESS}"
        return chiefly(each) if less_often(each, rows[1]) else ""

    reasons = _grouped({number: each for number, each in rows.items() if number > 1}, reason)
    return [f"Why less likely than no. 1: {'; '.join(reasons)}."] if reasons else []


def _where(rows: Numbered, content: Verdict, words: Vocabulary) -> list[str]:
    """Where each prediction differs from the best one, and what that follows; nothing where that is everywhere."""

    def lies(each: ExplanationEntry) -> str:
        if each.get(f"gap_{words.ending}") is None or each["standing"] == "named":
            return ""
        where = place(each["location"], content["evidence"], words)
        follows = f", following {words.follows(each['driver'])}" if each["driver"] else ""
        return "" if where == EVERYWHERE else f"{where}{follows}"

    places = _grouped(rows, lies)
    return [f"Where their readings are farthest from that of no. 1: {'; '.join(places)}."] if places else []


def _nearly_as_good(rows: Numbered, words: Vocabulary) -> list[str]:
    """Explanations that leave hardly more than the best one: how much worse each is, or why it does not count."""
    left_key = f"left_{words.ending}"
    nearer, balanced, unweighed = list[str](), list[int](), list[int]()
    weighed = any(each.get("probability") is not None for each in rows.values())
    for number, each in rows.items():
        if weighed and each.get("probability") is None and not each.get("balanced"):
            unweighed.append(number)
            continue
        if each["standing"] != "beaten" or amount(each, left_key) > rivals.ALIKE * amount(rows[1], left_key):
            continue
        if each["worse"] > 0.0:
            nearer.append(f"{number} by {times(math.sqrt(each['worse']))}")
        elif each.get("balanced"):
            balanced.append(number)
        elif each.get("probability") is None:
            unweighed.append(number)
    return [
        *([NEARER.format(listing(nearer), COUNTS)] if nearer else []),
        *([BALANCED.format(numbers(balanced))] if balanced else []),
        *([UNWEIGHED.format(numbers(unweighed))] if unweighed else []),
    ]


def _larger(content: Verdict, rows: Numbered, words: Vocabulary) -> list[str]:
    """What a larger explanation takes away beyond the one that it contains: too little for that much more."""
    sentences = []
    for number, each in rows.items():
        if each["standing"] == "not needed" and _worth(each):
            sentences += [f"{number} {_adds(each, rows, content, words)}."]
    return sentences


def _adds(larger: ExplanationEntry, rows: Numbered, content: Verdict, words: Vocabulary) -> str:
    """What a larger explanation adds to the best one that it contains, without a full stop."""
    ending, shown = words.ending, content["evidence"]["explanations"]
    smaller = [other for other in shown if set(other["ids"]) < set(larger["ids"]) and other["standing"] != "not needed"]
    base = min(smaller, key=lambda other: amount(other, f"left_{ending}"), default=None)
    if base is None:
        return "takes away too little for one effect more"
    row = next((str(number) for number, each in rows.items() if each is base), rivals.called(base["ids"]))
    adds = f"adds {listing([id_ for id_ in larger['ids'] if id_ not in base['ids']])} to {row}"
    exactly = [amount(each, f"left_{ending}") for each in (base, larger)]
    roughly = [left_with_discrepancy(each, ending) for each in (base, larger)]
    saved, surely = (math.sqrt(max(less**2 - more**2, 0.0)) for less, more in (exactly, roughly))
    if saved < ADDS * amount(content["evidence"], f"floor_{ending}"):
        return f"{adds}, which takes away nothing (less than {ADDS:g} times the noise)"
    more, sure = size(saved, words.unit), size(surely, words.unit)
    takes = f"{adds}, which takes away {more} rms more"
    if saved > VISIBLE * amount(content["evidence"], f"floor_{ending}") and surely < saved and more != sure:
        takes += f" (only {sure} are sure {rivals.ALLOWED[0].lower()}{rivals.ALLOWED[1:]})"
    kept = [other for other in rivals.entries(content, "tied") if len(other["ids"]) >= len(larger["ids"])]
    if any(amount(other, f"left_{ending}") >= amount(larger, f"left_{ending}") for other in kept):
        return f"{takes}; some that are likely leave as much, and are ranked before it all the same"
    return f"{takes}: too little for {'one effect' if len(larger['ids']) - len(base['ids']) == 1 else 'so many'} more"


def _allowed(content: Verdict, kept: Numbered, rows: Numbered, words: Vocabulary) -> list[str]:
    """What each kept explanation would leave if its formulas were a little wrong, and which others come to the noise.

    Nothing where that is no less.
    """
    if rivals.all_below_noise(content, words.ending):
        return []
    ratios = {number: rivals.with_discrepancy(each, content, words) for number, each in kept.items()}
    leaves = [f"{number} leaves {times(ratio)}" for number, ratio in ratios.items() if ratio is not None]
    allowed = [f"{rivals.ALLOWED}, {listing(leaves)} times the noise."] if leaves else []
    near = only_if_wrong(content, rows, words)
    if near:
        leave = f"{numbers(near)} {'leave' if len(near) > 1 else 'leaves'} no more than about the noise"
        stays = f"{leave}: {'they are' if len(near) > 1 else 'it is'} left out all the same"
        allowed.append(f"Then {stays}." if allowed else f"{rivals.ALLOWED}, {stays}.")
    return allowed


def only_if_wrong(content: Verdict, rows: Numbered, words: Vocabulary) -> list[int]:
    """Rows left out that would leave only noise if formulas err by 10 %; on rigs without probabilities."""
    if probability.known(content) or rivals.all_below_noise(content, words.ending):
        return []
    floor = amount(content["evidence"], f"floor_{words.ending}")
    return [
        number
        for number, each in rows.items()
        if each["standing"] == "beaten"
        and left_with_discrepancy(each, words.ending) <= rivals.NOISY * floor < amount(each, f"left_{words.ending}")
    ]


def _no_common(content: Verdict) -> list[str]:
    """The sentence that no effect is in all tied explanations, where the first line does not say so."""
    sets = [[entry["id"] for entry in content["mechanisms"]], *content["alternatives"]]
    every = dict.fromkeys(id_ for ids in sets for id_ in ids)
    most = max(every, key=lambda id_: sum(id_ in ids for ids in sets), default="")
    often = sum(most in ids for ids in sets)
    if len(sets) < 2 or often == len(sets):
        return []
    if 2 * often > len(sets) > 2:
        return [f"{often} of the {len(sets)} explanations have {most}; no mechanism is in all of them."]
    who = "two explanations have" if len(sets) == 2 else f"{len(sets)} explanations have"
    return [f"The {who} no mechanism in common: any of these effects may be the missing one."]
