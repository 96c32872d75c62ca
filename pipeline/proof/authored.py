"""A concealed case by an author: the plan's open choices are drawn, and the answer has the form of the rig's own."""

from typing import cast

import numpy as np

from ..ground.outside_library import is_outside
from ..rig.authors import authors
from ..rig.authors.interface import Asked, Made, OutOfReach, Protocol
from ..run.run_yaml import RunYaml
from .plan import Planned
from .sealed import Answer, EffectJson

__all__ = ["OutOfReach", "answer", "asked_of", "described", "made"]

HIDES = {"none": 0, "single": 1, "pair": 2, "open": 1}  # effects in a case, by stratum


def asked_of(planned: Planned, known_effects: list[str]) -> Asked:
    """The choices of a plan for an author who knows these effects; effects that the plan does not name are drawn.

    Effects of docs/physics.md serve all strata but `open`, for which there are the author's own under `x_`.
    """
    count = HIDES[planned.stratum]
    pool = sorted(name for name in known_effects if is_outside(name) == (planned.stratum == "open"))
    drawn = np.random.default_rng([planned.seed, count]).permutation(np.array(pool, object)).tolist()
    names = [*planned.effects, *[name for name in drawn if name not in planned.effects]][:count]
    kappas = [*planned.kappas, *[planned.kappas[-1] if planned.kappas else 1.0] * count][:count]
    return Asked(planned.seed, tuple(names), tuple(kappas), cast(Protocol, planned.protocol))


def made(planned: Planned) -> Made:
    """The author's recording of a planned case; raises OutOfReach when its rig or protocol cannot show the effect."""
    author = authors()[planned.author]
    strange = sorted(set(planned.effects) - set(author.laws))
    if strange:
        raise OutOfReach(f"{planned.author} knows no law of {', '.join(strange)}")
    return author.make(asked_of(planned, list(author.laws)))


def described(run: str, authored_case: Made) -> RunYaml:
    """What `run.yaml` says of an author's recording that is called `run`."""
    return {"run": run, **authored_case.content, "string": {**authored_case.content["string"]}}


def answer(planned: Planned, authored_case: Made) -> Answer:
    """The sealed answer, with the keys that the score reads; an author does not tell dimensions and places."""
    effects: list[EffectJson] = [{**effect, "raw_mm": effect["rms_mm"]} for effect in authored_case.truth["effects"]]
    raw_mm = float(np.sqrt(sum(effect["rms_mm"] ** 2 for effect in authored_case.truth["effects"])))
    return {
        "protocol": planned.protocol,
        "effects": effects,
        "together": {"raw_mm": raw_mm, "hidden_share": None},
        "noise_floor_mm": authored_case.truth["noise_floor_mm"],
        "heldout_noise_mm": authored_case.truth["heldout_noise_mm"],
        "location": None,
        "dimensions": {},
    }
