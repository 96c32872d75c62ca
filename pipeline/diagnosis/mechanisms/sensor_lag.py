"""The displacement arrives late: it follows the displacement rate."""

import numpy as np

from ...ground.kinematics import Array
from ..numerics.recursions import lowpass
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term

TIMES_S = (0.03, 0.1, 0.3, 1.0)  # time constants of a first-order lag
DELAYS_S = (0.02, 0.05, 0.1, 0.2, 0.4)  # of a reading that is late as a whole
DRIVES_DELAYS_S = (0.05, 0.2)  # of a drive without a string


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """One candidate: filters and delays add up. None where it would quiet the noise of derivatives."""
    return [{}] if drivers.velocity is None else []


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """First-order filters, dead times, and a clock that runs away."""
    time_s = drivers.time_s

    def filtered(tau_s: float) -> Term:
        def operator(reading: Array) -> Array:
            return np.asarray(lowpass(reading, time_s, tau_s, float(reading[0])) - reading)

        return Term(f"filter_{tau_s:g}_s", "sensor", operator, "1", high=1.5)

    def delayed(delay_s: float) -> Term:
        return Term(
            f"delay_{delay_s:g}_s", "sensor", lambda reading: np.interp(time_s - delay_s, time_s, reading) - reading,
            "1", high=1.5,
        )  # fmt: skip

    def skewed(reading: Array) -> Array:
        return np.asarray(-drivers.elapsed_s * drivers.slope(reading))

    return [
        *map(filtered, TIMES_S),
        *map(delayed, DELAYS_S if drivers.levered else DRIVES_DELAYS_S),
        Term("clock_skew", "sensor", skewed, "1", -0.02, 0.02),
    ]


MECHANISM = Mechanism(
    id="sensor_lag",
    driver="displacement rate",
    equation="tau dx_m/dt = x - x_m, or x_m(t) = x(t - delay)",
    source=(
        "Doebelin, Measurement Systems: Application and Design, 1966 (first-order instrument); "
        "dead time: Ogata, Modern Control Engineering, 1970"
    ),
    confused_with="viscous_loss, backlash, friction_hysteresis",
    told_apart_by="two speeds; a rigid bar in place of the string",
    meaning="the displacement is read late.",
    sentence="The {reading} is read late, which is worth {size} at these speeds.",
    candidates=candidates,
    terms=terms,
)
