"""Small helpers that mechanisms share: growth laws, hinges, grids of candidates. They know no mechanism."""

import numpy as np

from ...ground.kinematics import Array
from ..numerics.recursions import lowpass
from ..recording.drivers import Drivers
from .interface import Nonlinear

BESIDE, SEEN = 4, 14  # samples on either side of a jump; jumps of a residual that are tried
WITHIN_S = 0.4  # time constant of a slip that is not sudden: after it about a third of the slip is still to come
GROWTHS = (0.03, 0.1, 0.3, 1.0)  # of the whole: after how much of it a saturating growth has done 63 %

LATER_RUNS = "later_runs"  # the parameter that says in which way a later run begins
GOES_ON, AS_THE_FIRST, LOADED_FOR_LONG = 0.0, 1.0, 2.0  # ways in which a later run begins


def saturations(amount: Array, whole: float) -> dict[str, Array]:
    """Growth laws 1 − exp(−amount / (share · whole)) by name, and the straight one.

    `amount` and `whole` have one unit, the laws have none; each of shape (samples,).
    """
    grown = {f"within_{share:g}": 1.0 - np.exp(-amount / (share * whole)) for share in GROWTHS}
    return {**grown, "steady": amount / whole}


def growths(amount: Array, whole: float) -> dict[str, Array]:
    """The growth laws of `saturations` by name, and one that gets faster. Each of shape (samples,), without a unit."""
    return {**saturations(amount, whole), "faster": (amount / whole) ** 2}


def pulled_in(residual: Array, spreads: float) -> Array:
    """A residual with outliers pulled to so many robust spreads. Shape (samples,), in the residual's unit."""
    spread = 1.4826 * float(np.median(np.abs(residual - np.median(residual))))
    return np.clip(residual, -spreads * spread, spreads * spread)


def travelled(drivers: Drivers) -> Nonlinear:
    """Where the motion begins and how far it goes: a scale for laws that change along the travel."""
    begin = float(np.percentile(drivers.motion, 0.1))
    return {"from_turns": float(f"{begin:.6g}"), "span_turns": float(f"{drivers.span:.6g}")}


def share_of_travel(drivers: Drivers, nonlinear: Nonlinear) -> Array:
    """How far the motion is along the travel, 0 to 1. Shape (samples,), without a unit."""
    return np.asarray(np.clip((drivers.motion - nonlinear["from_turns"]) / nonlinear["span_turns"], 0.0, 1.0))


def hinge(signal: Array, onset: float, softness: float) -> Array:
    """Rises with slope 1 beyond an onset; softplus of the given width. All in one unit; shape (samples,)."""
    return np.asarray(softness * np.logaddexp(0.0, (signal - onset) / softness))


def time_constants(drivers: Drivers, candidates: tuple[float, ...]) -> list[float]:
    """The candidates (s) that a recording of this length and rate can show; if there is none, the nearest one."""
    whole_s = float(drivers.elapsed_s[-1])
    fitting = [tau for tau in candidates if 2.0 * drivers.step_s <= tau <= 2.0 * whole_s]
    return fitting or [min(candidates, key=lambda tau: abs(np.log(tau / whole_s)))]


def within(candidates: tuple[float, ...], nonlinear: Nonlinear) -> list[float]:
    """The candidates (s) that the nonlinear parameters name as visible in their recording."""
    return [tau for tau in candidates if nonlinear["fastest_s"] <= tau <= nonlinear["slowest_s"]]


def begun(drivers: Drivers, candidates: list[Nonlinear], ways: tuple[float, ...]) -> list[Nonlinear]:
    """Each candidate with each of the `ways` in which a later run begins; those of a single run stay unchanged.

    Nobody says what a string did between two runs: it went on from the run before, it rested, or it stood loaded.
    """
    if not len(drivers.breaks):
        return candidates
    return [candidate | {LATER_RUNS: way} for candidate in candidates for way in ways]


def through(drivers: Drivers, nonlinear: Nonlinear) -> list[slice]:
    """The samples through which a memory lasts: those of all runs, or of each run where the memory ends with it."""
    goes_on = nonlinear.get(LATER_RUNS, GOES_ON) == GOES_ON
    return [slice(None)] if goes_on else drivers.run_parts()


def remembered(signal: Array, drivers: Drivers, tau_s: float, nonlinear: Nonlinear) -> Array:
    """A signal after a first-order low-pass that starts at 0; it starts anew in each run where a memory ends with it.

    In the signal's unit, both of shape (samples,); the time constant in s.
    """
    parts = through(drivers, nonlinear)
    return np.concatenate([lowpass(signal[part], drivers.time_s[part], tau_s, 0.0) for part in parts])


