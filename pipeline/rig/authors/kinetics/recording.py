"""One recording: the specimen of a seed on a protocol, with the effects asked at the sizes asked."""

import zlib
from collections.abc import Mapping

import numpy as np
import pandas as pd

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.interface import PROTOCOLS, Asked, HiddenEffect, Made, OutOfReach, RunContent, Truth
from pipeline.rig.authors.kinetics.bench import STEP_S, Bench
from pipeline.rig.authors.kinetics.logger import Logger, logger, logging_on, with_outliers
from pipeline.rig.authors.kinetics.motion import run, run_on
from pipeline.rig.authors.kinetics.reading import Hidden, displacement
from pipeline.rig.authors.kinetics.register import BY_EFFECT
from pipeline.rig.authors.kinetics.sizing import Recalibration, sized
from pipeline.rig.authors.kinetics.specimen import Specimen, specimen

HELD_OUT = 0.3
SPECIMEN, MOTION, LOGGER, OUTLIERS, EFFECT = range(5)


def _chance(request: Asked, what: int, more: int = 0) -> np.random.Generator:
    """A stream of chance for one part of a recording, so that no part depends on another."""
    protocol = 0 if what == SPECIMEN else PROTOCOLS.index(request.protocol)
    return np.random.default_rng([0x6B696E, request.seed, what, protocol, more])


def _drawn(request: Asked, effect: str, chosen: Mapping[str, str], has_air: bool) -> Hidden:
    """An effect with its law, drawn unless chosen, and its parameters; a law of the air needs its thermometer."""
    chance = _chance(request, EFFECT, zlib.crc32(effect.encode()))
    laws = [law for law in BY_EFFECT[effect] if has_air or not law.needs_air]
    law = laws[int(chance.integers(len(laws)))]
    if effect in chosen:
        named = [law for law in laws if law.name == chosen[effect]]
        if not named:
            raise OutOfReach(f"this rig has no channel for {chosen[effect]}")
        law = named[0]
    return Hidden(effect, law, law.drawn(chance))


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(np.square(values))))


def _noise(log: Logger, stroke: Array, plain_mm: Array) -> tuple[float, float]:
    """Rms of the noise without outliers, over the run and over its held-out strokes, in mm."""
    noise_mm = log.read(plain_mm) - plain_mm - log.zero_mm
    noise_mm = noise_mm - noise_mm.mean()
    count = int(stroke.max())
    late = stroke > count - max(1, int(np.ceil(HELD_OUT * count)))
    return _rms(noise_mm), _rms(noise_mm[late])


def _content(string: Specimen, log: Logger) -> RunContent:
    """What run.yaml says of the string and the rig."""
    rig = dict(string.rig)
    if not log.has_load:
        rig["load_n"] = round(string.load_n, 1)
    return {"actuator": string.geometry.actuator, "string": {**string.string}, "rig": rig}


def _table(chance: np.random.Generator, string: Specimen, bench: Bench, log: Logger, reading_mm: Array) -> pd.DataFrame:
    """The recording's table."""
    turns = log.taken(bench.turns) + string.angle_zero_turns
    columns = {
        "time_s": np.round(log.at * STEP_S, 5),
        "motor_turns": np.round(turns * log.counts_per_turn) / log.counts_per_turn,
        "displacement_mm": np.round(reading_mm, 4),
    }
    if log.has_load:
        noise_n = 0.003 * string.load_n * chance.normal(size=len(turns))
        columns["load_n"] = np.round(log.taken(bench.load_n) + noise_n, 2)
    if log.has_air:
        columns["temperature_c"] = np.round(log.taken(bench.air_c) + 0.05 * chance.normal(size=len(turns)), 2)
    return pd.DataFrame(columns)


def recorded(request: Asked, chosen: Mapping[str, str]) -> Made:
    """The recording asked, with laws chosen by effect or else drawn; raises OutOfReach."""
    string = specimen(_chance(request, SPECIMEN))
    bench = run(_chance(request, MOTION), string, request.protocol)
    log = logger(_chance(request, LOGGER), bench)
    stroke = bench.stroke[log.rows]
    plain_mm = log.taken(displacement(bench, [])) * string.scale
    floor_mm, heldout_mm = _noise(log, stroke, plain_mm)
    recalibration = Recalibration(bench, log.rows)
    effects: list[Hidden] = []
    entries: list[HiddenEffect] = []
    for effect, kappa in zip(request.effects, request.kappas, strict=True):
        hidden, left_mm = sized(bench, _drawn(request, effect, chosen, log.has_air), kappa * floor_mm, recalibration)
        alone_mm = log.taken(displacement(bench, [hidden])) * string.scale - plain_mm
        parameters = {**hidden.parameters, "size": hidden.size}
        effects.append(hidden)
        entries.append(
            {
                "id": effect,
                "law": hidden.law.name,
                "parameters": {name: float(value) for name, value in parameters.items()},
                "rms_mm": _rms(alone_mm - alone_mm[0]),
                "kappa": left_mm / floor_mm,
            }
        )
    truth: Truth = {"effects": entries, "noise_floor_mm": floor_mm, "heldout_noise_mm": heldout_mm}
    if request.legs:
        truth["protocol_s"] = float(bench.time_s[-1])
        bench = run_on(bench, request.legs)
        log = logging_on(log, bench)
    chance = _chance(request, OUTLIERS)
    reading_mm = with_outliers(chance, log.read(log.taken(displacement(bench, effects)) * string.scale), floor_mm)
    return Made(_content(string, log), _table(chance, string, bench, log, reading_mm), truth)
