"""A possible run, and the verdict before it, in the form of a step's files."""

from collections.abc import Sequence
from typing import NotRequired, TypedDict, cast

import numpy as np

from ..capture.motion_program import LegJson
from .limits import Given


class Curves(TypedDict):
    """The prediction for a run, as lists of one length: time in s, motion in turns, load in N, readings in mm.

    `calibrated` is the simulator without a mechanism, `rivals` what each explanation that ties foretells.
    """

    time_s: list[float]
    motor_turns: list[float]
    load: list[float]
    calibrated: list[float]
    rivals: dict[str, list[float]]


_Begins = TypedDict("_Begins", {"from": float}, total=False)  # where the motor stands before it, in turns


class Pair(TypedDict):
    """Two explanations, and how far apart they are without a run and with it: squares of standard deviations."""

    ids: list[list[str]]
    gap_now: float
    gap_then: float


class ProposedRun(_Begins, total=False):
    """A run of `next_runs.json`, as `next_run` in docs/diagnosis_json.md; in step 0 also `runs`, the existing ones."""

    title: str
    legs: list[LegJson]
    load: float | None
    fixed_load: bool
    parts: list[list[str]]
    pairs: list[Pair]
    gap_now: float
    gap_then: float
    follows: str
    decides: bool
    raises: bool
    curves: Curves
    runs: Sequence[str]
    limits: Given  # that a person gave when it was proposed
    turns_per_s2: float  # of the rig's ramps, as it declared them when the run was proposed


class Size(TypedDict):
    """The parts of a size that this program reads, in mm."""

    value: float


class NamedMechanism(TypedDict):
    """The parts of an entry of `mechanisms` that this program reads."""

    id: str
    rms_mm: NotRequired[Size]


class Explanation(TypedDict):
    """The parts of an entry of `explanations` that this program reads."""

    ids: list[str]
    probability: float | None


class Evidence(TypedDict, total=False):
    """The parts of the `evidence` that this program reads."""

    explanations: list[Explanation]


class StepVerdict(TypedDict):
    """The parts of a step's `diagnosis.json` that this program reads."""

    verdict: str
    mechanisms: list[NamedMechanism]
    alternatives: list[list[str]]
    evidence: NotRequired[Evidence]


def retimed(run: ProposedRun, legs: Sequence[LegJson]) -> ProposedRun:
    """A run whose legs take as long as the rig needs, with its prediction shifted in time with them."""
    curves = run["curves"]
    before_s, after_s = (np.cumsum([0.0, *(leg["seconds"] for leg in each)]) for each in (run["legs"], legs))
    time_s = np.interp(curves["time_s"], before_s, after_s).tolist()
    return {**run, "legs": list(legs), "curves": {**curves, "time_s": time_s}}


def without_curves(run: ProposedRun) -> ProposedRun:
    """A possible run without its prediction."""
    return cast(ProposedRun, {key: value for key, value in run.items() if key != "curves"})
