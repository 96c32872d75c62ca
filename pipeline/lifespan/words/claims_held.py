"""How often the 90 % claims of each kind held in tests: the table "By kind of claim" of docs/lifespan.md.

It is of 120 synthetic strings of another hand, seed 4000, by which nothing was set;
python -m pipeline.lifespan.score prints it anew. A test holds these numbers to that page.
"""

from typing import NamedTuple

TESTED = "In our tests (120 synthetic strings)"
CAUTIOUS = 95.0  # per cent of the claims called 90 % that held, from which it is said
LATE = "asked at 75 % of the life"


class Held(NamedTuple):
    """Per cent of the claims that held, of all that could be judged and of those late in life; None: too few."""

    percent: float
    late_percent: float | None = None


HELD = {
    ("stroke_loss", "one-sided"): Held(98.9),
    ("stroke_loss", "interval"): Held(93.7, 92.8),
    ("model_error", "one-sided"): Held(98.5),
    ("model_error", "interval"): Held(89.6, 80.2),
}
KINDS = {"one-sided": 'such an "at least"', "interval": "such an interval"}


def measured(question: str, state: str) -> str:
    """The sentence that stands beside a claim: how often claims of its kind held."""
    tested = HELD.get((question, state))
    if tested is None:
        return f"{TESTED} too few claims of this kind could be judged."
    late = "" if tested.late_percent is None else f", {LATE} in {tested.late_percent:.0f}"
    cautious = ": so the bound is cautious" * (tested.percent >= CAUTIOUS)
    return f"{TESTED} {KINDS[state]} held in {tested.percent:.0f} of 100 cases that could be judged{late}{cautious}."
