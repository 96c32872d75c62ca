"""One specimen from one seed: the string, its rig, the motion, and what was written down about them."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from pipeline.ground.kinematics import RAD_PER_TURN, TOLERANCE, Array, Geometry, usual_stiffness
from pipeline.rig.authors.interface import Leg, Protocol, RunContent, StringContent, carried_on, driven_on
from pipeline.rig.authors.workshop.bench import Bench
from pipeline.rig.authors.workshop.motion import cam_sheet, laid_out, least_moving_s

MATERIALS = ("UHMWPE", "nylon", "aramid", "Vectran", "polyester")


@dataclass(frozen=True)
class Specimen:
    """The true bench, what run.yaml says of it, and what the instruments get wrong without any hidden effect."""

    bench: Bench
    content: RunContent
    load_cell: bool
    scale: float
    angle_zero_turns: float


def _off(rng: np.random.Generator, sigma: float) -> float:
    """An error of measuring, normal, cut at 2.2 sigma."""
    return float(np.clip(rng.normal(), -2.2, 2.2) * sigma)


def drawn_geometry(rng: np.random.Generator) -> tuple[Geometry, float]:
    """A string on its rig, and the twist that its strokes go up to, in turns."""
    if rng.random() < 0.2:
        radius, length = rng.uniform(0.6, 1.1), rng.uniform(160.0, 300.0)
        stiffness = usual_stiffness(radius, length) * np.exp(rng.normal(0.0, 0.25))
        top = length * np.sin(rng.uniform(0.35, 0.65)) / radius
        return Geometry("twisted_pair", radius, length, stiffness), float(top / RAD_PER_TURN)
    radius, zone, apart = rng.uniform(0.28, 0.75), rng.uniform(90.0, 230.0), rng.uniform(4.0, 14.0)
    length = zone + rng.uniform(100.0, 260.0)
    stiffness = usual_stiffness(radius, length) * np.exp(rng.normal(0.0, 0.25))
    top = (zone * np.tan(rng.uniform(0.38, 0.62)) - apart) / radius
    return Geometry("separator", radius, length, stiffness, zone, apart), float(top / RAD_PER_TURN)


def room_temperature(rng: np.random.Generator, time_s: Array, protocol: Protocol) -> Array:
    """What the room's thermometer would show, in °C: a slow swing, and on a rich protocol a spell of heating."""
    total = time_s[-1]
    swing = rng.uniform(0.3, 1.5) * np.sin(RAD_PER_TURN * (time_s / (total * rng.uniform(0.7, 2.0)) + rng.random()))
    spell = rng.uniform(4.0, 12.0) if protocol == "rich" else rng.uniform(0.0, 4.0)
    begin, end, slow = rng.uniform(0.15, 0.35) * total, rng.uniform(0.5, 0.7) * total, rng.uniform(20.0, 60.0)
    heated = 1.0 - np.exp(-np.maximum(time_s - begin, 0.0) / slow)
    cooled = 1.0 - np.exp(-np.maximum(time_s - end, 0.0) / (1.5 * slow))
    return np.asarray(rng.uniform(18.0, 25.0) + swing + spell * (heated - cooled))


def written_down(rng: np.random.Generator, true: Geometry, load_n: float | None) -> RunContent:
    """The content of run.yaml, but its `run`: dimensions as somebody measured them."""
    string: StringContent = {
        "material": str(rng.choice(MATERIALS)),
        "radius_mm": round(float(true.radius_mm * (1.0 + _off(rng, TOLERANCE["radius"]))), 4),
        "length_mm": round(float(true.length_mm + _off(rng, TOLERANCE["length_mm"])), 1),
    }
    stiffness, known = round(float(true.stiffness_n_per_mm * (1.0 + _off(rng, 0.03))), 2), rng.random() < 0.6
    if known:
        string["stiffness_n_per_mm"] = stiffness
    rig: dict[str, float] = {}
    if true.actuator == "separator":
        rig["torsion_zone_mm"] = round(float(true.torsion_zone_mm + _off(rng, TOLERANCE["torsion_zone_mm"])), 1)
        rig["separator_mm"] = round(float(true.separator_mm + _off(rng, TOLERANCE["separator_mm"])), 2)
    if load_n is not None:
        rig["load_n"] = round(load_n, 2)
    return {"actuator": true.actuator, "string": string, "rig": rig}


def drawn_specimen(seed: int, protocol: Protocol) -> Specimen:
    """The specimen of a seed on a protocol, whatever will be hidden in it."""
    rng = np.random.default_rng([seed, 7001, len(protocol)])
    geometry, top_turns = drawn_geometry(rng)
    low_turns = float(rng.choice([0.0, rng.uniform(0.1, 1.0)]))
    strokes = cam_sheet(rng, protocol, float(np.exp(rng.uniform(np.log(8.0), np.log(28.0)))))
    pauses_s = sum(stroke.dwell_s + stroke.rest_s for stroke in strokes)
    total_s = float(np.clip(rng.uniform(1.6, 4.0) * pauses_s, rng.uniform(190.0, 400.0), rng.uniform(450.0, 585.0)))
    # the motor's top speed, for which a long twist must be cut
    shortest_s = least_moving_s(strokes, top_turns, rng.uniform(2.5, 7.0))
    total_s = float(np.clip(shortest_s + pauses_s, total_s, 585.0))
    top_turns *= min(1.0, (total_s - pauses_s) / shortest_s)
    rate_hz = float(min(rng.choice([25.0, 40.0, 50.0, 80.0, 100.0]), np.floor(24500.0 / total_s)))
    course = laid_out(rng, strokes, rate_hz, total_s - pauses_s)
    turns = low_turns + (top_turns - low_turns) * course.height
    load_n, sprung = course.load_n, protocol != "poor" and rng.random() < 0.15
    share = rng.uniform(0.15, 0.5)
    if sprung:  # the weight hangs beside a spring that the string draws out
        contraction = geometry.contraction_mm(turns, load_n)
        load_n = load_n * (1.0 + share * (contraction - contraction.min()) / np.ptp(contraction))
    load_cell = bool(np.ptp(load_n) > 1e-6 or rng.random() < 0.3)
    temperature = room_temperature(rng, course.time_s, protocol)
    thermometer = bool(rng.random() < (0.75 if protocol == "rich" else 0.4))
    bench = Bench(course.time_s, turns, load_n, temperature, course.stroke, geometry, thermometer)
    content = written_down(rng, geometry, None if load_cell else float(load_n[0]))
    return Specimen(bench, content, load_cell, 1.0 + _off(rng, 0.003), _off(rng, 0.02))


def went_on(specimen: Specimen, legs: Sequence[Leg]) -> Specimen:
    """A specimen whose motion goes on by legs."""
    bench = specimen.bench
    turns, load_n, begun = driven_on(legs, bench.turns, bench.load_n, bench.tick_s)
    longer = replace(
        bench,
        time_s=np.append(bench.time_s, bench.time_s[-1] + bench.tick_s * np.arange(1, len(turns) + 1)),
        turns=np.append(bench.turns, turns),
        load_n=np.append(bench.load_n, load_n),
        temperature_c=carried_on(bench.temperature_c, len(turns)),
        stroke=np.append(bench.stroke, bench.stroke[-1] + begun),
    )
    load_cell = specimen.load_cell or bool(np.ptp(longer.load_n) > 1e-6)
    rig = {name: value for name, value in specimen.content["rig"].items() if name != "load_n" or not load_cell}
    return replace(specimen, bench=longer, content={**specimen.content, "rig": rig}, load_cell=load_cell)
