"""Fibres of a bundle break, one after the other and ever faster, for the load goes on to those that are left."""

from collections.abc import Sequence

import numpy as np

from ...ground.kinematics import Array
from ..effect import Effect, Lived

LEAST_LEFT = 0.5  # share of the fibres below which no string hangs together


class Model(Effect):
    """A share n of the fibres is left and each bears 1/n of its first load: dn/dD = −n · (1/n)^sharing / sharing.

    Damage D comes with the contact work of winding, F sin α dx / work_n_mm, and with the time under contact force,
    sin α dt / held_s; at D = 1 nothing is left. It comes unevenly, as the lay brings weak places into contact:
    dD is 1 + Σ share_i · sin(2π D0 / period_i + phase_i) of that, D0 the even damage. Broken fibres leave the
    section, and the radius falls with n^(thinning / 2).
    """

    acts_on = "radius"

    def __init__(
        self,
        work_n_mm: float,
        held_s: float,
        sharing: float,
        thinning: float = 1.0,
        shares: Sequence[float] = (),
        periods: Sequence[float] = (),
        phases_rad: Sequence[float] = (),
    ) -> None:
        self.work_n_mm, self.held_s, self.sharing, self.thinning = work_n_mm, held_s, sharing, thinning
        self.waves = list(zip(shares, periods, phases_rad, strict=True))
        self.twist_rad: float | None = None
        self.even, self.left = 0.0, np.ones(1)

    @property
    def broken(self) -> bool:
        """Whether too few fibres are left for the string to hold."""
        return bool(self.left[-1] <= LEAST_LEFT)

    def run(self, lived: Lived) -> Array:
        """Factor on the radius."""
        before_rad = lived.twist_rad[0] if self.twist_rad is None else self.twist_rad
        turned_rad = np.diff(lived.twist_rad, prepend=before_rad)
        self.twist_rad = float(lived.twist_rad[-1])
        opened_mm = lived.geometry.separator_mm + (lived.twist_rad - turned_rad / 2.0) * lived.radius_mm
        tangent = opened_mm / lived.geometry.torsion_zone_mm
        sine = tangent / np.hypot(1.0, tangent)
        work_n_mm = lived.load_n * sine**2 * lived.radius_mm * np.maximum(turned_rad, 0.0)  # dx = r sin α dθ
        even = self.even + np.cumsum(work_n_mm / self.work_n_mm + sine * lived.step_s / self.held_s)
        self.even = float(even[-1])
        self.left = np.maximum(1.0 - self._uneven(even), LEAST_LEFT**self.sharing) ** (1.0 / self.sharing)
        return np.asarray(self.left ** (self.thinning / 2.0))

    def _uneven(self, even: Array) -> Array:
        """Damage, its rate summed over the even damage; it never falls while the shares sum to less than 1."""
        damage = even.copy()
        for share, period, phase in self.waves:
            angular = 2.0 * np.pi / period
            damage += share / angular * (np.cos(phase) - np.cos(angular * even + phase))
        return damage


class Stretch(Effect):
    """Fewer fibres give way more: the string is longer by F / K · (1/n − 1), n of the fibres being left."""

    acts_on = "length"

    def __init__(self, bundle: Model) -> None:
        self.bundle = bundle  # acts on the radius, and so has run before

    def run(self, lived: Lived) -> Array:
        """Lengthening in mm."""
        return np.asarray(lived.load_n / lived.geometry.stiffness_n_per_mm * (1.0 / self.bundle.left - 1.0))
