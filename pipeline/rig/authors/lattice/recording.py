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


def make(request: Asked) -> Made:
    """Make the recording that was asked; raises OutOfReach when its session cannot show an effect."""
    return made_with(request, [None] * len(request.effects))


def made_with(request: Asked, names: list[str | None]) -> Made:
    """Make a recording with a given law for each effect, or any of the effect's where the name is None."""
    bench, clock, table = (np.random.default_rng([request.seed, part]) for part in (1, 2, 3))
    session_now = session(bench, request.protocol)
    taken = sampling(clock, session_now)
    chosen = [_drawn(request, i, name) for i, name in enumerate(names)]
    warmth = any(law.name == "ambient_node" for law in chosen)
    silent = recorded(
        np.random.default_rng([request.seed, 3]), session_now, taken, reading_mm(session_now.world, []), warmth
    )
    floor_mm = _rms(silent.noise_mm)
    ruler = Ruler(session_now, taken)
    hidden: list[tuple[Law, Params]] = []
    effects: list[HiddenEffect] = []
    for i, (law, kappa) in enumerate(zip(chosen, request.kappas, strict=True)):
        shape = law.draw(np.random.default_rng([request.seed, 20 + i]), session_now.world)

        def left_mm(strength: float, law: Law = law, shape: Params = shape) -> float:
            return ruler.rms_mm(reading_mm(session_now.world, [(law, {**shape, law.strength: strength})]))

        strength = strength_for(kappa * floor_mm, left_mm, law.limit)
        params = {law.strength: strength, **shape}
        hidden.append((law, params))
        alone_mm = reading_mm(session_now.world, [(law, params)]) - (
            session_now.world.base_mm - session_now.world.base_mm[0]
        )
        rms_mm = _rms(np.interp(taken.time_s, session_now.world.time_s, alone_mm))
        reached = left_mm(strength) / floor_mm
        effects.append({"id": law.effect, "law": law.name, "parameters": params, "rms_mm": rms_mm, "kappa": reached})
    protocol_s = float(session_now.world.time_s[-1])
    if request.legs:
        before, session_now = session_now.world, session_on(session_now, request.legs)
        taken = sampling_on(taken, session_now)
        for i, (law, params) in enumerate(hidden):
            shape = law.draw(np.random.default_rng([request.seed, 20 + i]), session_now.world)
            effect = (law, {**shape, law.strength: params[law.strength]})
            alone_mm, longer_mm = _done_mm(before, (law, params)), _done_mm(session_now.world, effect)
            hidden[i] = (law, {**shape, law.strength: as_large(params[law.strength], alone_mm, longer_mm)})
    made = recorded(table, session_now, taken, reading_mm(session_now.world, hidden), warmth)
    measured = "load_n" in made.table
    content = run_yaml(session_now.specimen, None if measured else session_now.specimen.load_n)
    last = held_out(session_now, taken)
    truth: Truth = {
        "effects": effects,
        "noise_floor_mm": _rms(made.noise_mm),
        "heldout_noise_mm": _rms(made.noise_mm[last]),
    }
    if request.legs:
        truth["protocol_s"] = protocol_s
    return Made(content, made.table, truth)


def _drawn(request: Asked, index: int, name: str | None) -> Law:
    laws = {law.name: law for law in BY_EFFECT[request.effects[index]]}
    drawn = str(np.random.default_rng([request.seed, 10 + index]).choice(list(laws)))
    return laws[name or drawn]


def _done_mm(world: World, effect: tuple[Law, Params]) -> Array:
    return reading_mm(world, [effect]) - reading_mm(world, [])


def _rms(values: Any) -> float:
    return float(np.sqrt(np.mean(np.square(values))))
