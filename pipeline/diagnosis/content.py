"""What `diagnosis.json` holds, for whoever reads it. Keys that end in the rig's unit stand in the parts below it."""

from collections.abc import Sequence
from typing import Any, NotRequired, TypedDict

from ..run.description import Included

Part = dict[str, Any]  # of the document, with keys that end in the unit of the rig's reading, as `rms_mm`


class Simulated(TypedDict):
    """What a simulator takes of it: dimensions by name, each with its `value`, and what acts. `run`: of which runs."""

    run: NotRequired[str | list[str]]
    parameters: dict[str, Part]
    simulation: Sequence[Included]


class LegSaid(TypedDict, total=False):
    """One leg of a proposed run: how long, and the motion and the load at its end, under their channels' names."""

    seconds: float


class NextRun(TypedDict, total=False):
    """A proposed run, in numbers; `gap_now` and `gap_then`: by how much the best leads, now and as foretold."""

    title: str
    legs: list[LegSaid]
    load: float
    fixed_load: bool  # whether the load stood still in what was recorded
    parts: list[list[str]]  # explanations that it tells from the best
    gap_now: float
    gap_then: float
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
    next_experiment: str


class Verdict(Simulated, total=False):
    """All of it, as docs/diagnosis.md describes it; a file may lack anything but what is simulated."""

    verdict: str  # consistent, parameters, explained, ambiguous or unknown
    mismatch: Part | None
    mechanisms: list[Part]
    alternatives: list[list[str]]
    next_experiment: str | None
    next_run: NextRun | None
    fit: Part
    evidence: Part
    code: str
    without: list[str]
    of_your_own: Part
    adopted: list[Adoption]
    zero_jumps: list[Part]  # of the runs of one string
