"""A cable drive, as recorded: a motor turns a cable over pulleys, a jaw follows against a load, most of the time."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pandas as pd

from ...ground.kinematics import Array
from . import cable_parts as parts
from .cable_plan import STEP_S, TIME_S, Told, told
from .capstan import Capstans
from .made import Kind, Made, OfRig, Truth, check
from .made import told as truth_of
from .streams import coloured, counted, stream, wander

NOMINAL_GEAR, GEAR_TOLERANCE = 0.9, 0.05
MOTOR_QUANTUM_DEG, JAW_QUANTUM_DEG = 360.0 / 8192, 360.0 / 4000
TORQUE_QUANTUM_NM, TORQUE_NOISE_NM = 3.9811e-5, 6e-4

EFFECTS = {
    "friction_hysteresis": Kind("friction_hysteresis", "deg", "half the height of the loop when sliding at 0.03 Nm"),
    "axial_elasticity": Kind("axial_elasticity", "deg/Nm", "stretch over torque at 0.05 Nm"),
    "backlash": Kind("backlash", "deg", "width of the play, of the motor"),
    "sensor_lag": Kind("sensor_lag", "s", "dead time and poles of the jaw encoder together"),
    "creep": Kind("creep", "deg", "lengthening after 20 s under 0.05 Nm"),
    "sensor_drift": Kind("sensor_drift", "deg", "what the jaw's zero has moved in the end", signed=True),
    "sensor_offset": Kind("sensor_offset", "deg", "constant angle of the jaw", signed=True),
    "clamp_slip": Kind("clamp_slip", "deg", "jump of the jaw, once", signed=True),
    "x_kink": Kind(None, "deg", "height of a hump at one angle, the same both ways", signed=True),
}


def record(
    seed: int,
    effects: Mapping[str, float] | None = None,
    plan: str = "sine-0.3",
    *,
    loads_nm: Sequence[float] | None = None,
    noise: str = "usual",
    take: int = 0,
) -> Made:
    """Record a cable drive: 20 s at 1 kHz of `motor_deg`, `jaw_deg` and `torque_nm`, and the truth.

    The seed is the rig (its gear and the shape of its effects); plan and take draw the noise and how the effects
    wander. `effects` are sizes by name, in the units that EFFECTS tells. The noise is `usual` (0.03 to 0.1 deg,
    coloured), `trap` (up to three times that, slower) or `none` (nor any quantum). ValueError for what is not known.
    """
    sizes = dict(effects or {})
    check(sizes, EFFECTS, noise)
    this = (plan, take)
    commands = told(plan, loads_nm, stream(seed, *this, "plan"))
    gear = NOMINAL_GEAR * (1.0 + GEAR_TOLERANCE * stream(seed, "gear").uniform(-1.5, 1.5))
    drawn = {name: _drawn(seed, this, name) for name in sizes}
    jaw_deg = _jaw(seed, this, commands, gear, sizes, drawn)
    less = {name: {other: size for other, size in sizes.items() if other != name} for name in sizes}
    alone = {name: jaw_deg - _jaw(seed, this, commands, gear, less[name], drawn) for name in sizes}
    said_deg, noise_deg = _noise(noise, stream(seed, *this, "noise"))
    torque_noise = TORQUE_NOISE_NM * stream(seed, *this, "torque").standard_normal(len(TIME_S))
    exact = 0.0 if noise == "none" else 1.0
    samples = pd.DataFrame(
        {
            "time_s": TIME_S,
            "motor_deg": counted(commands.motor_deg, exact * MOTOR_QUANTUM_DEG),
            "jaw_deg": counted(jaw_deg + said_deg, exact * JAW_QUANTUM_DEG),
            "torque_nm": counted(commands.torque_nm + exact * torque_noise, exact * TORQUE_QUANTUM_NM),
        }
    )
    run: OfRig = {
        "run": f"cable-{plan}-{seed}-{take}".replace(".", ""),
        "actuator": "cable_drive",
        "rig": {"gear_ratio": NOMINAL_GEAR},
        "tolerance": {"gear_ratio": GEAR_TOLERANCE},
    }
    truth: Truth = {
        "actuator": "cable_drive", "seed": seed, "plan": plan, "take": take,
        "parameters": {"gear_ratio": gear},
        "noise": {"kind": noise, "jaw_deg": noise_deg},
        "effects": truth_of(EFFECTS, sizes, alone, drawn),
    }  # fmt: skip
    true = {"motor_deg": commands.motor_deg, "jaw_deg": jaw_deg, "torque_nm": commands.torque_nm}
    return Made(samples, run, truth, pd.DataFrame({**true, **alone}))


def _drawn(seed: int, this: tuple[str, int], name: str) -> dict[str, Any]:
    """The random numbers for an effect's shape, beside its size: per rig, or per take for a single event."""
    rng, now = stream(seed, name), stream(seed, *this, name)
    return {
        "axial_elasticity": {"pretension_nm": rng.uniform(0.004, 0.009), "power": rng.uniform(2.2, 3.2)},
        "backlash": {"soft": rng.uniform(0.05, 0.15)},
        "sensor_lag": {"dead_share": rng.uniform(0.25, 0.5)},
        "creep": {"power": rng.uniform(0.9, 1.25)},
        "sensor_drift": {"tau_s": rng.uniform(7.0, 18.0)},
        "clamp_slip": {"at_s": now.uniform(6.0, 14.0), "within_s": now.uniform(0.004, 0.02)},
        "x_kink": {"at_deg": rng.uniform(18.0, 42.0), "widths_deg": rng.uniform(1.5, 4.5, 2).tolist()},
    }.get(name, {})


