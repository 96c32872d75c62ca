"""Stretch that follows the twisting rate, also at low twist."""

import numpy as np

from ..numerics.recursions import lowpass
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term

RELAXING_S = (0.08, 0.2, 0.5)  # a loss with a memory of its own, as a Kelvin-Voigt element in series with a spring

GROWING = 2.0  # largest growth of a loss from no twist to the highest: a lag would be 0 without twist
TWICE_S = 0.12  # of each of two such elements in a row


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """`loaded`: whether the loss may grow with the load, which a constant load cannot show.

    `steepest` is the largest tangent of the helix angle, for scale.
    """
    steepest = float(f"{max(float(np.percentile(np.abs(drivers.tangent), 99.9)), 1e-6):.6g}")
    return [{"loaded": float(drivers.loaded), "steepest": steepest}]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Loss with powers of the rate, at once or relaxing, and with the load.

    The powers are a string's: where a guide rubs, a root would only blur the step of friction into the straight line.
    """
    rate = drivers.rate
    all_terms = [Term("straight_mm_per_turn_s", "resistance", rate, "mm s/turn", total="loss_mm_per_turn_s")]
    if nonlinear["loaded"]:
        all_terms.append(Term("loaded_mm_per_turn_s_10_n", "resistance", rate * drivers.load, "mm s/turn/10N"))
    if not drivers.levered:
        return all_terms
    steep = np.abs(drivers.tangent) / nonlinear["steepest"]
    powers = {
        "low": np.sign(rate) * np.abs(rate) ** 0.3,
        "root": np.sign(rate) * np.sqrt(np.abs(rate)),
        "straight": rate,
        "square": rate * np.abs(rate),
        "growing_root": np.sign(rate) * np.sqrt(np.abs(rate)) * (1.0 + GROWING * steep),
        "growing": rate * (1.0 + GROWING * steep),
    }
    for name, power in powers.items():
        if name != "straight":
            all_terms.append(Term(f"{name}_mm", "resistance", power))
        for tau_s in RELAXING_S:
            late = lowpass(power, drivers.time_s, tau_s, 0.0)
            all_terms.append(Term(f"{name}_relaxing_{tau_s:g}_s_mm", "resistance", late))
        twice = lowpass(lowpass(power, drivers.time_s, TWICE_S, 0.0), drivers.time_s, TWICE_S, 0.0)
        all_terms.append(Term(f"{name}_relaxing_twice_{TWICE_S:g}_s_mm", "resistance", twice))
    return all_terms


MECHANISM = Mechanism(
    id="viscous_loss",
    driver="twisting rate",
    columns=("rate",),
    equation="dx = -c dtheta/dt",
    letters={
        "c": "the strengths, each for what its row multiplies",
    },
    plain_equation="c v; v: the speed",
    strengths=("c",),
    source=(
        "Armstrong-Helouvry, Dupont and Canudas de Wit, A survey of models for machines with friction, "
        "Automatica 30, 1994 (viscous friction); with a memory: Findley, Lai and Onaran, "
        "Creep and Relaxation of Nonlinear Viscoelastic Materials, 1976 (Kelvin-Voigt element)"
    ),
    confused_with="sensor_lag (which shows nothing at low twist), friction_hysteresis (which ignores the speed)",
    told_apart_by="three speeds and small strokes at low twist",
    meaning="what is lost grows with the speed.",
    sentence=(
        "A loss follows the {rate}, so that {up} and {down} differ by {loop} ({size}), and is gone as soon as the "
        "motor stands."
    ),
    details=("{loss_mm_per_turn_s}",),
    names={
        "straight": "the rate",
        "low": "the rate to the power of 0.3",
        "root": "the root of the rate",
        "square": "the rate squared",
        "growing": "the rate, and grows with the twist: at the steepest helix angle it is three times as much",
        "growing_root": "the root of the rate, and grows with the twist in the same way",
        "loaded": "the rate x load",
        "relaxing": "what is passed on with that time constant",
    },
    candidates=candidates,
    terms=terms,
)
