"""Overtwist: beyond a critical twist coils nucleate and shorten the string; they melt at a smaller twist."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array, play, relaxed, stepped
from pipeline.rig.authors.lattice.law import Law, Params, Rng
from pipeline.rig.authors.lattice.world import World

EFFECT = "overtwist"
COILS = 24


def _draw_late(rng: Rng, world: World) -> Params:
    beyond = world.top_turns * rng.uniform(0.16, 0.34)
    return {"critical_turns": float(world.top_turns - beyond), "loop_turns": float(beyond * rng.uniform(0.2, 0.6))}


def _act_late(world: World, contraction_mm: Array, p: Params) -> Array:
    """The coiled length follows the excess twist up at once and down by a loop later, never below none."""
    half = 0.5 * p["loop_turns"]
    late = play(world.turns, np.full_like(world.turns, half), world.turns[0]) + half  # equals the twist going up
    coiled = np.maximum(late - p["critical_turns"], 0.0)
    return np.asarray(contraction_mm + p["mm_per_turn"] * world.wander * coiled)


@stepped
def _coils(turns: Array, nucleate: Array, melt: Array, scatter: Array) -> Array:
    """Share of the coils that are there, each a relay with its own nucleation and melting twist."""
    out = np.zeros_like(turns)
    on = np.zeros(nucleate.size)
    lowest, times, loops = nucleate.min() + scatter.min(), 0, 0
    for i in range(turns.size):
        if loops == 0 and turns[i] < lowest:
            continue
        for j in range(nucleate.size):
            shift = scatter[(times + 7 * j) % scatter.size]
            if on[j] == 0.0 and turns[i] > nucleate[j] + shift:
                on[j] = 1.0
                times += 1
                loops += 1
            elif on[j] == 1.0 and turns[i] < melt[j] + shift:
                on[j] = 0.0
                times += 1
                loops -= 1
        out[i] = loops / nucleate.size
    return out


def _draw_relays(rng: Rng, world: World) -> Params:
    scatter = {"scatter_turns": float(world.top_turns * rng.uniform(0.001, 0.004)), "seed": int(rng.integers(1 << 30))}
    return {**_draw_late(rng, world), **scatter}


def _act_relays(world: World, contraction_mm: Array, p: Params) -> Array:
    beyond = world.top_turns - p["critical_turns"]
    nucleate = p["critical_turns"] + beyond * (np.arange(COILS) + 0.5) / COILS
    scatter = p["scatter_turns"] * np.random.default_rng(p["seed"]).normal(size=997)
    loops = _coils(world.turns, nucleate, nucleate - p["loop_turns"], scatter)
    state = relaxed(loops, world.step_s, 0.08, 0.0)  # a coil snaps within a tenth of a second
    return np.asarray(contraction_mm + p["mm_per_turn"] * beyond * state)


def _draw_barrier(rng: Rng, world: World) -> Params:
    top = world.top_turns
    return {
        "critical_turns": float(top * rng.uniform(0.72, 0.88)),
        "barrier": float(rng.uniform(0.8, 1.5)),  # above 1: two states at once
        "width_turns": float(top * rng.uniform(0.03, 0.07)),
        "tau_s": float(rng.uniform(0.05, 0.2)),
    }


@stepped
def _over_barrier(tilt: Array, step_s: float, barrier: float, tau_s: float) -> Array:
    """A coiling state in a double well that the twist tilts: τ q' = tilt + b q − q³, the cubic stepped implicitly."""
    out = np.empty_like(tilt)
    state = -2.0
    share = step_s / tau_s
    for i in range(tilt.size):
        for _ in range(2):
            state = (state + 0.5 * share * (tilt[i] + barrier * state)) / (1.0 + 0.5 * share * state * state)
        out[i] = state
    return out


def _act_barrier(world: World, contraction_mm: Array, p: Params) -> Array:
    tilt = (world.turns - p["critical_turns"]) / p["width_turns"]
    state = _over_barrier(tilt, world.step_s, p["barrier"], p["tau_s"])
    coiled = 1.0 / (1.0 + np.exp(-3.0 * state))
    excess = p["width_turns"] * np.logaddexp(0.0, tilt)
    return np.asarray(contraction_mm + p["mm_per_turn"] * coiled * (excess + p["width_turns"]))


LAWS = (
    Law(EFFECT, "late_melting", "contraction", "mm_per_turn", 3.0, _draw_late, _act_late),
    Law(EFFECT, "coil_by_coil", "contraction", "mm_per_turn", 3.0, _draw_relays, _act_relays),
    Law(EFFECT, "energy_barrier", "contraction", "mm_per_turn", 3.0, _draw_barrier, _act_barrier),
)
