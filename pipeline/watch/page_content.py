"""The content of the page, sent as JSON each half second, part by part."""

from typing import TypedDict

from ..settle.motion_table import Row
from ..settle.proposed import Curves


class Moves(TypedDict):
    """The motion and the purpose of a proposed run, in words; `winds` is a count once it is approved."""

    begins: str
    head: tuple[str, ...]
    legs: list[Row]
    apart: str
    winds: int | None


class Came(TypedDict, total=False):
    """The newest drawing of recorded samples over their prediction; `page` is its path below reports/."""

    step: int
    file: str
    page: str | None


class Foretold(Curves, total=False):
    """The prediction for a run; `alone` where no explanations tie, and the recorded samples: s, mm."""

    alone: bool
    came: dict[str, list[float | None]]


class Loop(TypedDict):
    """The loop that settles the run's tie: its first run, its step, and its question."""

    at_work: bool
    stopping: bool
    settled: bool
    first: str
    step: int
    state: str
    title: str
    size: str
    moves: Moves | None
    verdict: str | None
    approved_by: str | None
    question: str | None
    foretold: Foretold | None
    came: Came | None


class JobsJson(TypedDict):
    """The workflow's jobs: how many are done, and those that run or failed, in words."""

    total: int
    done: int
    ended: bool
    ended_utc: str | None
    running: list[str]
    failed: list[str]
    failures: int


class Beside(TypedDict, total=False):
    """The parts of the page beside the recording."""

    loop: Loop | None
    jobs: JobsJson | None


class State(TypedDict):
    """The state of a recording: in words, rates in Hz, counts, bytes and its age in s."""

    state: str
    ended: bool
    ended_utc: str
    empty: str
    device: str
    samples: int
    unnamed: int
    rate_hz: float | None
    come_hz: float | None
    lost: int | None
    bad: int
    jumps: int
    replaced: int
    behind_bytes: int
    age_s: float | None
    free_bytes: int
    strokes: int | None
    planned: int


class StrokeCurve(TypedDict):
    """One stroke: displacement in mm over twist in turns, and the simulator's; None for a value that is no number."""

    motor_turns: list[float | None]
    displacement_mm: list[float | None]
    simulated_turns: list[float | None]
    simulated_mm: list[float | None]


class Left(TypedDict):
    """The strokes that a string has left, in numbers and in words; `file` is the forecast's path below reports/."""

    low: float | None
    median: float | None
    high: float | None
    words: str
    beside: list[str]
    until: str
    rests: str
    file: str


class Content(Beside, State, total=False):
    """All of it."""

    run: str
    columns: list[str]
    string: str | None
    material: str | None
    last: list[float | None]
    channels: list[dict[str, str | list[float | None]]]  # each with its `name`, and low and high with their times in s
    time_s: list[float | None]
    loops: list[StrokeCurve]
    noise_mm: float | None
    verdicts: list[dict[str, str]]
    verdict: str | None
    verdict_page: str | None
    verdict_text: str | None
    verdict_of: str
    index: bool
    left: Left | None
