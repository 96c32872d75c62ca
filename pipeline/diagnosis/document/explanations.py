"""Parts of a diagnosis that say how explanations stand beside each other, and what speaks against effects."""

from typing import NotRequired, TypedDict

from .effects_named import Location


class Cause(TypedDict):
    """One aspect that counts against an explanation."""

    aspect: str
    log_odds: float  # what it adds to the logarithm of how much likelier the explanation is than the best
    more: float  # by how much the aspect's first sign is larger than the best one's


class ExplanationEntry(TypedDict):
    """An explanation that was weighed; made keys, rms in the reading's unit: what it leaves, `left_…`.

    `approximated_…` what the search took that for, `with_discrepancy_…` what it leaves where formulas may be a little
    wrong, `gap_…` how far it differs from the best.
    """

    ids: list[str]
    standing: str  # nothing, named, tied, beaten, not needed or not enough
    probability: NotRequired[float | None]
    worse: NotRequired[float]  # minus twice the logarithm of how much likelier it is than the best
    because: NotRequired[list[Cause] | None]
    location: NotRequired[Location]  # of the gap
    driver: NotRequired[str | None]  # that the gap follows
    balanced: NotRequired[bool]  # whether parts of it cancel each other


class LeftOut(TypedDict):
    """An explanation that was likely and is no name."""

    ids: list[str]
    because: str
    of: list[str]
    probability: NotRequired[float | None]


class Change(TypedDict):
    """By how much a signal changes in a stand, on average, and the standard error of that, in the reading's unit."""

    change: float
    error: float
    count: int  # of stands


class Stood(TypedDict):
    """By how much the residual of a tied explanation changes while the motor stands, by `hold` and `rest`."""

    ids: list[str]
    stands: dict[str, Change]


class NotKept(TypedDict):
    """What speaks against an effect; made keys, rms in the reading's unit: `left_…` with it in place of the best.

    `beside_…`: with it beside the best. The entry without an `id` is the best explanation's own.
    """

    id: str | None
    stands: dict[str, Change] | None  # by `hold` and `rest`
    tied: NotRequired[list[Stood]]
    likely: NotRequired[float]  # a probability
    possible: NotRequired[bool]
    instead: NotRequired[list[str] | None]  # the effects of the explanation in place of the best


def share_of(explanation: ExplanationEntry | LeftOut) -> float:
    """The probability of an explanation, from 0 to 1; 0 where nobody weighed it."""
    return explanation.get("probability") or 0.0
