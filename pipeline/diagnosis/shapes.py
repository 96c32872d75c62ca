"""Small helpers that mechanisms share: growth laws, hinges, grids of candidates. They know no mechanism."""

import numpy as np

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Shape
from pipeline.kinematics import Array

GROWTHS = (0.03, 0.1, 0.3, 1.0)  # of the whole: after how much of it a saturating growth has done 63 %


def saturations(amount: Array, whole: float) -> dict[str, Array]:
    """Growth laws 1 − exp(−amount / (share · whole)) by name, and the straight one."""
    grown = {f"within_{share:g}": 1.0 - np.exp(-amount / (share * whole)) for share in GROWTHS}
    return {**grown, "steady": amount / whole}


def hinge(signal: Array, onset: float, softness: float) -> Array:
    """Rises with slope 1 beyond an onset; softplus of the given width."""
    return np.asarray(softness * np.logaddexp(0.0, (signal - onset) / softness))


def time_constants(drivers: Drivers, candidates: tuple[float, ...]) -> list[float]:
    """Those candidates (s) that a recording of this length and rate can show; the nearest one when there is none."""
    whole_s = float(drivers.elapsed_s[-1])
    fitting = [tau for tau in candidates if 2.0 * drivers.step_s <= tau <= 2.0 * whole_s]
    return fitting or [min(candidates, key=lambda tau: abs(np.log(tau / whole_s)))]


def within(candidates: tuple[float, ...], shape: Shape) -> list[float]:
    """Those candidates (s) that a shape says its recording could show."""
    return [tau for tau in candidates if shape["fastest_s"] <= tau <= shape["slowest_s"]]


def grid(name: str, low: float, high: float, count: int) -> list[Shape]:
    """Candidates of one parameter, evenly spaced in its logarithm, rounded to six digits."""
    return [{name: float(f"{value:.6g}")} for value in np.geomspace(low, high, count)]


def times(drivers: Drivers, count: int, name: str = "at_s") -> list[Shape]:
    """Candidate times of a sudden event, evenly spread over the samples."""
    index = np.unique(np.linspace(0, len(drivers.motion) - 1, count + 2).astype(int)[1:-1])
    return [{name: float(f"{drivers.elapsed_s[i]:.6g}")} for i in index]
