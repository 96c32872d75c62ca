"""Slack at the start of the twist: the string must be taken up before it lifts anything."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array
from pipeline.rig.authors.lattice.law import Law, Params, Rng, nothing
from pipeline.rig.authors.lattice.world import World

EFFECT = "slack"


def _lifted(world: World, contraction_mm: Array) -> tuple[Array, float]:
    floor_mm = float(world.base_mm.min())
    return contraction_mm - floor_mm, floor_mm


def _act_hard(world: World, contraction_mm: Array, p: Params) -> Array:
    lifted, floor_mm = _lifted(world, contraction_mm)
    return np.asarray(floor_mm + np.maximum(lifted - p["slack_mm"], 0.0))


def _draw_soft(rng: Rng, _world: World) -> Params:
    return {"softness": float(rng.uniform(0.1, 0.35))}


def _act_soft(world: World, contraction_mm: Array, p: Params) -> Array:
    """The load leaves its stop by and by: the take-up is rounded over a share of the slack."""
    lifted, floor_mm = _lifted(world, contraction_mm)
    width = p["softness"] * p["slack_mm"] + 1e-9
    return np.asarray(floor_mm + width * np.logaddexp(0.0, (lifted - p["slack_mm"]) / width))


def _draw_catenary(rng: Rng, world: World) -> Params:
    return {"straight_mm": float(world.span_mm * rng.uniform(0.04, 0.14))}


def _act_catenary(world: World, contraction_mm: Array, p: Params) -> Array:
    """A sagging string: its spare length falls with the square of a tension that rises as the string is taken up."""
    lifted, _ = _lifted(world, contraction_mm)
    spare = p["slack_mm"] * np.square(1.0 + np.maximum(lifted, 0.0) / p["straight_mm"]) ** -1.0
    return np.asarray(contraction_mm - (p["slack_mm"] - spare))


LAWS = (
    Law(EFFECT, "hard_stop", "contraction", "slack_mm", 5.0, nothing, _act_hard),
    Law(EFFECT, "soft_take_up", "contraction", "slack_mm", 5.0, _draw_soft, _act_soft),
    Law(EFFECT, "catenary", "contraction", "slack_mm", 5.0, _draw_catenary, _act_catenary),
)
