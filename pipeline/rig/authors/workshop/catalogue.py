"""Every effect that this author knows, with its laws by name."""

import zlib
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.workshop.bench import Bench, Law, Part
from pipeline.rig.authors.workshop.bundle import COMPACTION, WEAR
from pipeline.rig.authors.workshop.clamp_and_weight import CLAMP_SLIP, LOAD_SWING
from pipeline.rig.authors.workshop.creep import CREEP
from pipeline.rig.authors.workshop.curves import wander
from pipeline.rig.authors.workshop.driveline import BACKLASH, COUNT_SLIP, WINDUP
from pipeline.rig.authors.workshop.elongation import ELASTIC, PLASTIC, STIFFENING
from pipeline.rig.authors.workshop.friction import FRICTION
from pipeline.rig.authors.workshop.gauge import DRIFT, ECCENTRICITY, LAG
from pipeline.rig.authors.workshop.heat import THERMAL
from pipeline.rig.authors.workshop.limits import END_STOP, JAM, OVERTWIST, SLACK
from pipeline.rig.authors.workshop.nuisances import (
    AIR_CONDITIONER,
    LEANING_OPERATOR,
    MAINS_HUM,
    PASSERS_BY,
    UNREAD_SHEET,
    WIRE_DRUM,
)
from pipeline.rig.authors.workshop.rate import STICK_SLIP, VISCOUS

OF_EFFECT: dict[str, tuple[Law, ...]] = {
    "plastic_elongation": PLASTIC,
    "creep": CREEP,
    "stiffening": STIFFENING,
    "axial_elasticity": ELASTIC,
    "thermal": THERMAL,
    "radius_compaction": COMPACTION,
    "wear": WEAR,
    "friction_hysteresis": FRICTION,
    "viscous_loss": VISCOUS,
    "stick_slip": STICK_SLIP,
    "backlash": BACKLASH,
    "shaft_windup": WINDUP,
    "count_slip": COUNT_SLIP,
    "slack": SLACK,
    "jam": JAM,
    "overtwist": OVERTWIST,
    "sensor_lag": LAG,
    "sensor_drift": DRIFT,
    "eccentricity": ECCENTRICITY,
    "clamp_slip": CLAMP_SLIP,
    "end_stop": END_STOP,
    "load_swing": LOAD_SWING,
    "x_passers_by": PASSERS_BY,
    "x_air_conditioner": AIR_CONDITIONER,
    "x_mains_hum": MAINS_HUM,
    "x_leaning_operator": LEANING_OPERATOR,
    "x_wire_drum": WIRE_DRUM,
    "x_unread_sheet": UNREAD_SHEET,
}
LAWS: Mapping[str, tuple[str, ...]] = {
    effect: tuple(law.__name__ for law in laws) for effect, laws in OF_EFFECT.items()
}
# What only grows must not wander back; its sheets and ledgers scatter by themselves. A stop or a slack stays put.
STEADY = {"plastic_elongation", "stiffening", "wear", "count_slip", "clamp_slip", "sensor_drift", "slack", "end_stop"}
STEADY |= {"jam", "stick_slip", "creep"}
WANDER = 0.02


def part_of(bench: Bench, effect: str, law: str, rng: np.random.Generator, share: float = WANDER) -> Part:
    """One effect by one law, its shape drawn; most wander a little by themselves, by a share."""
    known = dict(zip(LAWS[effect], OF_EFFECT[effect], strict=True))
    part = known[law](bench, rng)
    factor = wander(rng, bench.time_s, share)
    if effect in STEADY:
        return part

    def act(size: float, now: Array) -> Array:
        return now + (part.act(size, now) - now) * factor

    return replace(part, act=act)


def stream_of(seed: int, effect: str) -> np.random.Generator:
    """The chance from which an effect draws its law and its shape, its own for each effect."""
    return np.random.default_rng([seed, zlib.crc32(effect.encode())])
