"""Statistics of a recording's time stamps, from one pass over them and a median."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...ground.kinematics import Array
from ...ground.numbers import quantiles
from ...ground.stored.rows import Rows


def _steps_s(time_s: Array) -> Array:
    with np.errstate(over="ignore"):
        return np.diff(time_s)


@dataclass(frozen=True)
class Clock:
    """Steps in s from each sample to the next: the least, the most and the usual one.

    `wrong` of them are not above 0, the first after sample `first_wrong` (from 0). The longest is the one after sample
    `leap`, with the stamps `leap_s` before and after it.
    """

    least_s: float
    most_s: float
    usual_s: float
    wrong: int
    first_wrong: int
    leap: int
    leap_s: tuple[float, float]

    @staticmethod
    def of(samples: Rows) -> "Clock":
        """The clock of two samples or more."""
        last = len(samples) - 1
        spans = [(first, min(stop, last)) for first, stop in samples.spans if first < last]

        def steps() -> Iterator[Array]:
            return (_steps_s(samples.read("time_s", first, stop + 1)) for first, stop in spans)

        least, most, wrong, first_wrong, leap = np.inf, -np.inf, 0, 0, 0
        for (first, _), step_s in zip(spans, steps(), strict=True):
            bad = np.flatnonzero(step_s <= 0)
            first_wrong = first + int(bad[0]) if len(bad) and not wrong else first_wrong
            wrong += len(bad)
            if step_s.max() > most:
                most, leap = float(step_s.max()), first + int(np.argmax(step_s))
            least = min(least, float(step_s.min()))
        before, after = samples.read("time_s", leap, leap + 2).tolist()
        return Clock(least, most, quantiles.median(steps, last), wrong, first_wrong, leap, (before, after))
