"""Odd things at the bench that no list of string physics holds: people, draughts, rails and corners."""

import numpy as np

from pipeline.ground.kinematics import RAD_PER_TURN
from pipeline.rig.authors.lattice.kernels import Array, oscillation
from pipeline.rig.authors.lattice.law import Law, Params, Rng
from pipeline.rig.authors.lattice.world import World


def _draw_leaning(rng: Rng, world: World) -> Params:
    end_s, count = float(world.time_s[-1]), int(rng.integers(5, 10))
    return {
        "at_s": [float(at) for at in np.sort(rng.uniform(0.04, 0.94, count)) * end_s],
        "lasts_s": [float(lasts) for lasts in rng.uniform(2.0, 9.0, count)],
        "pressed": [float(pressed) for pressed in rng.uniform(0.4, 1.0, count)],
    }


def _act_leaning(world: World, reading_mm: Array, p: Params) -> Array:
    """Somebody leans on the bench now and then, and it bends by as much as they lean."""
    bent = np.zeros_like(reading_mm)
    for at_s, lasts_s, pressed in zip(p["at_s"], p["lasts_s"], p["pressed"], strict=True):
        since, until = (world.time_s - at_s) / 0.25, (at_s + lasts_s - world.time_s) / 0.25
        bent += pressed * 0.25 * (1.0 + np.tanh(since)) * (1.0 + np.tanh(until))
    return np.asarray(reading_mm - p["bend_mm"] * bent)


def _draw_draught(rng: Rng, _world: World) -> Params:
    return {"frequency_hz": float(rng.uniform(0.15, 0.5)), "seed": int(rng.integers(1 << 30))}


def _act_draught(world: World, reading_mm: Array, p: Params) -> Array:
    """The draught of a fan pushes the load: a slow swing that comes and goes by chance."""
    push = np.random.default_rng(p["seed"]).normal(size=reading_mm.size) / np.sqrt(world.step_s)
    swing = oscillation(push, world.step_s, RAD_PER_TURN * p["frequency_hz"], 0.06, 0.0)
    return np.asarray(reading_mm + p["sway_mm"] * swing / swing.std())


def _draw_joint(rng: Rng, world: World) -> Params:
    joints = np.sort(rng.uniform(0.15, 0.9, int(rng.integers(1, 4)))) * world.span_mm
    return {"joints_mm": [float(joint) for joint in joints], "wide_mm": float(world.span_mm * rng.uniform(0.02, 0.05))}


def _act_joint(_world: World, contraction_mm: Array, p: Params) -> Array:
    """The carriage climbs over the joints of its rail, at the same places both ways."""
    way = contraction_mm - contraction_mm[0]
    bumps = sum(np.exp(-0.5 * np.square((way - joint) / p["wide_mm"])) for joint in p["joints_mm"])
    return np.asarray(contraction_mm - p["bump_mm"] * bumps)


def _draw_snag(rng: Rng, world: World) -> Params:
    return {"every_strokes": int(rng.integers(2, 4)), "seed": int(rng.integers(1 << 30))}


def _act_snag(world: World, reading_mm: Array, p: Params) -> Array:
    """The sensor's cable drags over an edge: in some strokes it pulls the reading down while the load is high."""
    rng = np.random.default_rng(p["seed"])
    caught = (rng.random(world.strokes + 1) < 1.0 / p["every_strokes"]) * rng.uniform(0.6, 1.0, world.strokes + 1)
    edge_mm = rng.uniform(0.45, 0.75) * world.span_mm
    high = 0.5 * (1.0 + np.tanh((world.base_mm - world.base_mm[0] - edge_mm) / (0.03 * world.span_mm)))
    return np.asarray(reading_mm - p["pulled_mm"] * caught[world.stroke] * high)


LAWS = (
    Law("x_leaning", "tanh_pushes", "reading", "bend_mm", 4.0, _draw_leaning, _act_leaning),
    Law("x_draught", "narrow_band", "reading", "sway_mm", 3.0, _draw_draught, _act_draught),
    Law("x_rail_joint", "bell", "reading", "bump_mm", 3.0, _draw_joint, _act_joint),
    Law("x_cable_snag", "at_an_edge", "reading", "pulled_mm", 4.0, _draw_snag, _act_snag),
)
