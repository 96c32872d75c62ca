"""The protocol: how the motor winds and unwinds, how the load changes, how warm the air is."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.signal.windows import hann

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.interface import Leg, Protocol, carried_on, driven_on
from pipeline.rig.authors.kinetics.bench import STEP_S, Bench
from pipeline.rig.authors.kinetics.populations import wandering
from pipeline.rig.authors.kinetics.specimen import Specimen

SHORTEST_S, LONGEST_S = 185.0, 580.0


def _plan(chance: np.random.Generator, protocol: Protocol) -> dict[str, Array]:
    """One value a stroke: height and load as shares, speed relative, dwell at the top, rest after it in seconds."""
    least, most = {"rich": (9, 16), "usual": (9, 12), "poor": (6, 10)}[protocol]
    count = int(chance.integers(least, most + 1))
    kinds = {"rich": 3, "usual": int(chance.integers(1, 3)), "poor": 1}[protocol]
    speeds = {"rich": 3, "usual": int(chance.integers(1, 3)), "poor": 1}[protocol]
    pace = np.array([1.0, chance.uniform(1.7, 2.3), chance.uniform(3.0, 4.5)])
    loads = np.array([1.0, chance.uniform(1.6, 2.2), chance.uniform(0.45, 0.7)])
    plan = {
        "height": np.ones(count),
        "load": loads[np.repeat(chance.permutation(kinds), 2)[np.arange(count) % (2 * kinds)]],
        "pace": pace[np.append(chance.permutation(speeds), chance.integers(0, speeds, count))[:count]],
        "dwell_s": np.full(count, 0.3),
        "rest_s": np.full(count, 0.3),
    }
    if protocol == "usual":
        plan["dwell_s"], plan["rest_s"] = chance.uniform(0.5, 4.0, count), chance.uniform(2.0, 8.0, count)
    if protocol == "rich":
        plan["height"][1::3] = chance.uniform(0.55, 0.8, len(plan["height"][1::3]))
        plan["dwell_s"], plan["rest_s"] = chance.uniform(1.0, 8.0, count), chance.uniform(2.0, 8.0, count)
        for name, low, high in (("dwell_s", 20.0, 40.0), ("rest_s", 35.0, 60.0)):
            plan[name][chance.choice(count - 2, 2, replace=False)] = chance.uniform(low, high, 2)
    return plan


def _legs(plan: dict[str, Array], start_s: float, speed: float, bottom: float, top: float) -> tuple[Array, Array]:
    """Corners of the motion: time and twist, five a stroke and two before the first."""
    times, places = [0.0, start_s], [bottom, bottom]
    for k, height in enumerate(plan["height"]):
        leg_s = height * (top - bottom) / (speed * plan["pace"][k])
        times += list(times[-1] + np.cumsum([leg_s, plan["dwell_s"][k], leg_s, plan["rest_s"][k]]))
        places += [bottom + height * (top - bottom)] * 2 + [bottom] * 2
    return np.array(times), np.array(places)


def _speed(plan: dict[str, Array], start_s: float, way: float, wanted_s: float) -> float:
    """Slowest speed in turns a second with which the protocol takes about as long as wanted."""
    still = start_s + float(np.sum(plan["dwell_s"] + plan["rest_s"]))
    moving = float(np.sum(2.0 * way * plan["height"] / plan["pace"]))
    return moving / max(wanted_s - still, 60.0, SHORTEST_S - still)


def run(chance: np.random.Generator, string: Specimen, protocol: Protocol) -> Bench:
    """Draw the motion of a run, and put it on the bench's clock."""
    plan = _plan(chance, protocol)
    start_s = float(chance.uniform(2.0, 6.0))
    bottom = float(chance.uniform(0.0, 0.02) * string.top_turns)
    pauses_s = start_s + float(np.sum(plan["dwell_s"] + plan["rest_s"]))
    wanted_s = float(np.clip(pauses_s + chance.uniform(110.0, 260.0), SHORTEST_S, LONGEST_S))
    speed = _speed(plan, start_s, string.top_turns - bottom, wanted_s)
    times, places = _legs(plan, start_s, speed, bottom, string.top_turns)
    clock = np.arange(0.0, times[-1] + 0.5, STEP_S)
    window = hann(2 * int(chance.uniform(0.1, 0.25) / STEP_S) + 1)
    turns = np.interp(clock, times, places)
    edge = len(window) // 2
    turns = np.convolve(np.pad(turns, edge, mode="edge"), window / window.sum(), mode="valid")
    starts = times[1::4][: len(plan["height"])]
    stroke = np.searchsorted(starts, clock, side="right").astype(np.float64)
    # a load is changed in the last second before a stroke, and in two thirds of that rest where it is short
    change_s = np.minimum(1.0, 0.6 * np.append(start_s, plan["rest_s"])[:-1])
    corners = np.sort(np.concatenate([starts - change_s, starts]))
    levels = np.repeat(plan["load"], 2)
    levels = np.append(levels[:1], levels)[: len(corners)]
    load_n = string.load_n * np.interp(clock, corners, levels)
    load_n = load_n * (1.0 + 0.001 * wandering(chance, len(clock), 0.5))
    slow = chance.normal(0.0, 3.0) * clock / clock[-1] + chance.uniform(0.5, 2.0) * wandering(chance, len(clock), 90.0)
    heater = chance.uniform(0.5, 2.5) * np.sin(2.0 * np.pi * (clock / chance.uniform(100.0, 300.0) + chance.uniform()))
    air_c = chance.uniform(18.0, 27.0) + slow + heater
    swings = len(np.unique(plan["load"])) > 1
    return Bench(string.geometry, turns, load_n, air_c, stroke, swings)


def run_on(bench: Bench, legs: Sequence[Leg]) -> Bench:
    """A bench whose motion goes on by legs."""
    turns, load_n, begun = driven_on(legs, bench.turns, bench.load_n, STEP_S)
    return replace(
        bench,
        turns=np.append(bench.turns, turns),
        load_n=np.append(bench.load_n, load_n),
        air_c=carried_on(bench.air_c, len(turns)),
        stroke=np.append(bench.stroke, bench.stroke[-1] + begun),
        load_swings=bench.load_swings or len({leg.load_n for leg in legs}) > 1,
    )
