"""Where frames were lost: after how many samples, at what time, and in which strokes."""

from math import inf

from ..run.capture_json import Lost
from ..wire import Account, Event, Gap

LISTED = 1000  # so many places are named; all are counted


def _strokes(account: Account, gap: Gap, planned: int) -> tuple[int, ...]:
    """Strokes in which, by the events that did come, the frames of a gap can lie.

    An event that was lost itself is in the same gap, so its neighbours bound it.
    """
    low_s = -inf if gap.after_s is None else gap.after_s
    high_s = inf if gap.until_s is None else gap.until_s
    first, last = 1, planned
    for event in account.events:
        if event.code not in (Event.STROKE_START, Event.STROKE_END):
            continue
        starts = event.code == Event.STROKE_START
        if event.time_s <= low_s:
            first = event.value if starts else event.value + 1
        elif event.time_s >= high_s:
            last = event.value - 1 if starts else event.value
            break
    return tuple(range(first, min(last, first + 999) + 1))


def locate(account: Account, planned: int) -> list[Lost]:
    """The first losses of a recording of so many planned strokes; frames that only came out of order are none."""
    return [
        {
            "after_samples": gap.after_samples,
            "after_s": None if gap.after_s is None else round(gap.after_s, 6),
            "frames": gap.frames,
            "strokes": _strokes(account, gap, planned),
        }
        for gap in account.gaps[:LISTED]
    ]
