"""A vessel overflows: its level stays at the rim, and the water that ran over is missing for a while after."""

import numpy as np
from numba import njit

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term

RIMS = np.linspace(0.3, 1.06, 39)  # of the nominal range above the lowest level; calibration may stretch it
TIMES = (0.003, 0.01, 0.03, 0.1, 0.3)  # of the recording: time constant in which the missing level comes back
LEAST_HELD = 0.7  # least share: a rim holds all level beyond it, calibration aside


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Where the rim is, in V from where the recording begins, and how long it shows afterwards.

    Only where what is read is a level that follows its driver and has a true zero, as that of a tank does.
    """
    if drivers.levered or drivers.free_zero or drivers.velocity is not None:
        return []
    low, high = float(drivers.contraction.min()), float(drivers.contraction.max())
    whole_s = float(drivers.elapsed_s[-1])
    return [
        {"rim_mm": float(f"{low + share * (high - low):.6g}"), "forgets_s": float(f"{part * whole_s:.6g}")}
        for share in RIMS
        for part in TIMES
    ]


@njit(cache=True)
def missing(level: Array, rim: float, time_s: Array, forgets_s: float) -> Array:
    """The level that an overflow took away, which is forgotten with time.

    Shape (samples,), in the level's unit; time in s.
    """
    out = np.zeros_like(level)
    lost = 0.0
    for i in range(level.size):
        if i > 0:
            lost *= np.exp(-(time_s[i] - time_s[i - 1]) / forgets_s)
        lost = max(lost, level[i] - rim)
        out[i] = lost
    return out


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """The reading stays at the rim while more flows in than out, and is lower than predicted for a while after."""

    def spilt(reading: Array) -> Array:
        rim = float(reading[0]) + nonlinear["rim_mm"]
        return np.asarray(-missing(np.ascontiguousarray(reading), rim, drivers.time_s, nonlinear["forgets_s"]))

    return [Term("share_held", "sensor", spilt, "1", LEAST_HELD, 1.4)]


MECHANISM = Mechanism(
    id="x_overflow",
    driver="reading at its end",
    equation="x_m = x - d, d' = -d/tau, x_m <= rim",
    letters={
        "d": "what has run over",
        "d'": "how fast that is forgotten",
        "rim": "rim_mm",
    },
    meanings={
        "forgets_s": "how long it shows afterwards",
        "rim_mm": "the reading at which it overflows, from where the recording begins",
    },
    source=(
        "Schoukens and Noël, Three benchmarks addressing open challenges in nonlinear system identification, "
        "IFAC-PapersOnLine 50, 2017 (cascaded tanks with overflow)"
    ),
    confused_with="end_stop (which forgets at once)",
    told_apart_by="the level's fall after a long overflow: it begins as soon as less flows in than out",
    meaning="what rises past a rim runs over and is lost; on rigs without a string.",
    sentence="It overflows, which takes up to {span} away ({size}).",
    details=("the rim is {rim_mm} from where the recording begins",),
    candidates=candidates,
    terms=terms,
)
