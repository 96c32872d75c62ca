"""What breaks took back of a model's error, as JSON."""

from typing import TypedDict

import numpy as np

from .stroke_health.recovery import Recovery


def finite(value: float, digits: int = 6) -> float | None:
    """A number for JSON: rounded, None for NaN and infinity."""
    return float(f"{value:.{digits}g}") if np.isfinite(value) else None


class BreakSaid(TypedDict):
    """A break after which the model's error had fallen back: before which run and stroke, from what to what."""

    run: str
    before_stroke: int
    error_before_mm: float | None
    error_after_mm: float | None


class RecoverySaid(TypedDict):
    """What breaks took back of the model's error: "none", "may be" or "recovers", of so many breaks."""

    state: str
    breaks_in_all: int
    breaks: list[BreakSaid]


def recovered(recovery: Recovery) -> RecoverySaid:
    """The breaks that took back a part of the model's error, and whether they tell that it recovers."""
    return {
        "state": "recovers" if recovery.is_known else "may be" if recovery.breaks else "none",
        "breaks_in_all": recovery.count,
        "breaks": [
            {
                "run": back.run,
                "before_stroke": back.stroke,
                "error_before_mm": finite(back.before_mm),
                "error_after_mm": finite(back.after_mm),
            }
            for back in recovery.breaks
        ],
    }
