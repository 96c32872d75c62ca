"""Friction along a cable: pulleys that each take their share of its tension, through bristles that slip one by one."""

import math
from dataclasses import dataclass

import numpy as np

from ...ground.kinematics import Array
from ..effect import compiled

PULLEYS, BRISTLES = 5, 4
REFERENCE_NM = 0.03  # the torque at which a loop's half-height is told


@dataclass(frozen=True)
class Capstans:
    """The pulleys of one cable: the friction of each per tension, and how far its bristles bend before they slip."""

    angle: Array  # (pulleys,), friction coefficient times wrap, without a unit
    slip_deg: Array  # (pulleys, bristles)
    bend: Array  # (pulleys, bristles), without a unit: exponent of the bristle's way into sliding
    share: Array  # (pulleys,) of the give in the cable's lay, in shares of 1
    film: float  # what friction loses at speed
    film_deg_per_s: float
    pretension_nm: float  # of each strand, times the jaw's radius

    @classmethod
    def drawn(cls, rng: np.random.Generator) -> "Capstans":
        """Pulleys as they may stand in one rig."""
        shape = (PULLEYS, BRISTLES)
        share = rng.uniform(0.5, 1.5, PULLEYS)
        return cls(
            angle=rng.uniform(0.06, 0.16, PULLEYS),
            slip_deg=np.exp(rng.uniform(math.log(0.6), math.log(5.0), shape)),
            bend=rng.uniform(0.8, 1.7, shape),
            share=share / share.sum(),
            film=rng.uniform(0.02, 0.06),
            film_deg_per_s=rng.uniform(15.0, 40.0),
            pretension_nm=rng.uniform(0.005, 0.011),
        )

    def strands(self, torque_nm: Array) -> Array:
        """Tension of the pulling and the returning strand times the jaw's radius, in Nm; shape (2, samples).

        The returning one keeps a little tension however hard the jaw pulls.
        """
        half = np.asarray(torque_nm) / 2.0
        away = self.pretension_nm - half
        slack = (away + np.hypot(away, 0.35 * self.pretension_nm)) / 2.0
        return np.array([slack + 2.0 * half, slack])

    def sliding_nm(self, torque_nm: float, way: float) -> float:
        """Give-weighted friction with every bristle slipping one way (+1, -1), in Nm."""
        tight, loose = self.strands(np.array(torque_nm)).tolist()
        total = 0.0
        for angle, share in zip(self.angle[::-1], self.share[::-1], strict=True):
            before = tight - loose
            tight, loose = tight * math.exp(angle * way), loose * math.exp(-angle * way)
            total += share * (tight - loose - before)
        return total

    def lost_deg(self, cable_deg: Array, torque_nm: Array, half_height_deg: float, step_s: float) -> Array:
        """The angle that friction keeps from the jaw, in deg, for a loop of ± half_height_deg at the reference torque.

        Shape (samples,).
        """
        full = (self.sliding_nm(REFERENCE_NM, 1.0) - self.sliding_nm(REFERENCE_NM, -1.0)) / 2.0
        give = half_height_deg / full * self.share
        film = (self.film, self.film_deg_per_s * step_s)
        return _lost(np.diff(cable_deg, prepend=cable_deg[0]), self.strands(torque_nm), self.angle, give,
                     self.slip_deg, self.bend, film)  # fmt: skip


@compiled
def _lost(steps: Array, strands: Array, angle: Array, give: Array, slip: Array, bend: Array, film: tuple) -> Array:
    pulleys, bristles = slip.shape
    bent = np.zeros((pulleys, bristles))
    tight, loose = np.zeros(pulleys + 1), np.zeros(pulleys + 1)
    kept = np.zeros(pulleys)
    out = np.zeros(len(steps))
    for k in range(len(steps)):
        tight[pulleys], loose[pulleys] = strands[0, k], strands[1, k]
        grip = 1.0 - film[0] * (1.0 - math.exp(-abs(steps[k]) / film[1]))
        for i in range(pulleys - 1, -1, -1):  # tension builds up from the jaw to the motor
            pull = angle[i] * grip * bent[i].mean()
            tight[i] = tight[i + 1] * math.exp(pull)
            loose[i] = loose[i + 1] * math.exp(-pull)
        moved = steps[k]  # and motion comes from the motor, less what each pulley keeps
        for i in range(pulleys):
            way = 1.0 if moved >= 0.0 else -1.0
            for b in range(bristles):
                unbent = max(1.0 - way * bent[i, b], 0.0)
                bent[i, b] += unbent ** bend[i, b] * moved / slip[i, b]
                bent[i, b] = min(max(bent[i, b], -1.0), 1.0)
            now = give[i] * (tight[i] - loose[i] - tight[i + 1] + loose[i + 1])
            moved -= now - kept[i]
            kept[i] = now
        out[k] = kept.sum()
    return out