def grid(name: str, low: float, high: float, count: int) -> list[Nonlinear]:
    """Candidates of one parameter, evenly spaced in its logarithm, rounded to six digits."""
    return [{name: float(f"{value:.6g}")} for value in np.geomspace(low, high, count)]


def slips(drivers: Drivers) -> list[Nonlinear]:
    """Candidate times of a slip that is over at once, and fewer of a slip that takes `within_s`; none in a break."""
    at_once, slowly = ([time for time in times(drivers, count) if happens_within(drivers, time)] for count in (60, 30))
    return [time | {"within_s": 0.0} for time in at_once] + [time | {"within_s": WITHIN_S} for time in slowly]


def happens_within(drivers: Drivers, nonlinear: Nonlinear) -> bool:
    """Whether a slip lies within a run, with samples of that run on both sides: in a break a person may change things.

    A slip at every stroke does.
    """
    at_s, last = nonlinear["at_s"], len(drivers.elapsed_s) - 1
    near = ((max(begin - 1 - BESIDE, 0), min(begin + BESIDE, last)) for begin in drivers.breaks)
    return not any(drivers.elapsed_s[before] < at_s < drivers.elapsed_s[after] for before, after in near)


def at_once(drivers: Drivers, first: Nonlinear, second: Nonlinear) -> bool:
    """Whether two slips are so near that they are one: of two with opposite signs the difference alone is seen."""
    return abs(first["at_s"] - second["at_s"]) < 2 * BESIDE * drivers.step_s


def jumps(drivers: Drivers, residual: Array) -> Array:
    """How far a residual jumps at each sample: the mean after it less the mean before it; 0 between two runs.

    In the residual's unit, both of shape (samples,).
    """
    size = np.convolve(residual, np.concatenate([np.ones(BESIDE), -np.ones(BESIDE)]) / BESIDE, mode="same")
    size[:BESIDE] = size[len(size) - BESIDE :] = 0.0
    for begin in drivers.breaks[drivers.breaks < len(residual)]:
        size[max(begin - BESIDE, 0) : begin + BESIDE] = 0.0
    return np.abs(size)


def jump_mark(drivers: Drivers, residual: Array, predicted: Array) -> float:
    """How far the largest jump of a residual stands out from the usual ones.

    A number from 0 to 6 without a unit; residual and prediction of shape (samples,), in the channel's unit.
    """
    height = jumps(drivers, residual)
    usual = 1.4826 * float(np.median(height)) / 0.6745
    return float(np.clip(np.log(max(height.max() / max(usual, 1e-300) / 4.0, 1.0)) * 2.0, 0.0, 6.0))


def slips_seen(drivers: Drivers, residual: Array) -> list[Nonlinear]:
    """Times at which a residual jumps most, to the sample: at once, or within a while that began then or before.

    The residual has the shape (samples,), in the channel's unit; times in s.
    """
    height = jumps(drivers, residual)
    apart = max(int(1.0 / drivers.step_s), 2 * BESIDE)
    candidates: list[Nonlinear] = []
    for _ in range(SEEN):
        place = int(np.argmax(height))
        if height[place] <= 0.0:
            break
        at_s = float(f"{drivers.elapsed_s[place]:.8g}")
        candidates += [{"at_s": at_s, "within_s": within_s} for within_s in (0.0, WITHIN_S)]
        height[max(place - apart, 0) : place + apart] = 0.0
    return candidates


def slipped(drivers: Drivers, nonlinear: Nonlinear) -> Array:
    """0 before a slip, 1 after it; the sample that holds a sudden slip is a mean, and so lies between.

    Shape (samples,), without a unit; times of the shape in s.
    """
    since_s = drivers.elapsed_s - nonlinear["at_s"]
    if nonlinear["within_s"] > 0.0:
        return np.asarray(1.0 - np.exp(-np.maximum(since_s, 0.0) / nonlinear["within_s"]))
    return np.asarray(np.clip(since_s / drivers.step_s + 0.5, 0.0, 1.0))


def times(drivers: Drivers, count: int, name: str = "at_s") -> list[Nonlinear]:
    """Candidate times of a sudden event, evenly spread over the samples."""
    index = np.unique(np.linspace(0, len(drivers.motion) - 1, count + 2).astype(int)[1:-1])
    return [{name: float(f"{drivers.elapsed_s[i]:.6g}")} for i in index]


def varied(options: list[Nonlinear]) -> int:
    """How many nonlinear parameters were chosen among several values, in the candidate that has most of them."""
    values: dict[str, set[float]] = {}
    for nonlinear in options:
        for name, value in nonlinear.items():
            values.setdefault(name, set()).add(value)
    in_all = set.intersection(*map(set, options)) if options else set()
    apart = {name for name, tried in values.items() if len(tried) > 1 or name not in in_all}
    return max((len(apart & set(nonlinear)) for nonlinear in options), default=0)
