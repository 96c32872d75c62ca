"""A recording's displacement over twist beside the analytic model's, and mistakes that would explain a difference."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from ...ground.kinematics import Array, Geometry, Places

DOUBT_RATIO = 1.8  # a simulated span so far off the recorded one may still be physics, but is questioned
LIKELY = 0.2  # of the span: a curve that a guess leaves further off is not what was recorded
AS_LIKELY = 2.0  # misfits within this factor of the best cannot be told apart,
SMALL = 0.04  # nor those below this share of the span
UNTWISTED_TURNS, UNTWISTED_SHARE = 1.0, 0.05  # so near 0 is 0: in turns, or of the range
POINTS = 2000


@dataclass(frozen=True)
class Guess:
    """A possible mistake in a recording: the factor to multiply by, the mend in words, and its field."""

    turns: float
    length: float
    field: str
    mend: str


class Readings(Protocol):
    """Samples in any form, as far as the checks ask for them."""

    def __len__(self) -> int:
        """How many there are."""

    def at(self, name: str, places: Places) -> Array:
        """Values of a channel in some samples, in its unit; shape (places,)."""

    def percentiles(self, name: str, q: Sequence[float]) -> Array:
        """Percentiles `q` of a channel, in its unit; shape (q,)."""

    def median(self, name: str) -> float:
        """Median of a channel, in its unit."""


class Curve:
    """A recording's displacement over twist, compared with the analytic model of its string."""

    def __init__(self, samples: Readings, base: Geometry) -> None:
        rows = np.unique(np.linspace(0, len(samples) - 1, POINTS).astype(int))
        self.turns = samples.at("motor_turns", rows)
        self.low, self.high = samples.percentiles("motor_turns", [1, 99])
        low_mm, high_mm = samples.percentiles("displacement_mm", [1, 99])
        self.measured_mm = np.clip(samples.at("displacement_mm", rows), low_mm, high_mm)
        self.span_mm = float(high_mm - low_mm)
        self.base, self.load_n = base, np.float64(samples.median("load_n"))

    def ratio(self, turns: float = 1.0, length: float = 1.0, offset_turns: float = 0.0) -> float:
        """Recorded span over the simulated one, factors and offset applied; NaN where a pair cannot be wound so far."""
        ends = np.array([max(self.low + offset_turns, 0.0), self.high + offset_turns]) * turns
        with np.errstate(all="ignore"):
            ends_mm = self.base.contraction_mm(ends, self.load_n)
            return float(self.span_mm * length / (ends_mm[1] - ends_mm[0]))

    def misfit(self, turns: float = 1.0, length: float = 1.0, offset_turns: float = 0.0) -> float:
        """The distance of the curve from the model's, zero apart, as a share of its span; infinite without a curve."""
        with np.errstate(all="ignore"):
            error_mm = self.measured_mm * length - self._model_mm(self.turns * turns + offset_turns)
            share = float(np.divide(np.std(error_mm), self.span_mm * length))
        return share if np.isfinite(share) else np.inf

    def _model_mm(self, turns: Array) -> Array:
        return self.base.contraction_mm(turns, self.load_n)

    @property
    def far(self) -> bool:
        """Whether the lowest twist is far from 0, the untwisted string."""
        return abs(self.low) > max(UNTWISTED_TURNS, UNTWISTED_SHARE * (self.high - self.low))

    def likely(self, guesses: list[Guess], best: float) -> list[Guess]:
        """The guesses with which the recording passes, and that fit about as well as the best, or as `best`."""
        good = [guess for guess in guesses if 1.0 / DOUBT_RATIO <= self.ratio(guess.turns, guess.length) <= DOUBT_RATIO]
        misfits = [self.misfit(guess.turns, guess.length) for guess in good]
        return [guess for guess, misfit in zip(good, misfits, strict=True) if misfit <= bound(min([best, *misfits]))]


def bound(best: float) -> float:
    """The misfit up to which a guess is as good as the best one."""
    return min(LIKELY, max(AS_LIKELY * best, SMALL))
