"""Where frames were lost: after how many samples, at what time, and in which strokes."""

from dataclasses import dataclass

import numpy as np

from pipeline.wire import Event, Recording


@dataclass(frozen=True)
class Gap:
    """`frames` that were lost in one place; `strokes` by number, from 1, are those that it may touch."""

    after_samples: int
    after_s: float | None  # time of the sample before it; None before the first one
    frames: int
    strokes: tuple[int, ...]


def _strokes(recording: Recording, after_samples: int) -> tuple[int, ...]:
    """Strokes in which, by the events that did come, frames after so many samples can lie.

    An event that was lost itself is in the same gap, so its neighbours bound it.
    """
    time_s = recording.time_s
    low_s = time_s[after_samples - 1] if after_samples else -np.inf
    high_s = time_s[after_samples] if after_samples < len(time_s) else np.inf
    first, last = 1, recording.hello.strokes if recording.hello else 0
    for event in recording.events:
        if event.code not in (Event.STROKE_START, Event.STROKE_END):
            continue
        starts = event.code == Event.STROKE_START
        if event.time_s <= low_s:
            first = event.value if starts else event.value + 1
        elif event.time_s >= high_s:
            last = event.value - 1 if starts else event.value
            break
    return tuple(range(first, min(last, first + 999) + 1))


def locate(recording: Recording) -> list[Gap]:
    """Every loss of a recording; frames that only came out of order are none."""
    account = recording.account
    if not account.lost:
        return []
    gaps = []
    for after, frames in account.gaps:
        after_s = round(float(recording.time_s[after - 1]), 6) if after else None
        gaps.append(Gap(after, after_s, frames, _strokes(recording, after)))
    return gaps
