"""Parts of a diagnosis that say what an effect is, how large, and where: effects, dimensions and places."""

from typing import NotRequired, TypedDict

from ...run.description import Included
from .made_keys import Interval


class Location(TypedDict):
    """Where most of a signal lies; the channel that moves is a made key: the lowest and highest motion, in its unit."""

    strokes: list[int]  # the first and the last
    phase: str  # all, winding, hold, unwinding or rest
    share: float  # of the signal's energy that lies there


class Quantity(Interval):
    """A number of a mechanism with its 90 % interval, all three in `unit`."""

    unit: str


class Dimension(TypedDict, total=False):
    """A dimension of the rig, or a zero, in the unit that its name ends in; a simulator's has a `value` alone."""

    nominal: float  # as measured
    value: float  # as calibrated
    low: float
    high: float
    from_first: Interval  # of a later run's zero: by how much it exceeds the first run's
    at_bound: str  # `upper` or `lower`, where calibration moved it as far as it may


class WithParameters(TypedDict):
    """An entry that has the parameters of an effect."""

    parameters: dict[str, Quantity]


class MechanismEntry(WithParameters):
    """An effect at work; made key: `rms_…`, an interval, what it does to the reading, in its unit."""

    id: str
    confidence: NotRequired[float]  # a probability
    location: NotRequired[Location]
    sentence: NotRequired[str]


class StandIn(TypedDict):
    """A stand-in of a simulator, beside the named effects; made keys: `rms_…` with a `value`, and `span_…`."""

    id: str
    parameters: dict[str, Quantity]
    location: Location
    sentence: NotRequired[str]


class AdoptedEffect(TypedDict):
    """An adopted effect in a recording; made keys: `rms_…` and, of a slow one, `top_…`, in the reading's unit."""

    id: str
    sentence: str


class OfYourOwn(TypedDict):
    """What mechanisms of a user's own explain; the verdict names none of them."""

    mechanisms: list[MechanismEntry]
    simulation: NotRequired[list[Included]]


class Loop(TypedDict):
    """How far winding and unwinding part; made keys: `width_…` in the reading's unit, and the channel: where."""

    by_load: NotRequired[list[list[float]]]  # loads in their unit, each with the width under it
