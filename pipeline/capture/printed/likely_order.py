"""The order of unnamed columns, by their numbers: in which one the time goes on and the string moves as it should."""

from collections.abc import Iterator, Sequence
from itertools import permutations
from pathlib import Path

import numpy as np

from ...ground.kinematics import Array, Places
from ...ground.units import conversion
from ...run.description import STRING_ACTUATORS, Channel
from ...run.dimensions import geometry
from ...run.doubts.exchanged_columns import follows
from ...run.doubts.recorded_curve import AS_LIKELY, SMALL, Curve
from ...run.table.rate import is_rate
from .naming import NEEDED
from .read_channels import ReadChannels

MOST_NAMES = 5  # of more columns too many orders are alike
LEAST_TURNS, LEAST_SPAN_MM = 3.0, 2.0  # of twist and contraction, by which the order is judged
LEAST_ROWS, KEPT = 20, 500  # lines that are kept; of more every second is left out


class Kept:
    """A selection of the lines of as many numbers each; `every` so many lines one is kept."""

    def __init__(self) -> None:
        self.rows: list[list[str]] = []
        self.every = self._passed = 1

    def take(self, row: list[str]) -> None:
        """Keep a line, if it is its turn."""
        self._passed -= 1
        if self._passed:
            return
        self.rows.append(row)
        if len(self.rows) > KEPT:
            self.rows, self.every = self.rows[::2], 2 * self.every
        self._passed = self.every


class Read:
    """The kept lines as channels in our units, each of shape (lines,)."""

    def __init__(self, values: dict[str, Array]) -> None:
        self._values = values

    def __len__(self) -> int:
        """How many lines there are."""
        return len(self._values["motor_turns"])

    def at(self, name: str, places: Places) -> Array:
        """Values of a channel in some lines, in its unit; shape (places,)."""
        return self._values[name][places]

    def percentiles(self, name: str, q: Sequence[float]) -> Array:
        """Percentiles `q` of a channel, in its unit; shape (q,)."""
        return np.percentile(self._values[name], q)

    def median(self, name: str) -> float:
        """Median of a channel, in its unit."""
        return float(np.median(self._values[name]))


def likely_order(folder: Path, names: Sequence[str], kept: Kept) -> tuple[str, ...]:
    """The names of a run's columns in the one order that fits the numbers; empty where none does, or several do."""
    if len(names) > MOST_NAMES or len(kept.rows) < LEAST_ROWS:
        return ()
    misfits = sorted(_misfits(folder, names, kept))
    if not misfits or (len(misfits) > 1 and misfits[1][0] <= max(AS_LIKELY * misfits[0][0], SMALL)):
        return ()
    return misfits[0][1]


def _misfits(folder: Path, names: Sequence[str], kept: Kept) -> Iterator[tuple[float, tuple[str, ...]]]:
    """How far the motion is from that of the run's string, as a share of its span, in each order that can be."""
    channels = ReadChannels(folder, names)
    run, channel_of = channels.run, {column: place.channel for column, place in channels.places.items()}
    if (
        run is None
        or run.actuator not in STRING_ACTUATORS
        or not {*run.system.columns[:NEEDED]} <= {*channel_of.values()}
    ):
        return
    lines = np.array(kept.rows, dtype=float)
    in_our_units: dict[str, tuple[float, float]] = {}
    for column, place in channels.places.items():
        own = run.channels.get(place.channel, Channel.model_validate({}))
        try:
            factor, shift = conversion(place.channel, place.unit, own.counts_per_turn)
        except ValueError:
            return
        in_our_units[column] = factor * own.scale, factor * own.offset + shift
    base, load_n = geometry(run), np.full(len(lines), run.rig.get("load_n", 0.0))
    for order in permutations(names):
        values = {"load_n": load_n}
        for column, (factor, shift) in in_our_units.items():
            values[channel_of[column]] = factor * lines[:, order.index(column)] + shift
        steps_s = np.diff(values["time_s"])
        if not (steps_s > 0).all() or not is_rate(float(np.median(steps_s)) / kept.every):
            continue
        curve = Curve(Read(values), base)
        moves = curve.high - curve.low >= LEAST_TURNS and curve.span_mm >= LEAST_SPAN_MM
        if moves and curve.load_n >= 0 and follows(curve):
            yield curve.misfit(), order
