"""The parts of a verdict's diagnosis.json that the proof reads; its rigs have a reading in mm."""

from typing import NotRequired, TypedDict

from .sealed import Box


class IntervalJson(TypedDict):
    """A number with its 90 % interval, in the unit of what holds it."""

    value: float
    low: float
    high: float


class NamedJson(TypedDict):
    """An effect that a verdict names, and what it does to the reading."""

    id: str
    rms_mm: NotRequired[IntervalJson]


class MismatchJson(TypedDict, total=False):
    """Where the simulator and the recording differ."""

    location: Box


class FitJson(TypedDict, total=False):
    """How well it fits: by simulator the error on strokes that no fit has seen, rms in mm."""

    heldout: dict[str, float] | None


class VerdictJson(TypedDict, total=False):
    """The verdict's word, what it names and cannot rule out, the dimensions by name, and how well it fits."""

    verdict: str
    code: str
    mechanisms: list[NamedJson]
    alternatives: list[list[str]]
    parameters: dict[str, IntervalJson]
    fit: FitJson
    mismatch: MismatchJson | None
