"""A moving mass, as recorded: a carriage on a screw rides a reference, the controller's force is logged."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pandas as pd
from scipy.signal import butter, sosfiltfilt

from ...ground.kinematics import Array
from .made import Kind, Made, OfRig, Truth, check
from .made import told as truth_of
from .mass_loop import Controller, Plant, ride
from .mass_plan import STEP_S, TIME_S, told
from .streams import coloured, counted, stream, wander

NOMINAL_KG, TOLERANCE = 100.0, 0.1
POSITION_QUANTUM_M, FORCE_QUANTUM_N = 1e-6, 0.0107
ALIKE_HZ = 30.0  # up to which an encoder's lag is told as force

EFFECTS = {
    "viscous_loss": Kind("viscous_loss", "N s/m", "force over speed at 0.1 m/s"),
    "friction_hysteresis": Kind("friction_hysteresis", "N", "sliding friction well above the Stribeck speed"),
    "sensor_offset": Kind("sensor_offset", "N", "constant force of the amplifier", signed=True),
    "sensor_drift": Kind("sensor_drift", "N", "what the amplifier's zero has moved in the end", signed=True),
    "sensor_lag": Kind("sensor_lag", "s", "dead time and pole of the position encoder together"),
    "eccentricity": Kind("eccentricity", "N", "amplitude of the cogging, once per turn of the screw"),
    "rail_friction": Kind(
        "friction_hysteresis", "N", "friction added at the tight end of the rail, nothing at the other"
    ),
    "x_push": Kind(None, "N", "force that leans on the carriage now and then, at random"),
}
IN_LOOP = ("viscous_loss", "friction_hysteresis", "rail_friction", "eccentricity")  # as the loop orders its forces


def record(
    seed: int,
    effects: Mapping[str, float] | None = None,
    plan: str = "bang",
    *,
    noise: str = "usual",
    take: int = 0,
) -> Made:
    """Record a moving mass: 25 s at 1 kHz of `position_m` and `force_n`, and the truth.

    The seed is the rig (its mass and the shape of its effects); plan and take draw the motion, the noise and how the
    effects wander. `effects` are sizes by name, in the units that EFFECTS tells. The noise on the force is `usual`
    (0.3 to 1 N, nearly white), `trap` (1 to 4 N, slow) or `none` (nor any quantum). ValueError for what is not known.
    """
    sizes = dict(effects or {})
    check(sizes, EFFECTS, noise)
    this = (plan, take)
    mass_kg = NOMINAL_KG * (1.0 + TOLERANCE * stream(seed, "mass").uniform(-1.5, 1.5))
    drawn = {name: _drawn(seed, this, name) for name in sizes}
    strength = {name: wander(stream(seed, *this, name, "wander"), TIME_S) for name in EFFECTS}
    outside = {name: _outside(name, size, drawn[name]) * strength[name] for name, size in sizes.items()}
    log, forces = ride(
        _plant(mass_kg, sizes, drawn, exact=noise != "none"),
        Controller(),
        np.array(told(plan, stream(seed, *this, "plan"))),
        np.array([strength[name] for name in IN_LOOP]),
        np.sum([np.zeros(len(TIME_S)), *outside.values()], axis=0),
        STEP_S,
    )
    alone = {**outside, **{name: force for name, force in zip(IN_LOOP, forces, strict=True) if name in sizes}}
    if "sensor_lag" in sizes:
        alone["sensor_lag"] = mass_kg * _accelerated(log[1] - log[0])
    said_n, noise_n = _noise(noise, stream(seed, *this, "noise"))
    samples = pd.DataFrame(
        {
            "time_s": TIME_S,
            "position_m": log[2],
            "force_n": counted(log[3] + said_n, 0.0 if noise == "none" else FORCE_QUANTUM_N),
        }
    )
    run: OfRig = {
        "run": f"mass-{plan}-{seed}-{take}",
        "actuator": "moving_mass",
        "rig": {"mass_kg": NOMINAL_KG},
        "tolerance": {"mass_kg": TOLERANCE},
    }
    truth: Truth = {
        "actuator": "moving_mass", "seed": seed, "plan": plan, "take": take,
        "parameters": {"mass_kg": mass_kg},
        "noise": {"kind": noise, "force_n": noise_n},
        "effects": truth_of(EFFECTS, sizes, alone, drawn),
    }  # fmt: skip
    true = {"position_m": log[0], "force_n": log[3], "speed_m_per_s": log[4], "acceleration_m_per_s2": log[5]}
    return Made(samples, run, truth, pd.DataFrame({**true, **alone}))


def _drawn(seed: int, this: tuple[str, int], name: str) -> dict[str, Any]:
    """The random numbers for an effect's shape, beside its size: per rig, or per take for an effect of chance."""
    rng, now = stream(seed, name), stream(seed, *this, name)
    pushes_s = np.sort(now.uniform(1.0, 23.0, 3))
    return {
        "viscous_loss": {"viscous_power": rng.uniform(0.95, 1.05)},
        "friction_hysteresis": {
            "stiction": rng.uniform(0.0, 0.12),
            "stribeck_m_per_s": rng.uniform(0.004, 0.012),
            "bristle_m": float(np.exp(rng.uniform(np.log(1e-5), np.log(8e-5)))),
        },
        "rail_friction": {
            "rail_from_m": rng.uniform(-0.02, 0.08),
            "rail_power": rng.uniform(1.4, 2.6),
            "rail_bristle_m": rng.uniform(2e-5, 8e-5),
        },
        "eccentricity": {
            "pitch_m": rng.uniform(0.008, 0.0125),
            "cogging_rad": rng.uniform(0.0, 2 * np.pi),
            "second": rng.uniform(0.05, 0.2),
        },
        "sensor_lag": {"dead_share": rng.uniform(0.25, 0.5)},
        "sensor_drift": {"tau_s": rng.uniform(8.0, 25.0)},
        "x_push": {
            "from_s": pushes_s.tolist(),
            "for_s": now.uniform(0.6, 2.0, 3).tolist(),
            "share": (now.choice([-1.0, 1.0], 3) * now.uniform(0.7, 1.3, 3)).tolist(),
        },
    }.get(name, {})


