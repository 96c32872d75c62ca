"""The facts that the words of a verdict rest on: `evidence` of a diagnosis."""

from typing import TypedDict

from .effects_named import AdoptedEffect, Location, Loop
from .expected import Expected
from .explanations import ExplanationEntry, LeftOut, NotKept


class Pattern(TypedDict, total=False):
    """The part of an explanation's residual that is no noise; a made key: `rms_…`, in the reading's unit."""

    location: Location
    driver: list[str]
    half: Location  # of half its energy


class LeftOfUnseen(TypedDict):
    """Where a regression without physics still finds something, and which driver that follows."""

    location: Location
    driver: str


class Excursion(TypedDict):
    """Where the reading goes off and comes back, in s; a made key: `size_…`, by how much, in the reading's unit."""

    at_s: float
    lasts_s: float


class Spike(TypedDict):
    """Samples of a channel that do not count."""

    run: str
    column: str
    count: int
    first_s: float  # time stamp of the first of them


class Covered(TypedDict, total=False):
    """The range that a recording covers: lowest and highest, in the units of load and motion."""

    load: list[float]
    speed_per_s: list[float]
    temperature_c: list[float]
    longest_hold_s: float
    longest_rest_s: float
    turned: dict[str, list[list[float]]]  # where the motion turned, at its `top` and its `bottom`, as ranges
    strokes_per_s: list[float]  # speeds of the slowest and the fastest stroke
    fastest_per_s: float  # of a moment


class OtherLoad(TypedDict):
    """The few strokes under another load, in the load channel's unit."""

    usual: float  # of the other strokes
    load: list[float]  # the lowest and the highest of these strokes
    strokes: list[int]


class Evidence(TypedDict, total=False):
    """All of it; made keys, in the reading's unit: `floor_…`, `nominal_…`, `calibrated_…`, `adopted_…`, …

    `resolution_…`, `single_floor_…`, `between_…` (outside of excursions), and by effect `spans_…`, `trends_…`,
    `tops_…` and `beyond_dimensions_…`; `sums_…` by two effects that nearly cancel. The channel that moves is one too:
    its lowest and highest value.
    """

    explanations: list[ExplanationEntry]
    probability_of_none: float | None
    left_out: list[LeftOut]
    looks_like: dict[str, float]  # a share of 1 by effect, and `outside`
    excursions: list[Excursion]
    loops: dict[str, Loop]  # by effect
    moved_sigma: dict[str, float]  # by dimension
    moved_alone_sigma: dict[str, float]  # by dimension, where nothing is named
    tolerance: dict[str, float]  # one sigma by dimension, in its unit
    tolerances_given: list[str]  # dimensions
    scale_given: float
    step_s: float
    scored_step_s: float
    strokes: list[int]  # the first and the last
    loaded: bool  # whether the load changed
    other_load: OtherLoad  # where it changed in too few samples for that
    covered: Covered
    pattern: Pattern
    chosen_without_them: list[str]  # effects, without the held-out strokes
    closest_without_them: list[str]
    likely_without_them: list[list[str]]  # where these strokes decided: the others that were likely before
    beyond_seen: dict[str, list[list[float]]]  # of `load` and `motion`: the range before, and the wider one after
    left_of_unseen: LeftOfUnseen
    spikes: list[Spike]
    adopted_effects: list[AdoptedEffect]
    not_kept: list[NotKept]
    expected: Expected
    idle: list[str]  # effects that came out with no strength
