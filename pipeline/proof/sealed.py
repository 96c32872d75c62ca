"""The content of a case's sealed answer; an author's answer says less than that of the project's own rig."""

from collections.abc import Mapping
from typing import TypedDict


class Box(TypedDict, total=False):
    """A place in a recording, its ends included: twist in turns, strokes as counts; it holds `share` of the energy."""

    motor_turns: list[float]
    strokes: list[int]
    phase: str
    share: float
    of_samples: float  # a share of them


class SizeJson(TypedDict, total=False):
    """The size of an effect: in noise floors after calibration, rms in mm before, and the absorbed share."""

    kappa: float
    raw_mm: float
    varies_mm: float
    hidden_share: float | None


class RulingJson(TypedDict):
    """The referee's findings on an effect: the shares that go with its driver, and that change with other things."""

    driver: str
    driver_carries: float
    bystanders_change: dict[str, float]


class EffectJson(TypedDict, total=False):
    """A hidden effect: its name, parameters and size, what the referee saw; of an author its law and `rms_mm`."""

    id: str
    law: str
    parameters: Mapping[str, object]
    rms_mm: float
    kappa: float
    raw_mm: float
    varies_mm: float
    hidden_share: float | None
    driver: str
    driver_carries: float
    bystanders_change: dict[str, float]


class AskedJson(TypedDict):
    """The choices for a case, as `plan.Planned` has them."""

    run: str
    seed: int
    stratum: str
    protocol: str
    effects: tuple[str, ...]
    kappas: tuple[float, ...]
    without: str
    baselines: bool
    author: str


class DimensionJson(TypedDict):
    """A dimension of the bench, in the unit that its name ends in."""

    measured: float
    true: float


class AlwaysJson(TypedDict):
    """Small effects that no diagnosis need find, by name, and how many noise floors they are together."""

    effects: Mapping[str, Mapping[str, object]]
    kappa: float


class MotionJson(TypedDict):
    """The motion that was made: a rest in s, then the strokes, each by the names of `rig.motion_commands.Strokes`."""

    rest_s: float
    strokes: list[dict[str, float]]


class Answer(TypedDict, total=False):
    """The whole answer; for a case that could not be made, `skipped` holds the reason, beside the plan."""

    run: str
    asked: AskedJson
    skipped: str
    seed: int
    stratum: str
    protocol: str
    effects: list[EffectJson]
    together: SizeJson
    noise_floor_mm: float
    heldout_noise_mm: float
    location: Box | None
    dimensions: dict[str, DimensionJson]
    measuring_errors_sigma: dict[str, float]
    calibration_moves_sigma: dict[str, float]
    scale: float
    zero_mm: float
    nuisance: dict[str, float]
    always: AlwaysJson
    motion: MotionJson
