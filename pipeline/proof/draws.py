"""Each effect's parameters, drawn for a bench and a protocol, as a function of one strength."""

from collections.abc import Callable
from typing import Any

import numpy as np

from ..ground.kinematics import RAD_PER_TURN, Array
from ..rig import effects
from .bench import Bench
from .protocol import Protocol
from .wander import WANDERS, wander

Parameters = dict[str, Any]
Strength = Callable[[float], Parameters]  # at 1 the effect is of a size that is often met

OPEN_SET = tuple(name for name in effects.names() if name.startswith("x_"))
NAMED = tuple(name for name in effects.names() if not name.startswith("x_"))

# The parameters that grow with the strength. The two effects that have none, for which the end comes nearer and the
# bed of fibres softer, are in `_of`.
GROWS = {
    "axial_elasticity": ("compliance_mm_per_n",),
    "backlash": ("turns",),
    "clamp_slip": ("slips_mm",),
    "count_slip": ("turns",),
    "creep": ("compliance_mm_per_n", "yield_mm"),
    "eccentricity": ("run_out_mm",),
    "friction_hysteresis": ("turns_per_n",),
    "jam": ("share",),
    "load_swing": ("share",),
    "overtwist": ("gain_mm_per_turn",),
    "plastic_elongation": ("stretch_mm",),
    "sensor_drift": ("mm_per_hour",),
    "sensor_lag": ("lag_s",),
    "shaft_windup": ("compliance_rad_per_n_mm",),
    "slack": ("take_up_mm", "bed_mm"),
    "stick_slip": ("step_mm",),
    "stiffening": ("compliance_mm_per_n",),
    "thermal": ("expansion_mm_per_k",),
    "viscous_loss": ("mm_per_rate",),
    "wear": ("share_per_m",),
    "x_ballooning": ("mm_per_rate2",),
    "x_encoder_interpolation": ("error_turns",),
    "x_floor_sway": ("sway_mm",),
    "x_humidity": ("swell_mm",),
    "x_magnetic_scale": ("error_mm",),
    "x_string_tangling": ("scatter",),
}
EITHER_SIGN = ("sensor_drift", "thermal", "wear")  # a zero drifts up or down, a fibre may shrink, a worn one may fuzz
MOST = {"share": 0.95, "lag_s": 0.5, "turns": 2.0}  # beyond which it would be another thing


def draw_effect(
    name: str, bench: Bench, protocol: Protocol, rng: np.random.Generator, steady: bool = False
) -> Strength:
    """Parameters of an effect by its strength, its shape and sign being drawn; unless `steady`, some wander."""
    shape = _shape(name, bench, protocol, rng)
    sign = float(rng.choice([-1.0, 1.0])) if name in EITHER_SIGN else 1.0
    if name in WANDERS and not steady:
        shape["unsteady"] = wander(WANDERS[name], rng)

    def of(strength: float) -> Parameters:
        parameters = dict(shape)
        for key in GROWS.get(name, ()):
            grown = np.minimum(np.multiply(shape[key], sign * strength), MOST.get(key, np.inf))
            parameters[key] = grown.tolist()
        if name == "radius_compaction":
            parameters["bed_mpa"] = shape["bed_mpa"] / strength
        elif name == "end_stop":
            parameters["at_mm"] = bench.stroke_mm * (1.0 - min(0.03 * strength, 0.9))
        return parameters

    return of


def _damage(bench: Bench, protocol: Protocol, squared: Callable[[Array, Array], Array]) -> Array:
    """What tires a part, summed over the recording, after each step."""
    return np.cumsum(squared(protocol.told.motor_turns, protocol.told.load_n)) * protocol.step_s


def _lives(damage: Array, events: int, rng: np.random.Generator) -> list[float]:
    """Damage at which events happen, so that they fall between a fifth and three quarters of the recording."""
    at = np.sort(rng.uniform(0.2, 0.75, events)) * (len(damage) - 1)
    return [float(life) for life in damage[at.astype(int)]]


