"""What gives way at once: contacts that stick and slip, twist that is lost, a clamp that lets the string through."""

import numpy as np
from scipy.special import expit

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.kinetics.bench import STEP_S, Bench
from pipeline.rig.authors.kinetics.elements import slipping
from pipeline.rig.authors.kinetics.law import Law, Parameters, crowd

# --- stick-slip, whose size is the held twist in turns


def weibull_release(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """One contact holds twist back until a Weibull-distributed bound, springs past its rest, and holds again."""
    bounds = size * crowd(p).weibull(p["shape"], 4096)
    return np.asarray(-slipping(now, bounds, p["drop"], 0.0, STEP_S))


def weakest_patch(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """The weakest of many patches starts each slip: bounds by Gumbel's law of least values."""
    bounds = size * np.clip(1.0 - p["scatter"] * crowd(p).gumbel(0.0, 1.0, 4096), 0.2, 2.0)
    return np.asarray(-slipping(now, bounds, p["drop"], 0.0, STEP_S))


def ageing_contact(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A contact strengthens with the log of its age, so that slow twisting slips further."""
    bounds = size * (1.0 + p["scatter"] * crowd(p).uniform(-1.0, 1.0, 4096))
    return np.asarray(-slipping(now, bounds, p["drop"], p["ageing"], STEP_S))


# --- moments at which something gives


def _moments(bench: Bench, p: Parameters, hazard: Array, count: int) -> list[int]:
    """Steps at which the hazard takes its toll, well inside the run."""
    inside = (bench.time_s > 0.15 * bench.time_s[-1]) & (bench.time_s < 0.75 * bench.time_s[-1])
    toll = np.cumsum(hazard * inside)
    return sorted(int(np.searchsorted(toll, place * toll[-1])) for place in crowd(p).uniform(0.02, 0.98, count))


def torque_beats_grip(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A set screw slips where the torque is extreme, a few times, each time by a share of its own."""
    lost = np.zeros(len(now))
    count = round(p["count"])
    shares = crowd(p).dirichlet(np.full(count, 3.0))
    for share, at in zip(shares, _moments(bench, p, np.exp(p["steep"] * bench.torque), count), strict=True):
        lost[at:] -= size * share
    return lost


def missed_steps(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A coupling jumps by whole teeth while it turns fast, always the same amount."""
    lost = np.zeros(len(now))
    count = round(p["count"])
    for at in _moments(bench, p, np.square(bench.rate), count):
        lost[at:] -= size / count
    return lost


def creeping_knot(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A knot turns through in a second or so, clicking, when the torque has worn its grip down."""
    at = _moments(bench, p, np.exp(6.0 * bench.torque), 1)[0]
    clicks = bench.time_s[at] + np.sort(crowd(p).gamma(2.0, 0.5 * p["takes_s"], 12))
    return np.asarray(-size * np.searchsorted(clicks, bench.time_s) / 12.0)


# --- clamp


def grip_lost(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """The clamp lets string through at once, once or twice, where the tension is great."""
    through = np.zeros(len(now))
    moments = _moments(bench, p, np.exp(3.0 * bench.tension), round(p["count"]))
    for share, at in zip((0.65, 0.35), moments, strict=False):
        through[at:] += size * share
    return through


def bundle_cascade(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Gripped fibres fail one by another's failing: a logistic rush within a second or two."""
    at = _moments(bench, p, np.exp(3.0 * bench.tension), 1)[0]
    return np.asarray(size * expit((bench.time_s - bench.time_s[at]) / p["rush_s"]))


def aftershocks(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A slip and its aftershocks, whose rate falls by Omori's law."""
    chance = crowd(p)
    at = _moments(bench, p, np.exp(3.0 * bench.tension), 1)[0]
    late_s = p["omori_s"] * np.expm1(chance.uniform(0.0, np.log1p(40.0 / p["omori_s"]), 10))
    parts = chance.dirichlet(np.full(10, 1.5))
    through = np.where(np.arange(len(now)) >= at, 0.6 * size, 0.0)
    for part, delay_s in zip(parts, late_s, strict=True):
        through += np.where(bench.time_s >= bench.time_s[at] + delay_s, 0.4 * size * part, 0.0)
    return through


STICK_SLIP = (
    Law("weibull_release", "twist", 6.0, weibull_release, {"shape": (2.0, 5.0), "drop": (1.3, 1.8)}, still=True),
    Law("weakest_patch", "twist", 6.0, weakest_patch, {"scatter": (0.08, 0.25), "drop": (1.2, 1.6)}, still=True),
    Law(
        "ageing_contact",
        "twist",
        6.0,
        ageing_contact,
        {"drop": (1.3, 1.8), "ageing": (0.05, 0.2), "scatter": (0.1, 0.4)},
        still=True,
    ),
)
COUNT_SLIP = (
    Law("torque_beats_grip", "twist", 8.0, torque_beats_grip, {"count": (1.0, 4.4), "steep": (3.0, 8.0)}, keeps=True),
    Law("missed_steps", "twist", 8.0, missed_steps, {"count": (1.0, 5.4)}, keeps=True),
    Law("creeping_knot", "twist", 8.0, creeping_knot, {"takes_s": (0.5, 1.5)}, keeps=True),
)
CLAMP_SLIP = (
    Law("grip_lost", "elongation", 12.0, grip_lost, {"count": (1.0, 2.4)}, keeps=True),
    Law("bundle_cascade", "elongation", 12.0, bundle_cascade, {"rush_s": (0.05, 0.3)}, keeps=True),
    Law("aftershocks", "elongation", 12.0, aftershocks, {"omori_s": (0.3, 3.0)}, keeps=True),
)
