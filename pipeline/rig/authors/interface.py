"""What is asked of an author of concealed physics, and what the author gives back."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, NotRequired, TypedDict

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy.ndimage import uniform_filter1d

Array = NDArray[np.float64]
Protocol = Literal["rich", "usual", "poor"]
PROTOCOLS: tuple[Protocol, ...] = ("rich", "usual", "poor")


class OutOfReach(Exception):
    """The motion and the rig that the seed drew cannot show an effect of the size that was asked."""


@dataclass(frozen=True)
class Leg:
    """Motion after the protocol's: in so many seconds evenly to a twist in turns, under a load in N."""

    seconds: float
    turns: float
    load_n: float


@dataclass(frozen=True)
class Asked:
    """One recording to make: from which seed, with which effects, how large, on which protocol, with what after it.

    `kappas` has one size for each effect: its rms in noise floors after bounded recalibration, over the protocol. The
    string lives on through `legs`. A law that is written in shares of the session's greatest or mean load, torque or
    travel takes them from the whole session; its size over the protocol is kept, its shape may change a little.
    """

    seed: int
    effects: tuple[str, ...]
    kappas: tuple[float, ...]
    protocol: Protocol
    legs: tuple[Leg, ...] = ()

    def __post_init__(self) -> None:
        if len(self.effects) != len(self.kappas):
            raise ValueError(f"{len(self.effects)} effects and {len(self.kappas)} sizes; give one size for each effect")
        if len(set(self.effects)) != len(self.effects):
            raise ValueError("an effect is asked twice; ask for each effect once")
        if not all(0.0 < kappa < float("inf") for kappa in self.kappas):
            raise ValueError("a size is not above 0; give sizes in noise floors")
        if self.protocol not in PROTOCOLS:
            raise ValueError(f"the protocol is {self.protocol!r}; use one of {', '.join(PROTOCOLS)}")


class StringContent(TypedDict):
    """The string as somebody measured it, in mm and N/mm."""

    material: str
    radius_mm: float
    length_mm: float
    stiffness_n_per_mm: NotRequired[float]


class RunContent(TypedDict):
    """The content of a run.yaml without `run`."""

    actuator: str
    string: StringContent
    rig: dict[str, float]
    tolerance: NotRequired[dict[str, float]]


class HiddenEffect(TypedDict):
    """An effect that was hidden: `rms_mm` of it on the reading, and its size `kappa` that was reached."""

    id: str
    law: str
    parameters: Mapping[str, object]  # as its law names them
    rms_mm: float
    kappa: float


class Truth(TypedDict):
    """The answer that stays sealed: an entry for each effect asked, in that order, and the noise in mm.

    Where legs were asked, `protocol_s` is the time in s at which they begin.
    """

    effects: list[HiddenEffect]
    noise_floor_mm: float
    heldout_noise_mm: float
    protocol_s: NotRequired[float]


@dataclass(frozen=True)
class Made:
    """One recording: what its run.yaml says, its table, and the answer."""

    content: RunContent
    table: pd.DataFrame
    truth: Truth


def driven_on(legs: Sequence[Leg], turns: Array, load_n: Array, step_s: float) -> tuple[Array, Array, Array]:
    """Twist in turns, load in N and strokes begun, a value a step of the legs, after a motion that ends like this.

    Motor and weights need a moment for each change: a tenth of a second and a quarter of one.
    """
    at, way, hangs, begun = float(turns[-1]), [], [], []
    for leg in legs:
        steps = max(1, round(leg.seconds / step_s))
        way.append(np.linspace(at, leg.turns, steps + 1)[1:])
        hangs.append(np.full(steps, leg.load_n))
        begun.append(np.zeros(steps))
        begun[-1][0] = leg.turns > at
        at = leg.turns

    def eased(values: list[Array], before: float, seconds: float) -> Array:
        width = max(1, round(seconds / step_s))
        return np.asarray(uniform_filter1d(np.concatenate([np.full(width, before), *values]), width, mode="nearest"))[
            width:
        ]

    return eased(way, turns[-1], 0.1), eased(hangs, load_n[-1], 0.25), np.cumsum(np.concatenate(begun))


def carried_on(values: Array, count: int) -> Array:
    """Values of a wandering quantity or of noise with `count` more, which run back through them."""
    return np.asarray(np.pad(values, (0, count), mode="reflect"))


def as_large(strength: float, alone_mm: Array, longer_mm: Array) -> float:
    """Strength with which an effect is as large over the protocol as it was there before legs came after it.

    `alone_mm` and `longer_mm` are what the effect does to the reading without legs and with them, at one strength.
    """
    first = longer_mm[: len(alone_mm)] - longer_mm[0]
    size, now = (float(np.sqrt(np.mean(np.square(values)))) for values in (alone_mm - alone_mm[0], first))
    return strength * size / now if now > 0.0 else strength
