"""What two explanations foretell of one stroke, and by how many times their plus-minus they differ."""

import math
from dataclasses import dataclass
from itertools import combinations

from ...document.content import Verdict
from ...document.expected import ExpectedExplanation
from ...document.made_keys import amount
from ..explanations import rivals
from ..held_out import unseen
from ..language.vocabulary import Vocabulary

LEAST = 0.01  # of a probability: less likely rivals stand only where no likelier one is, and without their percentage


@dataclass(frozen=True)
class Number:
    """A foretold number and half of its interval, in the unit of the reading; `known`: a fit gave the interval."""

    value: float
    half_width: float
    known: bool


def tells(row: list[Number | None]) -> float | None:
    """The largest difference of two explanations in units of both intervals; None if fewer than two have it."""
    values = [cell for cell in row if cell is not None]
    ratios = [
        abs(cell.value - other.value) / max(math.hypot(cell.half_width, other.half_width), 1e-300)
        for cell, other in combinations(values, 2)
    ]
    return max(ratios, default=None)


def of_explanation(explanation: ExpectedExplanation, key: str, content: Verdict, words: Vocabulary) -> Number | None:
    """A number of an explanation, by its key without the unit; None where it has no such number.

    Of an older file the error on unseen strokes stands for its interval.
    """
    key = f"{key}_{words.ending}"
    if key not in explanation:
        return None
    spread = explanation.get("plus_minus", {}).get(key)
    usual = error(content, words) / math.sqrt(2.0)  # of two, as much as the simulator errs by
    return Number(amount(explanation, key), usual if spread is None else spread, spread is not None)


def error(content: Verdict, words: Vocabulary) -> float:
    """The error of the explained simulator on strokes that no fit has seen, or the noise."""
    noise, unseen_errors = amount(content["fit"], f"noise_floor_{words.ending}"), unseen.errors(content, words)
    return float(max(unseen_errors[2], noise) if unseen_errors else noise)


def compared(content: Verdict) -> list[ExpectedExplanation]:
    """The best explanation, then its rivals in the order of their probability.

    Where one is likely, those that are not are left out. Those that only add to the best one come last of equals.
    Nothing where nothing is foretold.
    """
    expected = content["evidence"].get("expected")
    if not expected:
        return []
    first, *others = expected["explanations"]
    likely = [other for other in others if (probability(content, other["ids"]) or 0.0) >= LEAST]
    first_ids = set(first["ids"])
    return [
        first,
        *sorted(
            likely or others,
            key=lambda other: (-(probability(content, other["ids"]) or 0.0), first_ids <= set(other["ids"])),
        ),
    ]


def probability(content: Verdict, ids: list[str]) -> float | None:
    """The probability of an explanation; None where none is known."""
    same_ids = [each for each in content["evidence"]["explanations"] if set(each["ids"]) == set(ids)]
    return same_ids[0].get("probability") if same_ids else None


def apart(first: ExpectedExplanation, other: ExpectedExplanation) -> tuple[str, str]:
    """The names of two explanations without what both share, or in full where one would have no name left."""
    both = set(first["ids"]) & set(other["ids"])
    cut = set() if both in (set(first["ids"]), set(other["ids"])) else both
    names = [rivals.called([id_ for id_ in each["ids"] if id_ not in cut]) for each in (first, other)]
    return names[0], names[1]
