"""Swing of the load: it rings after each start and stop, and a little while it runs."""

import numpy as np

from pipeline.ground.kinematics import RAD_PER_TURN
from pipeline.rig.authors.lattice.kernels import Array, oscillation
from pipeline.rig.authors.lattice.law import Law, Params, Rng, log_uniform
from pipeline.rig.authors.lattice.world import World

EFFECT = "load_swing"
LIMIT = 12.0


def _acceleration(world: World) -> Array:
    return np.asarray(np.gradient(np.gradient(world.base_mm, world.step_s), world.step_s))


def _rung(world: World, frequency_hz: float, damping: float, drag_per_mm: float) -> Array:
    return np.asarray(
        oscillation(-_acceleration(world), world.step_s, RAD_PER_TURN * frequency_hz, damping, drag_per_mm)
    )


def _draw_linear(rng: Rng, _world: World) -> Params:
    return {"frequency_hz": log_uniform(rng, 0.5, 2.0), "damping": log_uniform(rng, 0.01, 0.06)}


def _act_linear(world: World, contraction_mm: Array, p: Params) -> Array:
    return np.asarray(contraction_mm + p["share"] * _rung(world, p["frequency_hz"], p["damping"], 0.0))


def _draw_drag(rng: Rng, _world: World) -> Params:
    base = {"frequency_hz": log_uniform(rng, 0.5, 1.6), "damping": log_uniform(rng, 0.004, 0.012)}
    return {**base, "drag_per_mm": log_uniform(rng, 0.1, 0.8)}


def _act_drag(world: World, contraction_mm: Array, p: Params) -> Array:
    """Great swings are damped more than small ones: by the air, with the square of the speed."""
    rung = _rung(world, p["frequency_hz"], p["damping"], p["drag_per_mm"])
    return np.asarray(contraction_mm + p["share"] * rung)


def _draw_two(rng: Rng, world: World) -> Params:
    first = _draw_linear(rng, world)
    second_hz = float(first["frequency_hz"] * rng.uniform(1.4, 2.2))
    second = {"second_hz": second_hz, "second_damping": log_uniform(rng, 0.01, 0.05)}
    return {**first, **second, "second_share": float(rng.uniform(0.5, 1.0))}


def _act_two(world: World, contraction_mm: Array, p: Params) -> Array:
    """A pendulum and a bounce, both rung by the same starts."""
    rung = _rung(world, p["frequency_hz"], p["damping"], 0.0)
    rung += p["second_share"] * _rung(world, p["second_hz"], p["second_damping"], 0.0)
    return np.asarray(contraction_mm + p["share"] * rung)


LAWS = (
    Law(EFFECT, "one_mode", "length", "share", LIMIT, _draw_linear, _act_linear),
    Law(EFFECT, "drag_by_speed", "length", "share", LIMIT, _draw_drag, _act_drag),
    Law(EFFECT, "two_modes", "length", "share", LIMIT, _draw_two, _act_two),
)
