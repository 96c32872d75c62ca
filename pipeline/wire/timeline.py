"""The times of a recording, by a device's clock that wraps: computed from runs of samples, not from each sample."""

from dataclasses import dataclass

import numpy as np

from .counters import Whole
from .frame_account import Event, Gap

# a run: frames whose numbers follow each other, all of them samples but for the last one, perhaps
FIRST, SAMPLES, FIRST_US, LAST_US, SPAN_US = range(5)


@dataclass(frozen=True)
class Timeline:
    """Runs that hold samples, in order, with their times since the first sample, in us: each array (runs,).

    `first` and `samples` are counts.
    """

    first: Whole
    begin_us: Whole
    end_us: Whole
    last_stamp: Whole
    first_stamp: int | None
    samples: Whole  # before each, and in all: (runs + 1,)

    @staticmethod
    def of(runs: Whole) -> "Timeline":
        """Unwrap the clock from run to run; `runs` are rows of counts and of times in us, shape (runs, columns)."""
        between = np.zeros(len(runs), np.int64)
        between[1:] = (runs[1:, FIRST_US] - runs[:-1, LAST_US] + 2**31) % 2**32 - 2**31
        end_us = np.cumsum(between + runs[:, SPAN_US])
        samples = np.append(0, np.cumsum(runs[:, SAMPLES]))
        first_stamp = int(runs[0, FIRST_US]) if len(runs) else None
        return Timeline(runs[:, FIRST], end_us - runs[:, SPAN_US], end_us, runs[:, LAST_US], first_stamp, samples)

    def time_s(self, run: int, at_us: Whole) -> float | None:
        """Begin or end of a run, None where there is none."""
        return float(at_us[run]) * 1e-6 if 0 <= run < len(at_us) else None

    def gap(self, first: int, frames: int) -> Gap:
        """The gap of so many frames that begins with number `first`."""
        run = int(np.searchsorted(self.first, first))
        return Gap(int(self.samples[run]), frames, self.time_s(run - 1, self.end_us), self.time_s(run, self.begin_us))

    def event(self, number: int, t_us: int, code: int, value: int) -> Event:
        """An event, timed by the wrapping clock near the sample before it."""
        run = int(np.searchsorted(self.first, number)) - 1
        near_us, stamp = (int(self.end_us[run]), int(self.last_stamp[run])) if run >= 0 else (0, self.first_stamp)
        step_us = 0 if stamp is None else (t_us - stamp + 2**31) % 2**32 - 2**31
        return Event((near_us + step_us) * 1e-6, code, value)
