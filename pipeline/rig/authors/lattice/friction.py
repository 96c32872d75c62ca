"""Friction between the strands: the string's twist trails the motor's by a state that saturates with the load."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array, stepped
from pipeline.rig.authors.lattice.law import Law, Params, Rng, log_uniform
from pipeline.rig.authors.lattice.world import World

EFFECT = "friction_hysteresis"
SLIDERS = 14


def _capacity(world: World, p: Params) -> Array:
    """Twist by which sliding strands trail, in turns: grows with the load and, in part, with the lever."""
    lever = 1.0 - p["lever_share"] + p["lever_share"] * world.lever
    return np.asarray(p["width_turns"] * world.pull ** p["load_power"] * lever * world.wander)


def _grip(rng: Rng, _world: World) -> Params:
    return {
        "load_power": float(rng.uniform(0.4, 1.1)),
        "lever_share": float(rng.uniform(0.0, 0.9)),
        "presliding": log_uniform(rng, 0.4, 2.5),  # twist to slide, in capacities
    }


def _draw_dahl(rng: Rng, world: World) -> Params:
    return {**_grip(rng, world), "exponent": float(rng.choice([1.0, 1.5, 2.0]))}


@stepped
def _dahl(twist: Array, capacity: Array, presliding: float, exponent: float) -> Array:
    out = np.zeros_like(twist)
    state = 0.0
    for i in range(1, twist.size):
        step, most = twist[i] - twist[i - 1], capacity[i] + 1e-12
        way = 1.0 if step > 0 else -1.0
        rate = abs(1.0 - way * state / most) ** (exponent - 1.0) * abs(step) / (presliding * most)
        state = way * most + (state - way * most) * np.exp(-rate)
        out[i] = state
    return out


def _act_dahl(world: World, turns: Array, p: Params) -> Array:
    return turns - _dahl(turns, _capacity(world, p), p["presliding"], p["exponent"])


def _draw_lugre(rng: Rng, world: World) -> Params:
    grip = {**_grip(rng, world), "stribeck_share": float(rng.uniform(0.04, 0.15))}
    return {**grip, "stribeck_rate": float(0.25 * np.percentile(np.abs(world.rate), 80))}


@stepped
def _bristles(rate: Array, sliding: Array, presliding: float, step_s: float) -> Array:
    """Deflection of LuGre's bristles, over their stiffness: z' = v − |v| z / g(v), stepped implicitly."""
    out = np.zeros_like(rate)
    state = 0.0
    for i in range(1, rate.size):
        state += rate[i] * step_s / presliding
        state /= 1.0 + abs(rate[i]) * step_s / (presliding * (sliding[i] + 1e-12))
        out[i] = state
    return out


def _act_lugre(world: World, turns: Array, p: Params) -> Array:
    rate = np.gradient(turns, world.step_s)
    stribeck = 1.0 + p["stribeck_share"] * np.exp(-np.square(rate / p["stribeck_rate"]))
    return turns - _bristles(rate, _capacity(world, p) * stribeck, p["presliding"], world.step_s)


def _draw_bouc_wen(rng: Rng, world: World) -> Params:
    return {**_grip(rng, world), "exponent": float(rng.uniform(1.0, 2.2)), "beta": float(rng.uniform(0.5, 0.85))}


@stepped
def _bouc_wen(twist: Array, capacity: Array, presliding: float, exponent: float, beta: float) -> Array:
    out = np.zeros_like(twist)
    state = 0.0
    for i in range(1, twist.size):
        most = capacity[i] + 1e-12
        whole = (twist[i] - twist[i - 1]) / presliding
        parts = min(200, 1 + int(abs(whole) / (0.1 * most)))
        for _ in range(parts):
            step = whole / parts
            same = 1.0 if step * state > 0 else -1.0
            state += step * (1.0 - (abs(state) / most) ** exponent * (beta * same + 1.0 - beta))
            state = min(max(state, -1.05 * most), 1.05 * most)
        out[i] = state
    return out


def _act_bouc_wen(world: World, turns: Array, p: Params) -> Array:
    return turns - _bouc_wen(turns, _capacity(world, p), p["presliding"], p["exponent"], p["beta"])


def _draw_sliders(rng: Rng, world: World) -> Params:
    grip = _grip(rng, world)
    return {**grip, "spectrum_power": float(rng.uniform(0.6, 2.0)), "presliding": log_uniform(rng, 0.8, 3.0)}


@stepped
def _sliders(twist: Array, capacity: Array, presliding: float, yields: Array) -> Array:
    out = np.zeros_like(twist)
    held = np.zeros(yields.size)
    for i in range(1, twist.size):
        step = (twist[i] - twist[i - 1]) / presliding
        total = 0.0
        for j in range(yields.size):
            most = capacity[i] * yields[j]
            held[j] = min(max(held[j] + step, -most), most)
            total += held[j]
        out[i] = total / yields.size
    return out


def _act_sliders(world: World, turns: Array, p: Params) -> Array:
    yields = ((np.arange(SLIDERS) + 0.5) / SLIDERS) ** p["spectrum_power"]
    return turns - _sliders(turns, _capacity(world, p), p["presliding"], yields / yields.mean())


def _draw_capstan(rng: Rng, world: World) -> Params:
    return {"mu": float(rng.uniform(0.3, 1.5)), "presliding_turns": float(world.top_turns * rng.uniform(0.005, 0.03))}


def _act_capstan(world: World, contraction_mm: Array, p: Params) -> Array:
    """The helix holds back a share of the tension that grows exponentially with its angle; the string gives."""
    turned = _dahl(world.turns, np.ones_like(world.turns), p["presliding_turns"], 1.0)
    angle = np.arctan(world.slope)
    held = world.pull * np.expm1(p["mu"] * angle) / np.expm1(p["mu"] * angle.max())
    return np.asarray(contraction_mm - p["loss_mm"] * world.wander * held * turned)


LAWS = (
    Law(EFFECT, "dahl", "twist", "width_turns", 1.5, _draw_dahl, _act_dahl),
    Law(EFFECT, "lugre", "twist", "width_turns", 1.5, _draw_lugre, _act_lugre),
    Law(EFFECT, "bouc_wen", "twist", "width_turns", 1.5, _draw_bouc_wen, _act_bouc_wen),
    Law(EFFECT, "sliders_in_parallel", "twist", "width_turns", 1.5, _draw_sliders, _act_sliders),
    Law(EFFECT, "helix_capstan", "length", "loss_mm", 2.0, _draw_capstan, _act_capstan),
)
