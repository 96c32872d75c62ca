"""The signs of an explanation, gathered into the few aspects that a person weighs; which of them count against one."""

from ..document.explanations import Cause
from ..numerics.judge import Judge, Weighed

CHIEF = 2  # aspects that are kept for each explanation
SIGNS = {
    "fit": (
        "gain", "behind_1", "behind_2", "behind_3",
        "left_share", "left_floors", "left_behind_1", "left_behind_2", "left_behind_3",
        "left_of_own", "mismatch_floors",
    ),
    "numbers": ("numbers",),
    "weakest": ("weakest_share", "weakest_floors", "weakest_gain", "weakest_completes"),
    "instead": ("instead",),
    "more": ("more_share", "more_floors", "more_gain", "more_completes"),
    "cancels": ("cancels",),
    "signature": ("alike", "alike_else"),
}  # of each aspect; the first tells which way it points  # fmt: skip
MARKS = ("with_", "without_")  # of a mechanism, whose id follows


def aspect_of(sign: str) -> str:
    """The aspect of a sign: one of `SIGNS` or `mark_<id>`; a name that is no sign is its own aspect."""
    for start in MARKS:
        if sign.startswith(start):
            return f"mark_{sign.removeprefix(start)}"
    return next((aspect for aspect, signs in SIGNS.items() if sign in signs), sign)


def by_aspect(judge: Judge, rival: Weighed, best: Weighed) -> dict[str, float]:
    """What each aspect adds to the log of the odds of `rival` against `best`; the parts add up to the whole."""
    lead_by_aspect: dict[str, float] = {}
    for sign, part in judge.because(rival, best).items():
        lead_by_aspect[aspect_of(sign)] = lead_by_aspect.get(aspect_of(sign), 0.0) + part
    return lead_by_aspect


def chief(judge: Judge, rival: Weighed, best: Weighed) -> list[Cause]:
    """The aspects that count most against an explanation: `log_odds`, and by how much the first sign is `more`."""
    leads = sorted(by_aspect(judge, rival, best).items(), key=lambda item: item[1])
    return [
        {"aspect": aspect, "log_odds": part, "more": _lead(aspect, rival) - _lead(aspect, best)}
        for aspect, part in leads[:CHIEF]
        if part < 0.0
    ]


def _lead(aspect: str, rival: Weighed) -> float:
    """The sign that tells which way an aspect points; for an aspect without signs, the number of effects."""
    if aspect.startswith("mark_"):
        return float(aspect.removeprefix("mark_") in rival.ids)
    return rival.signs.get(SIGNS[aspect][0], 0.0) if aspect in SIGNS else float(len(rival.ids))
