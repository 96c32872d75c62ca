"""Parts of a diagnosis that foretell: what each explanation expects of strokes not made yet, and the next run."""

from typing import NotRequired, TypedDict

LegSaid = dict[str, float]  # of a proposed run: `seconds`, and motion and load at its end, by their channels' names


class ExpectedExplanation(TypedDict):
    """What one explanation foretells; made keys: `loop_…`, `top_…`, `hold_…` and `rest_…`, in the reading's unit."""

    ids: list[str]
    recorded: NotRequired[dict[str, float]]  # `loop_…`, its loop in the strokes that were recorded
    plus_minus: NotRequired[dict[str, float]]  # half of the 90 % interval of each number, by its key


class Expected(TypedDict, total=False):
    """What explanations foretell of strokes not made yet, and of which strokes; empty where nothing is named."""

    load: float  # the usual one, in the unit of the load
    speed_per_s: float  # the usual one, in the motion's unit per second
    strokes: int  # more of them
    stand_s: float
    recorded: dict[str, float]  # `loop_…`, the loop that the recording itself shows, in the reading's unit
    explanations: list[ExpectedExplanation]


class Pair(TypedDict):
    """Two explanations that were compared, and how far they are apart: differences of minus 2 log likelihood."""

    ids: list[list[str]]
    gap_now: float
    gap_then: float


class Apart(TypedDict, total=False):
    """Where two expected readings differ most; made keys: `by_…`, `first_…`, `second_…`, and the motion there."""

    after_s: float


class Curves(TypedDict):
    """What a run would show, each of shape (points,); a made key: the motion, in its unit."""

    time_s: list[float]
    load: list[float]  # in its unit
    calibrated: list[float]  # without mechanisms, in the reading's unit, from its start
    rivals: dict[str, list[float]]  # by their effects


Place = TypedDict("Place", {"from": float}, total=False)  # the motion that a proposed run starts from


class NextRun(Place, total=False):
    """A proposed run in numbers; `gap_now`, `gap_then`: the lead of the best explanation, now and as foretold."""

    title: str
    legs: list[LegSaid]
    load: float
    fixed_load: bool  # whether the load stood still in what was recorded
    parts: list[list[str]]  # explanations that it tells from the best
    gap_now: float
    gap_then: float
    pairs: list[Pair]
    apart: Apart
    follows: str
    decides: bool
    raises: bool
    curves: Curves
