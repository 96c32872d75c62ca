"""One recording from one seed: the session, the hidden laws at the sizes asked, the instruments, and the answer."""

from typing import Any

import numpy as np

from pipeline.rig.authors.interface import Asked, HiddenEffect, Made, Truth, as_large
from pipeline.rig.authors.lattice.catalogue import BY_EFFECT
from pipeline.rig.authors.lattice.chain import reading_mm
from pipeline.rig.authors.lattice.instruments import held_out, recorded, sampling, sampling_on
from pipeline.rig.authors.lattice.law import Law, Params
from pipeline.rig.authors.lattice.session import session, session_on
from pipeline.rig.authors.lattice.size import Ruler, strength_for
from pipeline.rig.authors.lattice.specimen import run_yaml
from pipeline.rig.authors.lattice.world import Array, World


def make(asked: Asked) -> Made:
    """Make the recording that was asked; raises OutOfReach when its session cannot show an effect."""
    return made_with(asked, [None] * len(asked.effects))


def made_with(asked: Asked, names: list[str | None]) -> Made:
    """Make a recording with a given law for each effect, or any of the effect's where the name is None."""
    bench, clock, table = (np.random.default_rng([asked.seed, part]) for part in (1, 2, 3))
    one = session(bench, asked.protocol)
    taken = sampling(clock, one)
    chosen = [_drawn(asked, i, name) for i, name in enumerate(names)]
    warmth = any(law.name == "ambient_node" for law in chosen)
    silent = recorded(np.random.default_rng([asked.seed, 3]), one, taken, reading_mm(one.world, []), warmth)
    floor_mm = _rms(silent.noise_mm)
    ruler = Ruler(one, taken)
    hidden: list[tuple[Law, Params]] = []
    effects: list[HiddenEffect] = []
    for i, (law, kappa) in enumerate(zip(chosen, asked.kappas, strict=True)):
        shape = law.draw(np.random.default_rng([asked.seed, 20 + i]), one.world)

        def left_mm(strength: float, law: Law = law, shape: Params = shape) -> float:
            return ruler.rms_mm(reading_mm(one.world, [(law, {**shape, law.strength: strength})]))

        strength = strength_for(kappa * floor_mm, left_mm, law.limit)
        params = {law.strength: strength, **shape}
        hidden.append((law, params))
        alone_mm = reading_mm(one.world, [(law, params)]) - (one.world.base_mm - one.world.base_mm[0])
        rms_mm = _rms(np.interp(taken.time_s, one.world.time_s, alone_mm))
        reached = left_mm(strength) / floor_mm
        effects.append({"id": law.effect, "law": law.name, "parameters": params, "rms_mm": rms_mm, "kappa": reached})
    protocol_s = float(one.world.time_s[-1])
    if asked.legs:
        before, one = one.world, session_on(one, asked.legs)
        taken = sampling_on(taken, one)
        for i, (law, params) in enumerate(hidden):
            shape = law.draw(np.random.default_rng([asked.seed, 20 + i]), one.world)
            effect = (law, {**shape, law.strength: params[law.strength]})
            alone_mm, longer_mm = _done_mm(before, (law, params)), _done_mm(one.world, effect)
            hidden[i] = (law, {**shape, law.strength: as_large(params[law.strength], alone_mm, longer_mm)})
    made = recorded(table, one, taken, reading_mm(one.world, hidden), warmth)
    measured = "load_n" in made.table
    content = run_yaml(one.specimen, None if measured else one.specimen.load_n)
    last = held_out(one, taken)
    truth: Truth = {
        "effects": effects,
        "noise_floor_mm": _rms(made.noise_mm),
        "heldout_noise_mm": _rms(made.noise_mm[last]),
    }
    if asked.legs:
        truth["protocol_s"] = protocol_s
    return Made(content, made.table, truth)


def _drawn(asked: Asked, index: int, name: str | None) -> Law:
    laws = {law.name: law for law in BY_EFFECT[asked.effects[index]]}
    drawn = str(np.random.default_rng([asked.seed, 10 + index]).choice(list(laws)))
    return laws[name or drawn]


def _done_mm(world: World, effect: tuple[Law, Params]) -> Array:
    return reading_mm(world, [effect]) - reading_mm(world, [])


def _rms(values: Any) -> float:
    return float(np.sqrt(np.mean(np.square(values))))
