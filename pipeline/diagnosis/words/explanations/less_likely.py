"""How much less likely rivals are than the best explanation: a table, then the reason that most share, then others."""

from collections import Counter

from ...document.content import Part, Verdict
from ..language.quantity import percent, size, times
from ..language.table import aligned
from ..language.vocabulary import Vocabulary
from . import probability
from .reasons import chiefly, less_often
from .rivals import called, left_of

HEAD = ["explanation", "probability", "leaves (× noise)", "times less likely"]
BEST = "the best one"
MOST_SHARE = "Why less likely, where nothing else is said: {}."
LEAST = 1e-6  # what a probability of nothing is said as: less than 1 %
FEWEST = 2  # explanations that share a reason, to say it of all


def table(explanations: list[Part], best: Part, content: Verdict, words: Vocabulary) -> list[str]:
    """The best explanation and its rivals, a row each, then why they are less likely; all have a probability."""
    rows = [_row(best, BEST, content, words)]
    rows += [_row(each, less_often(each, best), content, words) for each in explanations]
    return [*aligned([HEAD, *rows]), *_reasons(explanations, best)]


def _row(explanation: Part, less: str, content: Verdict, words: Vocabulary) -> list[str]:
    left, floor = left_of(explanation, content, words.ending), content["evidence"][f"floor_{words.ending}"]
    cell = f"{size(left, words.unit)} ({times(left / floor)})"
    return [called(explanation["ids"]), percent(explanation["probability"] or LEAST), cell, less]


def _reasons(explanations: list[Part], best: Part) -> list[str]:
    """The reason that most share, once, then those of the others, one by one."""
    why = {called(each["ids"]): _reason(each, best) for each in explanations}
    shared, count = next(iter(Counter(reason for reason in why.values() if reason).most_common(1)), ("", 0))
    if count < FEWEST:
        shared = ""
    once = [MOST_SHARE.format(shared)] if shared else []
    return once + [f"{name}: {reason}." for name, reason in why.items() if reason and reason != shared]


def _reason(explanation: Part, best: Part) -> str:
    """Why a rival is less likely; nothing where no reason is known."""
    if explanation["probability"] == 0.0:
        return probability.LARGER_LEAVES_LESS
    return chiefly(explanation) if less_often(explanation, best) else ""


def known(explanations: list[Part], best: Part | None, content: Verdict) -> bool:
    """Whether a table can be made: each has a probability, as the best one has."""
    shares = [each.get("probability") for each in [*explanations, *([best] if best else [])]]
    return bool(explanations and best and probability.known(content) and None not in shares)
