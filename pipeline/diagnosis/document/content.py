"""What `diagnosis.json` holds, for whoever reads it. Keys that end in the rig's unit stand in the parts below it."""

from collections.abc import Sequence
from typing import Any, NotRequired, TypedDict

from ...run.description import Included

Part = dict[str, Any]  # of the document, with keys by the rig's channels and the unit of its reading, as `rms_mm`
LegSaid = dict[str, float]  # of a proposed run: `seconds`, and motion and load at its end, by their channels' names


class Simulated(TypedDict):
    """What a simulator takes of it: dimensions by name, each with its `value`, and what acts. `run`: of which runs.

    `against_advice`: of a run.yaml, what the verdicts advised that it adopted against their advice.
    """

    run: NotRequired[str | list[str]]
    parameters: dict[str, Part]
    simulation: Sequence[Included]
    against_advice: NotRequired[list[str]]


class Quantity(TypedDict):
    """A number of a mechanism with its 90 % interval, all three in `unit`."""

    value: float
    low: float
    high: float
    unit: str


Place = TypedDict("Place", {"from": float}, total=False)  # the motion that a proposed run starts from


class NextRun(Place, total=False):
    """A proposed run, in numbers; `gap_now` and `gap_then`: by how much the best leads, now and as foretold."""

    title: str
    legs: list[LegSaid]
    load: float
    fixed_load: bool  # whether the load stood still in what was recorded
    parts: list[list[str]]  # explanations that it tells from the best
    gap_now: float
    gap_then: float
    pairs: list[Part]  # each two explanations that were compared: `ids`, and their own `gap_now` and `gap_then`
    apart: Part  # by how much the readings that the two expect differ at most, and the motion where
    follows: str
    decides: bool
    raises: bool
    curves: Part  # lists of numbers: time in s, motion, load, and each reading


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
    parameters: dict[str, Part]
    simulation: Sequence[Included]


class Unseen(TypedDict):
    """The simulator that the whole procedure found without the last strokes, and what it saw of each run, in s."""

    seen_s: list[float]  # from the run's first sample on; a run with 0 was not seen at all
    parameters: dict[str, Part]
    simulation: Sequence[Included]


class Verdict(Simulated, total=False):
    """All of it, as docs/diagnosis_json.md describes it; a file may lack anything but what is simulated."""

    verdict: str  # consistent, parameters, explained, ambiguous or unknown
    mismatch: Part | None
    mechanisms: list[Part]
    alternatives: list[list[str]]
    next_experiment: str | None
    next_run: NextRun | None
    fit: Part
    evidence: Part
    uncertainty: list[Doubt]
    rivals: list[Rival]
    without_last_strokes: Unseen
    code: str
    without: list[str]
    closest: Rival  # of an unknown verdict: what predicts better by far than dimensions alone, though it is no name
    beside: list[Part]  # what the simulator has beside what is named: stand-ins, no names
    of_your_own: Part
    adopted: list[Adoption]
    zero_jumps: list[Part]  # of the runs of one string


def proposal(content: Verdict) -> NextRun:
    """The run that a verdict proposes; raises ValueError where it proposes none."""
    if not content["next_run"]:
        raise ValueError("the verdict proposes no run")
    return content["next_run"]


def mismatch_of(content: Verdict) -> Part:
    """What is wrong with the simulator: how much, where, and what it follows; raises ValueError where nothing is."""
    if content["mismatch"] is None:
        raise ValueError("the verdict has no mismatch")
    return content["mismatch"]


def left_with_discrepancy(explanation: Part, ending: str) -> float:
    """What an explanation leaves if its formulas may be a little wrong, rms in the reading's unit, `ending` of keys.

    A file from before 2026-11-28 calls it `bent_…`.
    """
    key = f"with_discrepancy_{ending}"
    return float(explanation[key] if key in explanation else explanation[f"bent_{ending}"])
