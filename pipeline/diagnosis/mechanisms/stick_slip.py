"""Slow motion goes in jerks: a part sticks, is drawn along, and then slips."""

import numpy as np
from scipy.ndimage import median_filter

from ...ground.kinematics import Array
from ..numerics.noise import resolution
from ..numerics.recursions import sticking
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term

# samples for the median that is taken off; spreads at which a step is cut; least number of steps
AROUND, CLIP, FEWEST = 101, 5.0, 100
STILL = 0.01  # of the highest rate
LOUDER = 1.15  # times the steps at rest
SURE = 6.0  # standard errors of the skewness
SURE_BELOW = 3.0  # the same in the lower part of the travel: a string's coils jump too, but past a critical twist alone
LOWER = 0.45  # of the travel: the lower part
COARSE = 0.75  # of the sensor's resolution: rounding alone makes steps of half of it, skewed along slow motion


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """How far the contraction is ahead, in mm, before it slips; `usual_rate` (turns/s) says what is slow."""
    reach_mm = float(np.ptp(drivers.contraction))
    rate = np.abs(drivers.rate)
    usual = float(f"{np.median(rate[rate > 0.1 * rate.max()]) if rate.max() > 0 else 1.0:.6g}")
    return [
        {"reach_mm": float(f"{value:.6g}"), "back_share": back, "usual_rate": usual}
        for value in np.geomspace(1e-3, 0.1, 20) * reach_mm
        for back in (0.0, 0.25)
    ]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """The gap between the motion and the sticking part: at every speed, or at low speed only."""
    gap = drivers.contraction - sticking(
        drivers.contraction, nonlinear["reach_mm"], nonlinear["back_share"] * nonlinear["reach_mm"]
    )
    slow = np.exp(-np.square(drivers.rate / nonlinear["usual_rate"]))
    return [Term("always", "length", gap, "1"), Term("slow", "length", gap * slow, "1")]


def jerks(drivers: Drivers, residual: Array, predicted: Array, below: float = 1.0) -> tuple[float, float]:
    """How skewed the steps of a residual are, in standard errors, and how large they are.

    What sticks falls behind slowly and slips ahead at once. Steps count along the motion, in four classes of its speed;
    those of a class must be larger than at rest, and larger than the sensor's resolution makes them. Only those `below`
    a share of the travel count.
    Residual and prediction have the shape (samples,), in the reading's unit.
    """
    rate = np.abs(drivers.rate[: len(residual)])[1:]
    still, moving = rate < STILL * rate.max(), rate > 3.0 * STILL * rate.max()
    step, moved = np.diff(residual), np.diff(predicted)
    step = step - median_filter(step, AROUND, mode="nearest")
    spread = 1.4826 * float(np.median(np.abs(step)))
    step = np.clip(step, -CLIP * spread, CLIP * spread) * np.sign(moved)
    grain = resolution(residual + predicted)
    at_rest = float(np.std(step[still])) if still.sum() > FEWEST else 0.0
    strongest = (0.0, 0.0)
    moving &= drivers.motion[1 : len(residual)] <= np.percentile(drivers.motion, 0.1) + below * drivers.span
    fewest = FEWEST * min(1.0, 2.0 * below)  # in a part of the travel there are fewer
    for part in np.array_split(np.flatnonzero(moving)[np.argsort(np.abs(moved[moving]), kind="stable")], 4):
        if len(part) < fewest:
            continue
        moving_on = float(np.std(step[part]))
        if moving_on <= max(LOUDER * at_rest, float(np.hypot(at_rest, COARSE * grain))):
            continue
        skew = float(np.mean(step[part] ** 3)) / moving_on**3 * float(np.sqrt(len(part) / 15.0))
        if skew > SURE:
            return skew, moving_on
        strongest = max(strongest, (skew, moving_on))
    return strongest


def random(drivers: Drivers, residual: Array, predicted: Array) -> Nonlinear | None:
    """Jerks beyond chance; the reach is that of a sawtooth of the size seen.

    Residual and prediction have the shape (samples,), in the reading's unit.
    """
    skew, size = jerks(drivers, residual, predicted)
    if skew <= SURE or jerks(drivers, residual, predicted, LOWER)[0] <= SURE_BELOW:
        return None
    rate = np.abs(drivers.rate[: len(residual)])[1:]
    usual = float(np.median(rate[rate > 3.0 * STILL * rate.max()]))
    nonlinear = {"reach_mm": float(f"{np.sqrt(6.0) * size:.6g}"), "back_share": 0.0}
    return nonlinear | {"usual_rate": float(f"{usual:.6g}")}


def mark(drivers: Drivers, residual: Array, predicted: Array) -> float:
    """Skewed steps, in standard errors.

    Residual and prediction have the shape (samples,), in the reading's unit.
    """
    return float(np.clip(jerks(drivers, residual, predicted)[0], 0.0, SURE))


MECHANISM = Mechanism(
    id="stick_slip",
    driver="slow motion",
    columns=("direction when slow",),
    equation="dx = -k (x - s), s sticks until |x - s| > reach, then slips",
    letters={
        "k": "how much of it: at every speed, and what fades as exp(-(v/usual_rate)^2)",
        "s": "where the reading sticks",
    },
    strengths=("k",),
    meanings={
        "back_share": "how much of the reach is given back at a slip, as a share of it",
        "reach_mm": "how far the reading falls behind before it slips",
        "usual_rate": "the usual speed, in {motion_unit}/s: far below it is slow",
    },
    source=(
        "Armstrong-Helouvry, Dupont and Canudas de Wit, A survey of models for machines with friction, Automatica "
        "30, 1994"
    ),
    confused_with="eccentricity, backlash",
    told_apart_by="one slow stroke: the jerks come at equal steps of contraction and vanish at speed",
    meaning="the motion sticks and jumps.",
    sentence="Slow motion goes in jerks of {size}.",
    details=("what sticks is let go after about {reach_mm}",),
    candidates=candidates,
    names={"slow": "the gap where it is slow alone: the gap x exp(-(v/usual_rate)^2)"},
    remembers_turns=True,
    terms=terms,
    random=random,
    largest_move="reach_mm",
    mark=mark,
    least_mark=2.0,
)