def _plant(mass_kg: float, sizes: dict[str, float], drawn: dict[str, Any], *, exact: bool) -> Plant:
    """The carriage with its effects; the shape of an absent effect has no influence."""
    shape = {key: value for name in ("viscous_loss", "friction_hysteresis", "rail_friction", "eccentricity")
             for key, value in drawn.get(name, {}).items()}  # fmt: skip
    usual = {"viscous_power": 1.0, "stiction": 0.0, "stribeck_m_per_s": 0.01, "bristle_m": 1e-4, "rail_from_m": 0.0,
             "rail_power": 2.0, "rail_bristle_m": 1e-4, "pitch_m": 0.01, "cogging_rad": 0.0, "second": 0.0}  # fmt: skip
    shape = {**usual, **shape}
    return Plant(
        mass_kg=mass_kg,
        viscous=0.1 * sizes.get("viscous_loss", 0.0),
        coulomb_n=sizes.get("friction_hysteresis", 0.0),
        rail_n=sizes.get("rail_friction", 0.0),
        rail_reach_m=0.25 - shape["rail_from_m"],
        cogging_n=sizes.get("eccentricity", 0.0),
        lag_s=sizes.get("sensor_lag", 0.0),
        dead_share=drawn.get("sensor_lag", {"dead_share": 0.0})["dead_share"],
        quantum_m=POSITION_QUANTUM_M if exact else 0.0,
        force_quantum_n=FORCE_QUANTUM_N if exact else 0.0,
        **shape,
    )


def _outside(name: str, size: float, drawn: dict[str, Any]) -> Array:
    """The outside force against the motor, which follows only time, in N; shape (samples,)."""
    if name == "sensor_offset":
        return np.full(len(TIME_S), size)
    if name == "sensor_drift":
        warm = 1.0 - np.exp(-TIME_S / drawn["tau_s"])
        return np.asarray(size * warm / warm[-1])
    push = np.zeros(len(TIME_S))
    if name == "x_push":
        for from_s, for_s, share in zip(drawn["from_s"], drawn["for_s"], drawn["share"], strict=True):
            edges = [np.tanh((TIME_S - at_s) / 0.02) for at_s in (from_s, from_s + for_s)]
            push += size * share * (edges[0] - edges[1]) / 2.0
    return push


def _accelerated(moved_m: Array) -> Array:
    """Second derivative of a position up to ALIKE_HZ, in m/s²."""
    low = butter(4, ALIKE_HZ, fs=1.0 / STEP_S, output="sos")
    return np.gradient(np.gradient(sosfiltfilt(low, moved_m), STEP_S), STEP_S)


def _noise(noise: str, rng: np.random.Generator) -> tuple[Array, float]:
    """Noise on the logged force and its rms, in N."""
    if noise == "none":
        return np.zeros(len(TIME_S)), 0.0
    slow = noise == "trap"
    rms_n = rng.uniform(1.0, 4.0) if slow else rng.uniform(0.3, 1.0)
    taus_s = np.array([0.0, rng.uniform(0.003, 0.01), rng.uniform(0.15, 1.0) if slow else rng.uniform(0.02, 0.05)])
    shares = np.array([0.1, 0.2, 0.7] if slow else [0.6, 0.25, 0.15])
    return rms_n * coloured(rng, len(TIME_S), STEP_S, taus_s, shares), rms_n
