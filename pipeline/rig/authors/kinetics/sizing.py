"""How large an effect is once bounded recalibration has taken back what it can, and the size that makes it so."""

from dataclasses import replace

import numpy as np
from scipy.optimize import lsq_linear

from pipeline.ground.kinematics import TOLERANCE, Array
from pipeline.rig.authors.interface import OutOfReach
from pipeline.rig.authors.kinetics.bench import Bench
from pipeline.rig.authors.kinetics.reading import Hidden, displacement

ANGLE_ZERO_TURNS, SCALE = 0.05, 0.005
BOUND_SIGMAS = 3.0
POINTS = 2000
NEAR, NEAR_ENOUGH = 0.03, 0.06


class Recalibration:
    """The bounded recalibration of one run's geometry, about its true dimensions."""

    def __init__(self, bench: Bench, at: Array) -> None:
        """Take a run and the steps at which the logger takes its rows."""
        self.at = at
        thin = at[:: max(1, len(at) // POINTS)]
        self.thin = thin
        self.turns, self.load_n = bench.turns[thin], bench.load_n[thin]
        self.geometry = bench.geometry
        self.plain = self.model(np.zeros(6))

    def model(self, moved: Array) -> Array:
        """The geometry's reading with its dimensions moved by so many sigmas, without its mean."""
        g = self.geometry
        geometry = replace(
            g,
            radius_mm=g.radius_mm * (1.0 + TOLERANCE["radius"] * moved[0]),
            separator_mm=g.separator_mm + TOLERANCE["separator_mm"] * moved[1],
            torsion_zone_mm=g.torsion_zone_mm + TOLERANCE["torsion_zone_mm"] * moved[2],
            length_mm=g.length_mm + TOLERANCE["length_mm"] * moved[3],
        )
        x = geometry.contraction_mm(self.turns + ANGLE_ZERO_TURNS * moved[5], self.load_n) * (1.0 + SCALE * moved[4])
        return np.asarray(x - x.mean())

    def left_mm(self, effect_mm: Array) -> float:
        """Rms of what the best move of the dimensions leaves of an effect at the thinned rows."""
        wanted = self.plain + effect_mm - effect_mm.mean()
        moved = np.zeros(6)
        for _ in range(6):
            reading_mm = self.model(moved)
            slopes = (
                np.array([self.model(moved + away) - self.model(moved - away) for away in 0.05 * np.eye(6)]).T / 0.1
            )
            low, high = -BOUND_SIGMAS - moved - 1e-9, BOUND_SIGMAS - moved + 1e-9
            step = lsq_linear(slopes, wanted - reading_mm, (low, high)).x
            moved = moved + step
            if np.abs(slopes @ step).max() < 1e-4:
                break
        return float(np.sqrt(np.mean(np.square(wanted - self.model(moved)))))


def sized(bench: Bench, hidden: Hidden, asked_mm: float, recalibration: Recalibration) -> tuple[Hidden, float]:
    """The effect at the size that leaves so much after recalibration, and what it leaves; raises OutOfReach."""

    def left(size: float) -> float:
        reading = displacement(bench, [replace(hidden, size=size)])[recalibration.thin]
        return recalibration.left_mm(reading - plain)

    plain = displacement(bench, [])[recalibration.thin]
    low, high = 0.0, hidden.law.largest
    size, reached = high, left(high)
    if not np.isfinite(reached) or reached < asked_mm:
        # a stop far below the top or coils without end show less than half as much of them: look once lower
        high *= 0.5
        size, reached = high, left(high)
        if not np.isfinite(reached) or reached < asked_mm:
            raise OutOfReach(f"the most that this motion shows of {hidden.effect} is {reached:.3g} mm")
    best = (size, reached)
    for _ in range(25):
        if abs(reached / asked_mm - 1.0) < abs(best[1] / asked_mm - 1.0):
            best = (size, reached)
        if abs(reached / asked_mm - 1.0) < NEAR:
            return replace(hidden, size=size), reached
        if reached > asked_mm:
            high = size
        else:
            low = size
        guess = size * asked_mm / max(reached, 1e-9)
        inside = low + 0.02 * (high - low) < guess < high - 0.02 * (high - low)
        size = guess if inside else float(np.sqrt(low * high)) if low > 0.0 else 0.2 * high
        reached = left(size)
    if abs(best[1] / asked_mm - 1.0) < NEAR_ENOUGH:  # what slips at random does not grow evenly
        return replace(hidden, size=best[0]), best[1]
    raise OutOfReach(f"no size of {hidden.effect} comes near {asked_mm:.3g} mm")
