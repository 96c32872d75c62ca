"""What breaks took back of a model's error, in words: that it recovers and is no wear, or may be none."""

import math

from ..stroke_health.recovery import Recovery

AS_WEAR = "The forecast takes it for wear, so half of the futures may pass the limit far too early."
AS_RECOVERY = "The forecast counts as wear only what stays after the breaks; the rest comes back in each run."


def recovery_line(recovery: Recovery, is_foretold: bool, rest_min: float) -> str:
    """One line on what the breaks took back, and which recording would tell; empty where they took back nothing.

    `is_foretold`: whether a forecast stands beside it; `rest_min` how many minutes of rest would tell.
    """
    if not recovery.breaks:
        return ""
    if recovery.is_known:
        most = f"in {len(recovery.breaks)} of {recovery.count} breaks"
        line = f"Recovery: {most} that error fell back, by {recovery.middle_mm:.2g} mm in the median. "
        return f"{line}That recovers at rest, as creep does, and is no wear.{f' {AS_RECOVERY}' * is_foretold}"
    return (
        f"Recovery: {fell(recovery)}. It may be creep, which recovers at rest, and no wear; {_few(recovery)} to tell."
        f"{f' {AS_WEAR}' * is_foretold} A run under the same load after a rest of {minutes(rest_min)} or more would "
        "tell."
    )


def fell(recovery: Recovery) -> str:
    """By how much the error fell in the first break that took a part of it back."""
    back = recovery.breaks[0]
    return (
        f"in the break before stroke {back.stroke} that error fell from {back.before_mm:.2g} to {back.after_mm:.2g} mm"
    )


def head(recovery: Recovery) -> str:
    """The line over the picture; empty where the breaks took back nothing."""
    if not recovery.breaks:
        return ""
    if recovery.is_known:
        return f"Falls back in breaks by {recovery.middle_mm:.2g} mm: creep that recovers, and no wear"
    back = recovery.breaks[0]
    moved = f"from {back.before_mm:.2g} to {back.after_mm:.2g} mm in the break before stroke {back.stroke}"
    return f"Fell {moved}: may be creep that recovers, and no wear"


def minutes(rest_min: float) -> str:
    """A time of rest, rounded up to whole minutes."""
    count = max(math.ceil(rest_min), 1)
    return f"{count} minute{'s' * (count > 1)}"


def _few(recovery: Recovery) -> str:
    count = recovery.count
    if recovery.is_usual:
        return "the runs are too short"
    return "one break is too few" if count == 1 else f"{len(recovery.breaks)} of {count} breaks are too few"
