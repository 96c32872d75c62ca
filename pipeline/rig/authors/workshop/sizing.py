"""How strong an effect must be: the size at which bounded recalibration leaves what was asked."""

from dataclasses import replace
from functools import cache

import numpy as np
from scipy.optimize import brentq, lsq_linear

from pipeline.ground.kinematics import TOLERANCE, Array, Geometry
from pipeline.rig.authors.interface import OutOfReach
from pipeline.rig.authors.workshop.bench import Bench, Part
from pipeline.rig.authors.workshop.chain import reading

JAGGED = 0.02  # how far from the size asked, in e-folds, is near enough at once
ROWS = 3000
SCALE, ANGLE_ZERO_TURNS, BOUND = 0.005, 0.05, 3.0
KNOBS = ("radius", "separator_mm", "torsion_zone_mm", "length_mm", "scale", "angle_zero")


def recalibrated(turns: Array, load_n: Array, geometry: Geometry, at: Array) -> Array:
    """The nominal reading with each knob turned by so many sigma, in mm."""
    turned = replace(
        geometry,
        radius_mm=geometry.radius_mm * (1.0 + TOLERANCE["radius"] * at[0]),
        separator_mm=geometry.separator_mm + TOLERANCE["separator_mm"] * at[1],
        torsion_zone_mm=geometry.torsion_zone_mm + TOLERANCE["torsion_zone_mm"] * at[2],
        length_mm=geometry.length_mm + TOLERANCE["length_mm"] * at[3],
    )
    contraction = turned.contraction_mm(turns + ANGLE_ZERO_TURNS * at[5], load_n)
    return np.asarray(contraction * (1.0 + SCALE * at[4]))


def left_over(turns: Array, load_n: Array, geometry: Geometry, shown_mm: Array) -> Array:
    """What is left of a reading once every knob is turned within three sigma and the zero freely, in mm."""
    few = slice(None, None, max(1, len(turns) // ROWS))  # so many rows tell how far to turn the knobs
    at = np.zeros(len(KNOBS))
    for _ in range(3):
        at = _turned_further(turns[few], load_n[few], geometry, shown_mm[few], at)
    rest = shown_mm - recalibrated(turns, load_n, geometry, at)
    return np.asarray(rest - rest.mean())


def _turned_further(turns: Array, load_n: Array, geometry: Geometry, shown_mm: Array, at: Array) -> Array:
    now = recalibrated(turns, load_n, geometry, at)
    moved = [recalibrated(turns, load_n, geometry, at + 0.01 * knob) for knob in np.eye(len(KNOBS))]
    columns = [*((moved_mm - now) / 0.01 for moved_mm in moved), np.ones_like(now), shown_mm - now]
    # the triangle of the directions and the error stands for all the rows
    triangle = np.asarray(np.linalg.qr(np.stack(columns, axis=1), mode="r"))
    # a trace of a prior keeps twins apart without moving what is left
    faint = 1e-5 * np.abs(triangle.diagonal()).max() * np.eye(len(KNOBS), len(KNOBS) + 1)
    system = np.vstack([triangle[:, :-1], faint])
    target = np.concatenate([triangle[:, -1], -faint[:, :-1] @ at])
    low, high = np.append(-BOUND - at, -np.inf), np.append(BOUND - at, np.inf)
    further = lsq_linear(system, target, (low - 1e-9, high + 1e-9)).x[:-1]
    return np.clip(at + further, -BOUND, BOUND)


def kappa_of(bench: Bench, part: Part, size: float, floor_mm: float) -> float:
    """Rms of what recalibration cannot take back of an effect, in noise floors."""
    shown = reading(bench, [(part, size)])
    return float(np.sqrt(np.mean(left_over(bench.turns, bench.load_n, bench.geometry, shown) ** 2)) / floor_mm)


def sized(bench: Bench, part: Part, kappa: float, floor_mm: float) -> float:
    """Size at which an effect reaches `kappa`; raises OutOfReach where its limit does not."""

    @cache  # a search asks at its ends and at its answer again
    def above(log_size: float) -> float:
        with np.errstate(divide="ignore"):
            return float(np.log(max(kappa_of(bench, part, float(np.exp(log_size)), floor_mm), 1e-9) / kappa))

    high = float(np.log(part.limit))
    most = above(high)
    if most < 0.0:
        raise OutOfReach(f"at its limit the effect leaves {kappa * np.exp(most):.2g} noise floors of {kappa:g}")
    low, least = high, most
    while least > 0.0:
        high, low = low, low - max(1.0, least)
        if low < np.log(part.limit) - 25.0:
            raise OutOfReach("the effect does not fade with its size")
        least = above(low)
    best = float(brentq(above, low, high, xtol=2e-3, rtol=1e-4, maxiter=40))
    if abs(above(best)) > JAGGED:  # things that let go jump with their size: look around
        best = min(best + np.linspace(-0.15, 0.15, 13), key=lambda log_size: abs(above(log_size)))
    if abs(above(best)) > 4.0 * JAGGED:
        raise OutOfReach("the effect jumps past the size that was asked")
    return float(np.exp(best))
