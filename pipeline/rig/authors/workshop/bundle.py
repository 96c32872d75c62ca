"""The bundle's radius: tabulated against twist and squeeze, and worn by a tally of travel."""

from itertools import pairwise

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.workshop.bench import Bench, Law, Part
from pipeline.rig.authors.workshop.curves import drawn_curve, unit
from pipeline.rig.authors.workshop.memory import heading

MOST = 0.4


def _thinned(size: str, shape: Array, **parameters: float) -> Part:
    """A radius that a share of the shape takes away."""
    return Part("radius", size, MOST, lambda amount, now: now * (1.0 - amount * shape), parameters)


def micrometer_table(bench: Bench, rng: np.random.Generator) -> Part:
    """Radius under the micrometer at each tenth of the twist."""
    bend, power = rng.uniform(-2.0, 2.0), rng.uniform(0.0, 0.4)
    table = drawn_curve(rng, bend, 8)
    shape = table(bench.turns / bench.turns.max()) * bench.load_ratio**power
    return _thinned("radius_lost", shape, bend=bend, load_power=power)


def squeeze_gauge(bench: Bench, rng: np.random.Generator) -> Part:
    """Radius against the squeeze of the strands on each other; half of the give is gone at a half squeeze."""
    squeeze = bench.load_ratio * np.square(np.sin(bench.helix_rad))
    half = rng.uniform(0.3, 1.5) * squeeze.max()
    return _thinned("radius_lost", squeeze / (squeeze + half), half_squeeze=half)


def air_then_fibre(bench: Bench, rng: np.random.Generator) -> Part:
    """First the air goes out of the bundle, then the fibres themselves give: two straight lines with a knee."""
    knee, second = rng.uniform(0.25, 0.65), rng.uniform(0.1, 0.3)
    height = bench.turns / bench.turns.max()
    shape = (np.minimum(height, knee) + second * np.maximum(height - knee, 0.0)) / (knee + second * (1.0 - knee))
    return _thinned("radius_lost", shape, knee=knee, second_slope=second)


def _worn(bench: Bench, rng: np.random.Generator, worn: Array, **parameters: float) -> Part:
    """Wear thins the bundle, and seldom frays it thicker."""
    sign = -1.0 if rng.random() < 0.2 else 1.0
    return _thinned("radius_worn", sign * unit(worn), sign=sign, **parameters)


def tally_of_half_cycles(bench: Bench, rng: np.random.Generator) -> Part:
    """Every half cycle counts by its range to a power, booked evenly over its way."""
    power = rng.uniform(1.5, 4.0)
    way = heading(bench.turns)
    edges = [0, *(np.flatnonzero(np.diff(way) != 0.0) + 1).tolist(), len(way)]
    booked = np.abs(np.diff(bench.turns, prepend=bench.turns[0])) / np.ptp(bench.turns)
    for first, end in pairwise(edges):
        booked[first:end] *= float(booked[first:end].sum()) ** (power - 1.0)
    return _worn(bench, rng, np.cumsum(booked), range_power=power)


def running_in_sheet(bench: Bench, rng: np.random.Generator) -> Part:
    """A sheet over the way travelled: quick while it runs in, then even."""
    bend, share = rng.uniform(4.0, 9.0), rng.uniform(0.3, 0.7)
    sheet, way = drawn_curve(rng, bend, 9), bench.travel / bench.travel[-1]
    return _worn(bench, rng, share * sheet(way) + (1.0 - share) * way, bend=bend, running_in=share)


def load_times_way(bench: Bench, rng: np.random.Generator) -> Part:
    """Load times sliding way, where strands slide more the more they lean."""
    lean = rng.uniform(0.5, 1.5)
    sliding = np.abs(np.diff(bench.turns, prepend=bench.turns[0])) * np.tan(bench.helix_rad) ** lean
    return _worn(bench, rng, np.cumsum(bench.load_ratio * sliding), lean_power=lean)


COMPACTION: tuple[Law, ...] = (micrometer_table, squeeze_gauge, air_then_fibre)
WEAR: tuple[Law, ...] = (tally_of_half_cycles, running_in_sheet, load_times_way)
