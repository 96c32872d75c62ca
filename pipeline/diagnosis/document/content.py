"""What `diagnosis.json` holds, for whoever reads it. Keys that end in the rig's unit are read by `keyed`."""

from collections.abc import Sequence
from typing import Literal, NotRequired, TypedDict

from ...run.description import Included
from .effects_named import Dimension, Location, MechanismEntry, OfYourOwn, StandIn
from .evidence import Evidence
from .expected import NextRun
from .explanations import ExplanationEntry
from .made_keys import amount

VerdictWord = Literal["consistent", "parameters", "explained", "ambiguous", "unknown"]


class Simulated(TypedDict):
    """What a simulator takes from a diagnosis: dimensions by name, the acting effects, and `run`: of which runs.

    `against_advice`: of a run.yaml, what the verdicts advised that it adopted against their advice.
    """

    run: NotRequired[str | list[str]]
    parameters: dict[str, Dimension]
    simulation: Sequence[Included]
    against_advice: NotRequired[list[str]]


class Adoption(TypedDict, total=False):
    """Where adopted effects came from: the verdict that named them, and what was tied then."""

    effects: list[str]
    verdict: str
    tied: list[list[str]]
    diagnosis: str
    runs: list[str]
    dimensions: dict[str, dict[str, float]]  # by name: as `measured`, and as `fitted` with the effects
    next_experiment: str | list[str]  # the run that decides: title, steps, and what it is good for
    against_advice: list[str]  # where it was adopted against the verdict's advice: that, and what to record instead


class Doubt(TypedDict):
    """One number of a simulator, and by how much each independent direction of doubt moves it, at one sigma.

    `name` is that of a dimension, or of a parameter of the `entry`-th entry with this `id` in `simulation`, from 0.
    Directions after the last that is given move it by nothing.
    """

    name: str
    moves: list[float]
    id: NotRequired[str]
    entry: NotRequired[int]


class Rival(TypedDict):
    """One explanation that ties, as a simulator: its mechanisms' `ids`, its dimensions, and what acts."""

    ids: list[str]
    parameters: dict[str, Dimension]
    simulation: Sequence[Included]


class Unseen(TypedDict):
    """The simulator that was found without the last strokes, and how much of each run it saw, in s."""

    seen_s: list[float]  # from the run's first sample on; a run with 0 was not seen at all
    parameters: dict[str, Dimension]
    simulation: Sequence[Included]


class Mismatch(TypedDict):
    """A simulator's mismatch: where it is and what it follows; a made key: `rms_…`, in the reading's unit."""

    location: Location
    driver: str


class HeldOut(TypedDict):
    """Errors on strokes that no fit has seen; made keys, rms in the reading's unit, of each simulator: `explained_…`.

    The others are `nominal_…`, `calibrated_…` and `without_physics_…`.
    """

    split: str  # which strokes
    runs: NotRequired[list[str]]  # of several: the runs that have some of these


class Relative(TypedDict):
    """What each simulator leaves, over the reading itself, after the filter that is stated with it; without a unit."""

    nominal: float
    calibrated: float
    explained: float
    filter: str


class Fit(TypedDict, total=False):
    """How well it fits; made keys, in the reading's unit: `noise_floor_…`, `single_floor_…`, `detectable_…`.

    The last is by effect.
    """

    heldout: HeldOut | None
    worse_than_nominal: list[str]  # simulators
    relative_residual: Relative


class Verdict(Simulated, total=False):
    """The whole content, as docs/diagnosis_json.md describes it; only what is simulated must be there."""

    verdict: VerdictWord
    mismatch: Mismatch | None
    mechanisms: list[MechanismEntry]
    alternatives: list[list[str]]
    next_experiment: str | None
    next_run: NextRun | None
    fit: Fit
    evidence: Evidence
    uncertainty: list[Doubt]
    rivals: list[Rival]
    without_last_strokes: Unseen
    code: str
    without: list[str]
    closest: Rival  # of an unknown verdict: what predicts better by far than dimensions alone, though it is no name
    beside: list[StandIn]  # what the simulator has beside what is named: stand-ins, no names
    of_your_own: OfYourOwn
    adopted: list[Adoption]
    zero_jumps: list[dict[str, str | float]]  # of the runs of one string


def proposal(content: Verdict) -> NextRun:
    """The run that a verdict proposes; raises ValueError where it proposes none."""
    if not content["next_run"]:
        raise ValueError("the verdict proposes no run")
    return content["next_run"]


def mismatch_of(content: Verdict) -> Mismatch:
    """The mismatch of the simulator: how much, where, and what it follows; raises ValueError where there is none."""
    if content["mismatch"] is None:
        raise ValueError("the verdict has no mismatch")
    return content["mismatch"]


def left_with_discrepancy(explanation: ExplanationEntry, ending: str) -> float:
    """The rms that an explanation leaves if its formulas may be a little wrong; `ending` of the keys.

    A file from before 2026-11-28 calls it `bent_…`.
    """
    key = f"with_discrepancy_{ending}"
    return amount(explanation, key if key in explanation else f"bent_{ending}")
