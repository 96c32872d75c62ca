"""The displacement arrives late: it follows the displacement rate. On a moving mass the motion does: the jerk."""

import numpy as np

from ...ground.kinematics import Array
from ..numerics.recursions import lowpass
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .plain_drag import drag, drag_along, leaves, scaled

TIMES_S = (0.03, 0.1, 0.3, 1.0)  # time constants of a first-order lag
DELAYS_S = (0.02, 0.05, 0.1, 0.2, 0.4)  # of a reading that is late as a whole
DRIVES_DELAYS_S = (0.02, 0.05, 0.2)  # of a drive without a string
LEAST_SHARE = 0.2  # of plain friction's residual: the part that must follow the jerk
LEAST_WORTH = 0.06  # of the whole mismatch, rms: any controller is late by a sample or two


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """One candidate: filters and delays add up. None where derivatives of the motion must suggest one."""
    return [{}] if drivers.velocity is None else []


def suggest(drivers: Drivers, residual: Array, predicted: Array) -> list[Nonlinear]:
    """One candidate where the reading follows derivatives and the residual without drag follows the jerk.

    The residual has the shape (samples,), in the reading's unit.
    """
    if drivers.velocity is None:
        return []
    drag_columns = [*drag(drivers), *drag_along(drivers), np.ones_like(drivers.motion)]
    without = leaves(residual, drag_columns)
    worth = without - leaves(residual, [*drag_columns, scaled(_jerk(drivers))])
    return [{}] if worth >= max(LEAST_SHARE * without, LEAST_WORTH**2 * float(np.mean(residual**2))) else []


def _jerk(drivers: Drivers) -> Array:
    """Slope of the acceleration between both neighbours, which keeps out the noise of the sample itself."""
    return np.gradient(drivers.acceleration, drivers.time_s)


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """First-order filters, dead times, and a clock that runs away.

    Where the reading follows derivatives of the motion, a motion that is read late, or early: the jerk. A filter would
    quiet the noise of these derivatives, which the jerk leaves alone.
    """
    time_s = drivers.time_s
    if drivers.velocity is not None:
        return [Term("late_mm_s3_per_turn", "sensor", _jerk(drivers), "mm s^3/turn", -np.inf)]

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
    columns=("rate x twist",),
    equation="tau dx_m/dt = x - x_m, or x_m(t) = x(t - delay)",
    letters={
        "tau": "the time constant of a strength filter_… | in its name",
        "delay": "by how much the reading of a strength delay_… is late | in its name",
    },
    source=(
        "Doebelin, Measurement Systems: Application and Design, 1966 (first-order instrument); "
        "dead time: Ogata, Modern Control Engineering, 1970"
    ),
    confused_with="viscous_loss, backlash, friction_hysteresis",
    told_apart_by="two speeds; a rigid bar in place of the string",
    meaning="the displacement is read late, or the twist.",
    sentence="The {reading} and the {motion} are read at different moments, which is worth {size} at these speeds.",
    details=(
        "the delay of the {motion} is {late_ms}",
        "the moving mass times the delay of the {motion} is {late_mm_s3_per_turn}; divided by "
        "the mass that is the delay in seconds",
    ),
    names={
        "filter_*_s": "the reading with a first-order lag of the time in the name, less the reading itself",
        "delay_*_s": "the reading that much later, less the reading itself",
        "clock_skew": "minus the rate of the reading x the time so far: two clocks run apart",
    },
    candidates=candidates,
    terms=terms,
    suggest=suggest,
)
