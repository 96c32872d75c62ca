"""Play and stops, whose flanks and faces are populations of contacts; and the drive line's own twist."""

import numpy as np
from scipy.stats import norm

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.kinetics.bench import Bench
from pipeline.rig.authors.kinetics.elements import sliders
from pipeline.rig.authors.kinetics.law import Law, Parameters
from pipeline.rig.authors.kinetics.populations import quantiles, weibull

# --- backlash, whose size is half the play in turns


def _played(now: Array, halves: Array) -> Array:
    """The twist minus what plays of these half widths keep from it, each an equal share."""
    return np.asarray(-sliders(now, halves, np.full(len(halves), 1.0 / len(halves)), np.ones(len(now))))


def hard_flanks(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """One play with hard flanks."""
    return _played(now, np.array([size]))


def rough_flanks(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Rough flanks touch summit by summit, Gaussian about the mean play."""
    return _played(now, size * (1.0 + p["rough"] * norm.ppf(quantiles(15))))


def worn_flanks(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Worn flanks: a sharp least play, and an exponential tail of contacts that come late."""
    return _played(now, size * (1.0 - p["tail"] * np.log1p(-quantiles(15))))


# --- wind-up of the shaft, whose size is the turns at the greatest torque of the median load


def steel_shaft(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A slender shaft twists in proportion to the torque."""
    return np.asarray(-size * bench.torque)


def summit_coupling(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Keyed faces with exponential summits approach by the log of the torque: they harden."""
    return np.asarray(-size * np.log1p(bench.torque / p["held"]) / np.log1p(1.0 / p["held"]))


def rubber_chains(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A rubber coupling hardens as its chains straighten: Langevin's function of the torque."""
    pull = p["pull"] * np.maximum(bench.torque, 1e-6)
    full = 1.0 / np.tanh(p["pull"]) - 1.0 / p["pull"]
    return np.asarray(-size * (1.0 / np.tanh(pull) - 1.0 / pull) / full)


# --- slack, whose size is the contraction lost in mm


def _risen(bench: Bench, now: Array) -> Array:
    """Contraction above that of the lowest twist."""
    return np.maximum(now - float(bench.contraction_mm.min()), 0.0)


def one_length(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Strands all too long by the same length: nothing moves until it is wound up."""
    return np.asarray(-np.minimum(_risen(bench, now), size))


def many_lengths(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Fibres too long by Weibull-distributed lengths come taut one after another."""
    lengths = weibull(32, size, p["shape"])
    risen = _risen(bench, now)
    return np.asarray(-np.mean([np.minimum(risen, length) for length in lengths], axis=0))


def sagging(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Sag goes with the inverse square of the pull, which grows as the twist takes it up."""
    return np.asarray(-size * (1.0 - 1.0 / np.square(1.0 + _risen(bench, now) / (p["reach"] * size))))


# --- end stop, whose size is how far below the top it stands in mm


def _beyond(bench: Bench, now: Array, size: float) -> Array:
    return np.maximum(now - (float(bench.contraction_mm.max()) - size), 0.0)


def hard_stop(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A stiff stop lets nothing past."""
    return -_beyond(bench, now, size)


def foam_cells(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Foam whose cells collapse at distributed loads gives by the log of the overrun."""
    past = _beyond(bench, now, size)
    return np.asarray(p["cell_mm"] * np.log1p(past / p["cell_mm"]) - past)


def hertz_bumper(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A round bumper gives by the two thirds power of the force that the overrun stands for."""
    past = _beyond(bench, now, size)
    return np.asarray(1.5 * p["soft_mm"] * ((1.0 + past / p["soft_mm"]) ** (2.0 / 3.0) - 1.0) - past)


BACKLASH = (
    Law("hard_flanks", "twist", 3.0, hard_flanks, still=True),
    Law("rough_flanks", "twist", 3.0, rough_flanks, {"rough": (0.15, 0.4)}, still=True),
    Law("worn_flanks", "twist", 3.0, worn_flanks, {"tail": (0.2, 0.5)}, still=True),
)
WINDUP = (
    Law("steel_shaft", "twist", 8.0, steel_shaft),
    Law("summit_coupling", "twist", 8.0, summit_coupling, {"held": (0.05, 0.5)}),
    Law("rubber_chains", "twist", 8.0, rubber_chains, {"pull": (1.0, 4.0)}),
)
SLACK = (
    Law("one_length", "contraction", 8.0, one_length, still=True),
    Law("many_lengths", "contraction", 8.0, many_lengths, {"shape": (1.5, 5.0)}, still=True),
    Law("sagging", "contraction", 8.0, sagging, {"reach": (0.5, 2.0)}, still=True),
)
END_STOP = (
    Law("hard_stop", "contraction", 25.0, hard_stop, still=True),
    Law("foam_cells", "contraction", 25.0, foam_cells, {"cell_mm": (0.1, 0.6)}, still=True),
    Law("hertz_bumper", "contraction", 25.0, hertz_bumper, {"soft_mm": (0.02, 0.2)}, still=True),
)
