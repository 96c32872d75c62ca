"""The parts of a diagnosis.json that the pages read; keys that end in the reading's unit are read by that key."""

from typing import TypedDict


class Span(TypedDict, total=False):
    """A number with its 90 % interval, in the unit of what holds it; None where it is not known."""

    value: float | None
    low: float | None
    high: float | None


class NamedEffect(TypedDict, total=False):
    """An effect that a verdict names, with its parameters by name; made key: `rms_…`, what it does to the reading."""

    id: str
    parameters: dict[str, Span]


class Place(TypedDict, total=False):
    """Where a mismatch lies; made key: the channel that moves, its lowest and highest motion."""

    strokes: list[int]  # the first and the last
    phase: str
    share: float  # of the signal's energy


class Mismatch(TypedDict, total=False):
    """Where simulator and recording differ, and what that follows; made key: `rms_…`, how much."""

    location: Place
    driver: str


class Relative(TypedDict):
    """What each simulator leaves, over the reading itself, after a filter; without a unit."""

    nominal: float
    calibrated: float
    explained: float
    filter: str


class Fit(TypedDict, total=False):
    """How well it fits; made keys: `noise_floor_…` and, by effect, `detectable_…`."""

    heldout: dict[str, float] | None  # made keys, by simulator: `nominal_…`
    worse_than_nominal: list[str]
    relative_residual: Relative


class Evidence(TypedDict, total=False):
    """The ids named without the held-out strokes, and the closest ids there."""

    chosen_without_them: list[str] | None
    closest_without_them: list[str]


class Content(TypedDict, total=False):
    """A verdict: its word, its named effects, the tied explanations, their fit, and the run to make next."""

    verdict: str
    mechanisms: list[NamedEffect]
    alternatives: list[list[str]]
    mismatch: Mismatch | None
    fit: Fit
    parameters: dict[str, Span]
    evidence: Evidence
    next_experiment: str | None