def _jaw(
    seed: int, this: tuple[str, int], commands: Told, gear: float, sizes: dict[str, float], drawn: dict[str, Any]
) -> Array:
    """Angle that the jaw's encoder would say without noise, in deg; shape (samples,)."""

    def strength(name: str) -> Array:
        return sizes.get(name, 0.0) * wander(stream(seed, *this, name, "wander"), TIME_S)

    cable_deg, torque_nm = commands.motor_deg, commands.torque_nm
    if sizes.get("backlash"):
        lost_deg = parts.play_lost(commands.motor_deg, sizes["backlash"], drawn["backlash"]["soft"])
        cable_deg = cable_deg - lost_deg * strength("backlash") / sizes["backlash"]
    jaw_deg = gear * cable_deg
    if sizes.get("friction_hysteresis"):
        lost_deg = Capstans.drawn(stream(seed, "capstans")).lost_deg(cable_deg, torque_nm, 1.0, STEP_S)
        jaw_deg = jaw_deg - strength("friction_hysteresis") * lost_deg
    if sizes.get("axial_elasticity"):
        shape = parts.stretch_shape(torque_nm, **drawn["axial_elasticity"])
        jaw_deg = jaw_deg - parts.FULL_NM * strength("axial_elasticity") * shape
    if sizes.get("creep"):
        jaw_deg = jaw_deg - strength("creep") * parts.crept(torque_nm, STEP_S, **drawn["creep"])
    if sizes.get("x_kink"):
        jaw_deg = jaw_deg + strength("x_kink") * parts.kinked(cable_deg, **drawn["x_kink"])
    if sizes.get("clamp_slip"):
        jaw_deg = jaw_deg - sizes["clamp_slip"] * parts.slipped(TIME_S, **drawn["clamp_slip"])
    if sizes.get("sensor_lag"):
        lag_s, share = sizes["sensor_lag"], drawn["sensor_lag"]["dead_share"]
        poles_s = (0.7 * (1 - share) * lag_s, 0.3 * (1 - share) * lag_s)
        late_deg = parts.late(jaw_deg, STEP_S, share * lag_s, poles_s)
        jaw_deg = jaw_deg + (late_deg - jaw_deg) * strength("sensor_lag") / lag_s
    if sizes.get("sensor_drift"):
        warm = 1.0 - np.exp(-TIME_S / drawn["sensor_drift"]["tau_s"])
        jaw_deg = jaw_deg + strength("sensor_drift") * warm / warm[-1]
    return np.asarray(jaw_deg + strength("sensor_offset"))


def _noise(noise: str, rng: np.random.Generator) -> tuple[Array, float]:
    """Noise on the jaw and its rms, in deg."""
    if noise == "none":
        return np.zeros(len(TIME_S)), 0.0
    slow = noise == "trap"
    rms_deg = rng.uniform(0.03, 0.1) * (rng.uniform(2.0, 3.0) if slow else 1.0)
    taus_s = np.array([0.0, rng.uniform(0.005, 0.03), rng.uniform(0.5, 1.5) if slow else rng.uniform(0.1, 0.3)])
    shares = np.array([0.1, 0.3, 0.6] if slow else [0.3, 0.45, 0.25])
    return rms_deg * coloured(rng, len(TIME_S), STEP_S, taus_s, shares), rms_deg