def _shape(name: str, bench: Bench, protocol: Protocol, rng: np.random.Generator) -> Parameters:
    """What is drawn of an effect; what is left out stays at the effect's own default."""
    lasts_s = float(protocol.told.time_s[-1])
    top, load_n = bench.top_turns, bench.loads_n[0]
    work_n_mm = load_n * bench.stroke_mm
    phase_rad = float(rng.uniform(0.0, 2.0 * np.pi))
    uniform = lambda low, high: float(rng.uniform(low, high))  # noqa: E731
    if name == "plastic_elongation":
        shares = rng.dirichlet([3.0, 3.0, 3.0])
        works = work_n_mm * np.array([uniform(0.2, 0.5), uniform(0.8, 2.0), uniform(4.0, 10.0)])
        return {"stretch_mm": (0.4 * shares).tolist(), "work_n_mm": works.tolist()}
    if name == "creep":
        taus = [uniform(2.0, 5.0), uniform(12.0, 25.0), uniform(60.0, 120.0)]
        compliance = 0.3 * rng.dirichlet([3.0, 4.0, 3.0]) / load_n
        return {"compliance_mm_per_n": compliance.tolist(), "tau_s": taus, "yield_mm": uniform(0.05, 0.15)}
    if name == "count_slip":

        def torque(turns: Array, newton: Array) -> Array:
            open_mm = bench.true.separator_mm + turns * RAD_PER_TURN * bench.true.radius_mm
            sine = open_mm / np.hypot(open_mm, bench.true.torsion_zone_mm)
            return (newton * bench.true.radius_mm * sine / bench.torque_n_mm) ** 2

        events = int(rng.integers(1, 4))
        lives_s = _lives(_damage(bench, protocol, torque), events, rng)
        return {"turns": (0.3 * rng.uniform(0.6, 1.4, events)).tolist(), "lives_s": lives_s} | {
            "torque_n_mm": bench.torque_n_mm
        }
    if name == "clamp_slip":
        events = int(rng.integers(1, 3))
        lives_s = _lives(_damage(bench, protocol, lambda _, newton: (newton / load_n) ** 2), events, rng)
        return {"slips_mm": (0.3 * rng.uniform(0.6, 1.4, events)).tolist(), "lives_s": lives_s, "load_n": load_n}
    if name == "thermal":
        if rng.random() < 0.5:  # the string warms itself, and nobody measures how much
            return {"heating_k_per_j": uniform(1.0, 4.0), "string_s": uniform(25.0, 60.0), "expansion_mm_per_k": 0.02}
        warm_s = (lasts_s * uniform(0.15, 0.4), lasts_s * uniform(0.55, 0.8))
        room = {"heating_k_per_j": 0.0, "room_k": uniform(4.0, 12.0), "warm_s": warm_s}
        return room | {"string_s": uniform(8.0, 30.0), "rig_s": uniform(60.0, 150.0), "expansion_mm_per_k": 0.02}
    rest: dict[str, Parameters] = {
        "axial_elasticity": {
            "compliance_mm_per_n": 0.02,
            "toe_n": uniform(1.0, 3.0) * load_n,
            "late": uniform(0.08, 0.12),
            "late_s": uniform(4.0, 8.0),
        },
        "backlash": {"turns": 0.2, "firmness": uniform(2.0, 4.0)},
        "eccentricity": {"run_out_mm": 0.1, "phase_rad": phase_rad, "joint": uniform(0.08, 0.2)},
        "end_stop": {"bumper": uniform(100.0, 400.0), "stretch_n_per_mm": bench.true.stiffness_n_per_mm},
        "friction_hysteresis": {
            "turns_per_n": 0.1 / load_n,
            "reach_turns": uniform(0.1, 0.5),
            "tail": uniform(0.7, 1.5),
        },
        "jam": {"critical_turns": top * uniform(0.55, 0.8), "share": 0.3, "spread_turns": top * uniform(0.05, 0.15)},
        "load_swing": {"share": 0.3, "frequency_hz": uniform(0.7, 1.6), "damping": uniform(0.01, 0.04)},
        "overtwist": {
            "critical_turns": top * uniform(0.6, 0.8),
            "gain_mm_per_turn": 0.3,
            "spread_turns": top * uniform(0.015, 0.03),
            "memory_turns": top * uniform(0.08, 0.2),
        },
        "radius_compaction": {"bed_mpa": 300.0, "exponent": uniform(1.3, 3.0)},
        "sensor_drift": {"mm_per_hour": 1.0, "settle_s": uniform(80.0, 250.0), "ageing": uniform(0.3, 0.8)},
        "sensor_lag": {"lag_s": 0.06},
        "shaft_windup": {
            "compliance_rad_per_n_mm": 0.2,
            "hardens_n_mm": bench.torque_n_mm * uniform(0.3, 1.0),
            "hardening": uniform(0.3, 0.5),
        },
        "slack": {"take_up_mm": 0.4, "bed_mm": uniform(0.1, 0.25), "hardness": uniform(1.2, 2.0)},
        "stick_slip": {
            "step_mm": 0.1,
            "float_mm_per_s": bench.stroke_mm / uniform(4.0, 8.0),
            "age_s": uniform(0.2, 0.6),
        },
        "stiffening": {
            "compliance_mm_per_n": 0.03,
            "gain": uniform(0.3, 0.6),
            "work_n_mm": work_n_mm * uniform(2.0, 6.0),
            "order": uniform(2.0, 3.5),
        },
        "viscous_loss": {"mm_per_rate": 0.03, "thinning": uniform(0.7, 0.85), "settle_s": uniform(0.02, 0.06)},
        "wear": {"share_per_m": 0.03, "edge": uniform(0.3, 0.8), "first_m": uniform(0.05, 0.15)},
        "x_ballooning": {"mm_per_rate2": 0.01, "settle_s": uniform(0.05, 0.2)},
        "x_encoder_interpolation": {"error_turns": 0.02, "lines": int(rng.integers(2, 4)), "phase_rad": phase_rad},
        "x_floor_sway": {"sway_mm": 0.05, "frequency_hz": uniform(0.15, 0.6), "phase_rad": phase_rad},
        "x_humidity": {"swell_mm": 0.1, "period_s": lasts_s * uniform(0.18, 0.3), "phase": uniform(0.0, 1.0)},
        "x_magnetic_scale": {"error_mm": 0.05, "pole_mm": uniform(1.0, 3.0), "phase_rad": phase_rad},
        "x_string_tangling": {"scatter": 0.005, "open_turns": 0.15 * top, "seed": int(rng.integers(1 << 31))},
    }
    return rest[name]
