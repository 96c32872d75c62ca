"""One recording, whole: specimen, hidden effects at the sizes asked, instruments, and the sealed answer."""

from typing import Any

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.interface import Asked, HiddenEffect, Made, OutOfReach, Truth, as_large
from pipeline.rig.authors.workshop.bench import Bench, Part
from pipeline.rig.authors.workshop.catalogue import LAWS, part_of, stream_of
from pipeline.rig.authors.workshop.chain import reading
from pipeline.rig.authors.workshop.instruments import drawn_instruments, recorded, working_on
from pipeline.rig.authors.workshop.sizing import kappa_of, sized
from pipeline.rig.authors.workshop.specimen import drawn_specimen, went_on

HELD_OUT = 0.3


def drawn_part(bench: Bench, seed: int, effect: str, kappa: float, floor_mm: float) -> tuple[str, Part, float]:
    """A law of an effect, its shape and its size: the first of the shuffled laws that reaches the size.

    Raises OutOfReach where none does.
    """
    rng = stream_of(seed, effect)
    why = OutOfReach("the effect has no law")
    for law in rng.permutation(LAWS[effect]).tolist():
        try:
            part = part_of(bench, effect, law, rng)
            return law, part, sized(bench, part, kappa, floor_mm)
        except OutOfReach as error:
            why = error
    raise why


def again(bench: Bench, seed: int, effect: str, law: str) -> Part:
    """The law that was taken for an effect, its shape drawn as then, for a longer bench."""
    rng = stream_of(seed, effect)
    for tried in rng.permutation(LAWS[effect]).tolist():
        try:
            part = part_of(bench, effect, tried, rng)
        except OutOfReach:  # as then
            continue
        if tried == law:
            return part
    raise ValueError(f"{effect} has no law {law}")


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(np.square(values))))


def plain(parameters: dict[str, Any]) -> dict[str, float]:
    """Parameters as plain numbers; a list's entries are numbered from 1."""
    numbers: dict[str, float] = {}
    for name, value in parameters.items():
        if isinstance(value, list):
            numbers |= {f"{name}_{number}": float(item) for number, item in enumerate(value, 1)}
        else:
            numbers[name] = float(value)
    return numbers


def make(request: Asked) -> Made:
    """The recording that was asked; raises OutOfReach where its effects cannot be shown so large."""
    specimen = drawn_specimen(request.seed, request.protocol)
    bench, instruments = specimen.bench, drawn_instruments(request.seed, specimen)
    clean_mm = reading(bench, [])
    _, noise_mm = recorded(specimen, instruments, clean_mm * specimen.scale)
    floor_mm = _rms(noise_mm)
    parts: list[tuple[Part, float]] = []
    effects: list[HiddenEffect] = []
    for effect, kappa in zip(request.effects, request.kappas, strict=True):
        law, part, size = drawn_part(bench, request.seed, effect, kappa, floor_mm)
        parts.append((part, size))
        alone_mm = reading(bench, [(part, size)]) - clean_mm
        parameters = plain(part.parameters) | {part.size: size}
        reached = kappa_of(bench, part, size, floor_mm)
        rms_mm = _rms(alone_mm - alone_mm[0])
        effects.append({"id": effect, "law": law, "parameters": parameters, "rms_mm": rms_mm, "kappa": reached})
    protocol_s = float(bench.time_s[-1])
    if request.legs:
        specimen = went_on(specimen, request.legs)
        before, bench, instruments = bench, specimen.bench, working_on(instruments, len(specimen.bench.time_s))
        whole_mm = reading(bench, [])
        for at, (entry, (part, size)) in enumerate(zip(effects, parts, strict=True)):
            longer = again(bench, request.seed, str(entry["id"]), str(entry["law"]))
            alone_mm = reading(before, [(part, size)]) - clean_mm
            parts[at] = longer, as_large(size, alone_mm, reading(bench, [(longer, size)]) - whole_mm)
    shown_mm = reading(bench, parts)
    if not np.isfinite(shown_mm).all():
        raise OutOfReach("the effects together drive the string where its geometry ends")
    table, noise_mm = recorded(specimen, instruments, shown_mm * specimen.scale)
    stroke = bench.stroke[instruments.kept]
    late = stroke > stroke.max() - max(1, round(HELD_OUT * stroke.max()))
    truth: Truth = {"effects": effects, "noise_floor_mm": floor_mm, "heldout_noise_mm": _rms(noise_mm[late])}
    if request.legs:
        truth["protocol_s"] = protocol_s
    return Made(specimen.content, table, truth)
