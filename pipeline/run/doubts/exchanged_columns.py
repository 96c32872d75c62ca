"""Two columns of a string's recording that are exchanged: they fit the string the other way round."""

import itertools
from collections.abc import Sequence

from ...ground.kinematics import Array, Geometry, Places
from ...ground.units import conversion
from ..description import Channel, Run
from .recorded_curve import AS_LIKELY, DOUBT_RATIO, LIKELY, Curve, Readings

PAIRS = (("displacement_mm", "load_n"), ("motor_turns", "displacement_mm"))
LEAST_TURNS = 0.05  # of twist: less is no stroke
Pair = tuple[str, str]


class Exchanged:
    """Samples with the columns of two channels exchanged; `factor` is the ratio of the first unit to the second.

    `sign` is that of the displacement then: -1 if the sensor counts the other way.
    """

    def __init__(self, samples: Readings, pair: Pair, factor: float = 1.0, sign: float = 1.0) -> None:
        first, second = pair
        self._samples = samples
        self._from = {first: (second, factor), second: (first, 1.0 / factor)}
        source, by = self._from["displacement_mm"]
        self._from["displacement_mm"] = (source, sign * by)

    def __len__(self) -> int:
        """How many there are."""
        return len(self._samples)

    def _of(self, name: str) -> tuple[str, float]:
        return self._from.get(name, (name, 1.0))

    def at(self, name: str, places: Places) -> Array:
        """Values of a channel in some samples, in its unit; shape (places,)."""
        source, factor = self._of(name)
        return self._samples.at(source, places) * factor

    def percentiles(self, name: str, q: Sequence[float]) -> Array:
        """Percentiles `q` of a channel, in its unit; shape (q,)."""
        source, factor = self._of(name)
        values = self._samples.percentiles(source, q if factor > 0 else [100 - each for each in q])
        return values * factor

    def median(self, name: str) -> float:
        """Median of a channel, in its unit."""
        source, factor = self._of(name)
        return self._samples.median(source) * factor


def as_exchanged(run: Run, samples: Readings, pair: Pair, sign: float = 1.0) -> Exchanged:
    """The samples of a run as they are if the columns of two channels are exchanged, each in its channel's unit."""
    return Exchanged(samples, pair, _unit(run, pair[0]) / _unit(run, pair[1]), sign)


def exchanged(run: Run, samples: Readings, base: Geometry) -> Pair | None:
    """The two channels of a string run whose columns are exchanged, whatever sign they have; None where none are."""
    as_it_stands = Curve(samples, base)
    if follows(as_it_stands):
        return None
    misfit = as_it_stands.misfit()
    for pair, sign in itertools.product(PAIRS, (1.0, -1.0)):
        curve = Curve(as_exchanged(run, samples, pair, sign), base)
        is_stroke = curve.high - curve.low >= LEAST_TURNS
        if is_stroke and _passes(curve) and AS_LIKELY * curve.misfit() <= min(LIKELY, misfit):
            return pair
    return None


def exchange(pair: Pair) -> str:
    """The mend of two such channels."""
    first, second = pair
    reads = "load_n reads as the displacement would"
    if "load_n" not in pair:
        reads = f"{first} reads as {second} would, and {second} as {first}"
    return f"{reads}: exchange the columns of {first} and {second}"


def follows(curve: Curve) -> bool:
    """Whether a recorded curve is that of its string, about."""
    return _passes(curve) and curve.misfit() <= LIKELY


def _passes(curve: Curve) -> bool:
    return 1.0 / DOUBT_RATIO <= curve.ratio() <= DOUBT_RATIO


def _unit(run: Run, name: str) -> float:
    """The factor that a channel's own column is multiplied by."""
    channel = run.channels.get(name, Channel.model_validate({}))
    try:
        return conversion(name, channel.unit, channel.counts_per_turn)[0] * channel.scale or 1.0
    except ValueError:
        return 1.0
