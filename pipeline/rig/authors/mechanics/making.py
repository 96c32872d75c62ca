"""One recording from what is asked: the specimen, the motion, the laws at the sizes asked, and the sealed answer."""

import zlib
from dataclasses import replace
from typing import Any

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.interface import Asked, HiddenEffect, Made, Truth, as_large, driven_on
from pipeline.rig.authors.mechanics.catalogue import WRITERS
from pipeline.rig.authors.mechanics.motion import driven, planned
from pipeline.rig.authors.mechanics.reading import noise, noise_on, recorded, sampled
from pipeline.rig.authors.mechanics.scene import STEP_S, Law, Scene, displacement_mm
from pipeline.rig.authors.mechanics.sizing import Calibration, strength_for
from pipeline.rig.authors.mechanics.specimen import drawn, measured

HELD_OUT = 0.3  # of the strokes, at the end
WANDER, WANDER_S = 0.02, 25.0  # how much an effect's strength wanders, and in what time


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(np.square(values))))


def _wander(scene: Scene, draw: np.random.Generator) -> Array:
    """A factor near 1 that wanders slowly, one value a step: no effect repeats quite alike."""
    knots = np.arange(0.0, scene.time_s[-1] + 2.0 * WANDER_S, WANDER_S)
    return 1.0 + WANDER * np.interp(scene.time_s, knots, draw.normal(size=len(knots)))


def _wandering(law: Law, factor: Array) -> Law:
    """A law whose strength is multiplied by a factor, if it is one that may wander."""
    act = law.act
    return replace(law, act=lambda size, given: act(size, given) * factor) if law.wanders else law


def _held_out_from(scene: Scene, strokes: int) -> float:
    """Time in s at which the last strokes, which a diagnosis is tested on, begin."""
    away = scene.turns > scene.turns.min() + 1e-9
    begins = np.flatnonzero(np.diff(away.astype(int)) == 1) * (scene.time_s[1] - scene.time_s[0])
    held = max(1, round(HELD_OUT * strokes))
    return float(begins[-held])


def _law(scene: Scene, seed: int, effect: str) -> tuple[str, Law]:
    """The law of an effect that a seed draws for a scene, and its name."""
    own = np.random.default_rng([seed, 5, zlib.crc32(effect.encode())])
    writer = WRITERS[effect][int(own.integers(len(WRITERS[effect])))]
    return writer.__name__, _wandering(writer(scene, own), _wander(scene, own))


def make(request: Asked) -> Made:
    """The recording that is asked, its run.yaml and its answer; raises OutOfReach, or NotInstalled without MuJoCo."""
    draw = np.random.default_rng([request.seed, 5])
    material, geometry, top, usual_load_n = drawn(draw)
    plan = planned(request.protocol, draw)
    low = float(draw.uniform(0.0, 1.0))
    turns, load_n = driven(plan, low, top, usual_load_n, draw)
    scene = Scene(geometry, turns, load_n)
    errors = noise(len(turns), draw)
    changes = bool(np.ptp(load_n) > 0.0)
    with_load = changes or draw.random() < 0.3
    with_temperature = draw.random() < 0.4
    content = measured(material, geometry, None if with_load else float(load_n[0]), draw)
    written = draw.integers(2**62)

    def table(shown_mm: Array) -> tuple[Any, Array]:
        rest = np.random.default_rng(written)
        return recorded(scene, shown_mm, errors, with_load, with_temperature, rest)

    usual_mm = displacement_mm(scene, [])
    floor_mm = _rms(table(usual_mm)[1])
    calibration = Calibration(geometry, *(sampled(signal, errors) for signal in (turns, load_n)))
    acting: list[tuple[Law, float]] = []
    effects: list[HiddenEffect] = []
    for effect, kappa in zip(request.effects, request.kappas, strict=True):
        name, law = _law(scene, request.seed, effect)

        def alone(strength: float, law: Law = law) -> Array:
            change = displacement_mm(scene, [(law, strength)]) - usual_mm
            return sampled(change - change[0], errors)

        def size(strength: float) -> float:
            return calibration.left_mm(alone(strength)) / floor_mm

        strength, reached = strength_for(size, kappa, law.bounds)
        acting.append((law, strength))
        parameters = {law.strength: strength, **law.parameters}
        effects.append(
            {
                "id": effect,
                "law": name,
                "parameters": parameters,
                "rms_mm": _rms(alone(strength)),
                "kappa": reached,
            }
        )
    protocol_s, held_s = float(scene.time_s[-1]), _held_out_from(scene, len(plan.heights))
    if request.legs:
        more_turns, more_n, _ = driven_on(request.legs, turns, load_n, STEP_S)
        before, scene = scene, Scene(geometry, np.append(turns, more_turns), np.append(load_n, more_n))
        errors = noise_on(errors, len(scene.turns))
        with_load = with_load or bool(np.ptp(scene.load_n) > 0.0)
        rig = {key: value for key, value in content["rig"].items() if key != "load_n" or not with_load}
        content = {**content, "rig": rig}
        whole_mm = displacement_mm(scene, [])
        for at, (effect, (law, strength)) in enumerate(zip(request.effects, acting, strict=True)):
            longer = _law(scene, request.seed, effect)[1]
            alone_mm = displacement_mm(before, [(law, strength)]) - usual_mm
            longer_mm = displacement_mm(scene, [(longer, strength)]) - whole_mm
            acting[at] = longer, as_large(strength, alone_mm, longer_mm)
    recording, noise_mm = table(displacement_mm(scene, acting))
    held = recording["time_s"].to_numpy() >= held_s
    truth: Truth = {"effects": effects, "noise_floor_mm": _rms(noise_mm), "heldout_noise_mm": _rms(noise_mm[held])}
    if request.legs:
        truth["protocol_s"] = protocol_s
    return Made(content, recording, truth)
