"""Test cases for any method that looks for missing physics: the hidden effects, their sizes, and the motion."""

from collections.abc import Mapping
from dataclasses import dataclass

from . import cable_drive, moving_mass
from .made import Made
from .streams import stream

DRAWN = (0.7, 1.4)  # of the size that a case tells


@dataclass(frozen=True)
class Case:
    """Effects with their usual sizes, in the units of the rig's EFFECTS, a plan and a noise."""

    effects: Mapping[str, float]
    plan: str
    noise: str = "usual"


CABLE = {
    "nothing": Case({}, "loads-0.3"),
    "trap": Case({}, "loads-0.3", "trap"),
    "offset": Case({"sensor_offset": 1.0}, "loads-0.3"),
    "friction": Case({"friction_hysteresis": 1.5}, "loads-0.3"),
    "stretch": Case({"axial_elasticity": 30.0}, "loads-0.3"),
    "friction-stretch": Case({"friction_hysteresis": 1.5, "axial_elasticity": 30.0}, "loads-0.3"),
    "backlash": Case({"backlash": 1.2}, "loads-0.3"),
    "lag": Case({"sensor_lag": 0.03}, "steps"),
    "creep": Case({"creep": 1.2}, "steps"),
    "drift": Case({"sensor_drift": 1.0}, "loads-0.3"),
    "slip": Case({"clamp_slip": 0.8}, "loads-0.3"),
    "kink": Case({"x_kink": 1.0}, "loads-0.3"),
    "friction-slip": Case({"friction_hysteresis": 1.5, "clamp_slip": 0.8}, "loads-0.3"),
}
MASS = {
    "nothing": Case({}, "bang"),
    "trap": Case({}, "bang", "trap"),
    "three": Case({"viscous_loss": 200.0, "friction_hysteresis": 20.0, "sensor_offset": 3.0}, "bang"),
    "viscous": Case({"viscous_loss": 150.0}, "bang"),
    "coulomb": Case({"friction_hysteresis": 15.0}, "bang"),
    "two": Case({"viscous_loss": 150.0, "friction_hysteresis": 15.0}, "bang"),
    "offset": Case({"sensor_offset": 4.0}, "bang"),
    "drift": Case({"sensor_drift": 8.0}, "bang"),
    "lag": Case({"sensor_lag": 0.004}, "bang"),
    "cogging": Case({"eccentricity": 6.0}, "speeds"),
    "rail": Case({"rail_friction": 20.0}, "bang"),
    "push": Case({"x_push": 12.0}, "bang"),
    "three-lag": Case(
        {"viscous_loss": 200.0, "friction_hysteresis": 20.0, "sensor_offset": 3.0, "sensor_lag": 0.004}, "bang"
    ),
}
CASES = {
    **{f"cable-{name}": case for name, case in CABLE.items()},
    **{f"mass-{name}": case for name, case in MASS.items()},
}


def make(name: str, seed: int, *, plan: str | None = None, noise: str | None = None, take: int = 0) -> Made:
    """One case, its sizes drawn by the seed about the usual ones; the same rig in another plan or take when given.

    Raises ValueError for a case, a plan or a noise that is not known.
    """
    if name not in CASES:
        raise ValueError(f"{name} is no case; known are {', '.join(CASES)}")
    case = CASES[name]
    rig, sizes = cable_drive if name.startswith("cable-") else moving_mass, {}
    for effect, usual in case.effects.items():
        rng = stream(seed, name, effect)
        sign = -1.0 if rig.EFFECTS[effect].signed and rng.random() < 0.5 else 1.0
        sizes[effect] = sign * usual * float(rng.uniform(*DRAWN))
    return rig.record(seed, sizes, plan or case.plan, noise=noise or case.noise, take=take)
