"""The signs of an explanation, gathered into the few aspects that a person weighs; which of them count against one."""

from typing import Any

from .judge import Judge, Weighed

CHIEF = 2  # aspects that are kept for each explanation
SIGNS = {
    "fit": (
        "gain", "behind_1", "behind_2", "behind_3",
        "left_share", "left_floors", "left_behind_1", "left_behind_2", "left_behind_3", "mismatch_floors",
    ),
    "numbers": ("numbers",),
    "weakest": ("weakest_share", "weakest_floors", "weakest_gain", "weakest_completes"),
    "instead": ("instead",),
    "more": ("more_share", "more_floors", "more_gain", "more_completes"),
    "cancels": ("cancels",),
}  # of each aspect; the first tells which way it points  # fmt: skip
MARKS = ("with_", "without_")  # of a mechanism, whose id follows


def aspect_of(sign: str) -> str:
    """The aspect that a sign belongs to: one of `SIGNS`, `mark_<id>`, or, of what is no sign, its own name."""
    for start in MARKS:
        if sign.startswith(start):
            return f"mark_{sign.removeprefix(start)}"
    return next((aspect for aspect, signs in SIGNS.items() if sign in signs), sign)


def by_aspect(judge: Judge, one: Weighed, best: Weighed) -> dict[str, float]:
    """What each aspect adds to the log of how much likelier `one` is than `best`; the parts add up to all of it."""
    found: dict[str, float] = {}
    for sign, part in judge.because(one, best).items():
        found[aspect_of(sign)] = found.get(aspect_of(sign), 0.0) + part
    return found


def chief(judge: Judge, one: Weighed, best: Weighed) -> list[dict[str, Any]]:
    """The aspects that count most against an explanation: `log_odds`, and by how much the first sign is `more`."""
    found = sorted(by_aspect(judge, one, best).items(), key=lambda item: item[1])
    return [
        {"aspect": aspect, "log_odds": part, "more": _lead(aspect, one) - _lead(aspect, best)}
        for aspect, part in found[:CHIEF]
        if part < 0.0
    ]


def _lead(aspect: str, one: Weighed) -> float:
    """The sign that tells which way an aspect points; of what is no sign, the number of effects."""
    if aspect.startswith("mark_"):
        return float(aspect.removeprefix("mark_") in one.ids)
    return one.signs.get(SIGNS[aspect][0], 0.0) if aspect in SIGNS else float(len(one.ids))
