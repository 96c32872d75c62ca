"""One session at the bench: specimen, motion, room and what real effects wander by, on the fine clock."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from pipeline.rig.authors.interface import Leg, carried_on, driven_on
from pipeline.rig.authors.lattice.kernels import wandering
from pipeline.rig.authors.lattice.motion import carried_out, plan
from pipeline.rig.authors.lattice.specimen import Specimen, specimen
from pipeline.rig.authors.lattice.world import World

MOST_ROWS = 24_500


@dataclass(frozen=True)
class Session:
    """The world of a recording, the string in it, and the rate at which it is recorded."""

    specimen: Specimen
    world: World
    rate_hz: float
    two_loads: bool


def session(rng: np.random.Generator, protocol: str) -> Session:
    """Draw a session of a protocol."""
    drawn = specimen(rng)
    strokes = plan(rng, protocol, drawn.top_turns, drawn.load_n)
    rate_hz = float(rng.choice([25.0, 40.0, 50.0, 64.0, 80.0, 100.0]))
    about_s = sum(2.0 * stroke.height_turns / stroke.rate + stroke.hold_s + stroke.rest_s for stroke in strokes)
    while rate_hz * (about_s + 75.0) > MOST_ROWS:
        rate_hz -= 5.0
    substeps = int(np.ceil(200.0 / rate_hz)) if rate_hz < 67.0 else 3
    moved = carried_out(rng, strokes, 1.0 / (rate_hz * substeps))
    count = len(moved.turns)
    time_s = np.arange(count, dtype=float) * moved.step_s
    swing = rng.uniform(0.2, 2.5) * (1.0 - np.cos(2.0 * np.pi * time_s / rng.uniform(250.0, 900.0)))
    ambient = swing * rng.choice([-1.0, 1.0]) + 0.15 * wandering(rng, count, moved.step_s, 60.0)
    world = World(
        drawn.true,
        moved.step_s,
        time_s,
        moved.turns,
        moved.load_n,
        ambient - ambient[0],
        1.0 + 0.03 * wandering(rng, count, moved.step_s, 40.0),
        moved.stroke,
    )
    return Session(drawn, world, rate_hz, bool(np.ptp(moved.load_n) > 0.0))


def session_on(before: Session, legs: Sequence[Leg]) -> Session:
    """A session that goes on by legs."""
    world = before.world
    turns, load_n, begun = driven_on(legs, world.turns, world.load_n, world.step_s)
    count = len(turns)
    longer = replace(
        world,
        time_s=np.arange(len(world.turns) + count, dtype=float) * world.step_s,
        turns=np.append(world.turns, turns),
        load_n=np.append(world.load_n, load_n),
        ambient_k=carried_on(world.ambient_k, count),
        wander=carried_on(world.wander, count),
        stroke=np.append(world.stroke, world.stroke[-1] + begun.astype(np.int64)),
    )
    return replace(before, world=longer, two_loads=bool(np.ptp(longer.load_n) > 0.0))
