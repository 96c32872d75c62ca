"""Stick and slip of the load's carriage on its rail: the reading stops, then jumps after the string."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array, stepped
from pipeline.rig.authors.lattice.law import Law, Params, Rng, log_uniform
from pipeline.rig.authors.lattice.world import World

EFFECT = "stick_slip"


@stepped
def _slider(pulled: Array, step_s: float, force: Array, a: float, b: float, steady: float, v0: float, dc: float):  # type: ignore[no-untyped-def]
    """A slider behind a spring with rate-and-state friction, ageing law; `force` is normal force over stiffness.

    Its speed is solved implicitly with a small drag that keeps slips finite.
    """
    out = np.empty_like(pulled)
    at, age, w = pulled[0], dc / v0 * 50.0, 0.0
    drag_s = 0.002
    for i in range(pulled.size):
        psi = (steady + b * np.log(v0 * age / dc)) / a
        psi = min(max(psi, 1.0), 60.0)
        scale = 2.0 * v0 * np.exp(-psi)
        lead, na, slack = pulled[i] - at, force[i] * a, (step_s + drag_s) * scale
        # na·w + slack·sinh(w) = lead, rising in w: Newton from above, where it is convex
        target = abs(lead)
        w = min(target / na, np.arcsinh(target / slack))
        for _ in range(20):
            rest = na * w + slack * np.sinh(w) - target
            turn = rest / (na + slack * np.cosh(w))
            w -= turn
            if abs(turn) < 1e-7 * (1.0 + w):
                break
        speed = scale * np.sinh(w) * (1.0 if lead > 0 else -1.0)
        at += speed * step_s
        gone = abs(speed) * step_s / dc
        if gone > 1e-6:
            age = age * np.exp(-gone) + dc / abs(speed) * -np.expm1(-gone)
        else:
            age += step_s
        out[i] = at
    return out


def _draw_rate_state(rng: Rng, world: World) -> Params:
    pace = world.span_mm / world.top_turns * float(np.percentile(np.abs(world.rate), 80))
    return {
        "a": 0.012,
        "b": float(rng.uniform(0.05, 0.08)),
        "steady": float(rng.uniform(0.02, 0.06)),
        "v0_mm_per_s": pace * float(rng.uniform(5.0, 12.0)),
        "critical_slip_mm": log_uniform(rng, 0.002, 0.006),
    }


def _act_rate_state(world: World, contraction_mm: Array, p: Params) -> Array:
    force = p["normal_mm"] * world.pull * world.wander
    shape = (p["a"], p["b"], p["steady"], p["v0_mm_per_s"], p["critical_slip_mm"] * p["normal_mm"])
    return np.asarray(_slider(contraction_mm, world.step_s, force, *shape))


@stepped
def _jumps(pulled: Array, step_s: float, limits: Array, leaves: Array, ageing: float, young_s: float) -> Array:
    """A slider that sticks until its spring is beyond a limit, then jumps to a share of it within 40 ms.

    The limits are taken in turn; each grows with the logarithm of the time that the slider has stuck.
    """
    out = np.empty_like(pulled)
    at, goal, stuck_s, k = pulled[0], pulled[0], 0.0, 0
    kept = np.exp(-step_s / 0.012)
    for i in range(pulled.size):
        lead = pulled[i] - goal
        limit = limits[k % limits.size] * (1.0 + ageing * np.log1p(stuck_s / young_s))
        if abs(lead) > limit:
            goal = pulled[i] - leaves[k % leaves.size] * lead
            stuck_s = 0.0
            k += 1
        stuck_s += step_s
        at = goal + (at - goal) * kept
        out[i] = at
    return out


def _draw_thresholds(rng: Rng, _world: World) -> Params:
    drawn = {"spread": float(rng.uniform(0.15, 0.45)), "leaves": float(rng.uniform(-0.2, 0.2))}
    return {**drawn, "seed": int(rng.integers(1 << 30))}


def _act_thresholds(world: World, contraction_mm: Array, p: Params) -> Array:
    rng = np.random.default_rng(p["seed"])
    limits = p["limit_mm"] * np.exp(p["spread"] * rng.normal(size=4096))
    leaves = np.clip(p["leaves"] + 0.15 * rng.normal(size=4096), -0.6, 0.6)
    return np.asarray(_jumps(contraction_mm, world.step_s, limits, leaves, 0.0, 1.0))


def _draw_ageing(rng: Rng, _world: World) -> Params:
    drawn = {"ageing": float(rng.uniform(0.15, 0.4)), "young_s": log_uniform(rng, 0.02, 0.1)}
    return {**drawn, "leaves": float(rng.uniform(-0.1, 0.15)), "seed": int(rng.integers(1 << 30))}


def _act_ageing(world: World, contraction_mm: Array, p: Params) -> Array:
    rng = np.random.default_rng(p["seed"])
    limits = p["limit_mm"] * np.exp(0.06 * rng.normal(size=4096))
    leaves = np.full(1, p["leaves"])
    return np.asarray(_jumps(contraction_mm, world.step_s, limits, leaves, p["ageing"], p["young_s"]))


LAWS = (
    Law(EFFECT, "rate_and_state", "contraction", "normal_mm", 12.0, _draw_rate_state, _act_rate_state),
    Law(EFFECT, "random_thresholds", "contraction", "limit_mm", 2.5, _draw_thresholds, _act_thresholds),
    Law(EFFECT, "ageing_contact", "contraction", "limit_mm", 2.0, _draw_ageing, _act_ageing),
)
