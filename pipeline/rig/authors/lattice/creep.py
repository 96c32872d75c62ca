"""Creep: under tension along its strands the string lengthens with time, and takes it back when they are let go."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array, relaxed, stepped
from pipeline.rig.authors.lattice.law import Law, Params, Rng, log_uniform
from pipeline.rig.authors.lattice.world import World

EFFECT = "creep"
LIMIT = 12.0
BRANCHES = 11


def _stress(world: World, p: Params) -> Array:
    """Tension along the strands: a part that the load makes untwisted, the rest with the square of the lever."""
    twisted = p["untwisted_share"] + (1.0 - p["untwisted_share"]) * np.square(world.lever)
    return np.asarray(world.pull * twisted * world.wander)


def _share(rng: Rng) -> float:
    return float(rng.uniform(0.1, 0.5))


def _kelvin(world: World, stress: Array, tau_s: float) -> Array:
    return np.asarray(relaxed(stress, world.step_s, tau_s, stress[0]))


def _draw_pair(rng: Rng, _world: World) -> Params:
    taus = {"tau_1_s": log_uniform(rng, 4.0, 15.0), "tau_2_s": log_uniform(rng, 40.0, 160.0)}
    return {"untwisted_share": _share(rng), **taus, "first_share": float(rng.uniform(0.3, 0.7))}


def _act_pair(world: World, contraction_mm: Array, p: Params) -> Array:
    stress = _stress(world, p)
    first, second = (_kelvin(world, stress, p[tau]) for tau in ("tau_1_s", "tau_2_s"))
    strain = p["first_share"] * first + (1.0 - p["first_share"]) * second
    return np.asarray(contraction_mm - p["compliance_mm"] * strain)


def _draw_findley(rng: Rng, _world: World) -> Params:
    return {"untwisted_share": _share(rng), "power": float(rng.uniform(0.2, 0.45))}


def _act_findley(world: World, contraction_mm: Array, p: Params) -> Array:
    """Strain that grows as a power of time, by a spectrum of Kelvin elements from 0.5 s to an hour."""
    stress, taus = _stress(world, p), np.geomspace(0.5, 3600.0, BRANCHES)
    weights = taus ** p["power"]
    strain = sum(weight * _kelvin(world, stress, tau) for weight, tau in zip(weights / weights[6], taus, strict=True))
    return np.asarray(contraction_mm - p["compliance_mm"] * strain)


def _draw_burgers(rng: Rng, _world: World) -> Params:
    kelvin = {"untwisted_share": _share(rng), "tau_s": log_uniform(rng, 8.0, 60.0)}
    return {**kelvin, "flow_share": float(rng.uniform(0.1, 0.3))}


def _act_burgers(world: World, contraction_mm: Array, p: Params) -> Array:
    """One Kelvin element, and a dashpot whose flow over the whole session is a share of the element's strain."""
    stress = _stress(world, p)
    flow = np.cumsum(stress) / stress.size / stress.mean()
    strain = _kelvin(world, stress, p["tau_s"]) + p["flow_share"] * flow
    return np.asarray(contraction_mm - p["compliance_mm"] * strain)


def _draw_eyring(rng: Rng, _world: World) -> Params:
    eyring = {"untwisted_share": _share(rng), "activation": log_uniform(rng, 0.25, 0.8)}
    return {**eyring, "tau_s": log_uniform(rng, 25.0, 160.0)}


@stepped
def _eyring(stress: Array, step_s: float, activation: float, tau_s: float) -> Array:
    """A spring beside an Eyring dashpot: z' = s/τ sinh((σ − z)/s), each step exact for its secant rate."""
    out = np.empty_like(stress)
    state = stress[0]
    for i in range(stress.size):
        lead = stress[i] - state
        over = min(abs(lead) / activation, 40.0)
        secant = np.sinh(over) / over if over > 1e-6 else 1.0
        state = stress[i] - lead * np.exp(-step_s / tau_s * secant)
        out[i] = state
    return out


def _act_eyring(world: World, contraction_mm: Array, p: Params) -> Array:
    strain = _eyring(_stress(world, p), world.step_s, p["activation"], p["tau_s"])
    return np.asarray(contraction_mm - p["compliance_mm"] * strain)


LAWS = (
    Law(EFFECT, "kelvin_pair", "length", "compliance_mm", LIMIT, _draw_pair, _act_pair),
    Law(EFFECT, "findley_spectrum", "length", "compliance_mm", LIMIT, _draw_findley, _act_findley),
    Law(EFFECT, "burgers", "length", "compliance_mm", LIMIT, _draw_burgers, _act_burgers),
    Law(EFFECT, "eyring_dashpot", "length", "compliance_mm", LIMIT, _draw_eyring, _act_eyring),
)
