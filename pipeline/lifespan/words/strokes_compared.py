"""The account of a string's strokes: how many were recorded, which are compared, and why the others are not."""

from ...ground.words.counts import counted
from ..stroke_health.health import SAME_RANGE, Health
from ..stroke_health.indicators import REFERENCE
from ..stroke_health.one_load import spans
from .percent import percent
from .stroke_counts import strokes

CALIBRATED = f"The model below is calibrated on the first {REFERENCE} of them."


def recorded(health: Health) -> str:
    """How many complete strokes were recorded, and which of them are compared."""
    compared = health.strokes["stroke"].astype(int).tolist()
    out = len(health.left_out) + health.loads.count_left_out
    numbers = f"({spans(compared)})"
    if not out:
        return f"{strokes(len(compared))} recorded {numbers}, all compared"
    over = f" over {_range(health)}" * bool(health.left_out)
    these = f"{len(compared)} of them compared{health.loads.under}{over} {numbers}"
    return f"{strokes(len(compared) + out)} recorded, {these}"


def left_out(health: Health) -> list[str]:
    """Which strokes are not compared and why, and from which stroke on those that are left are counted."""
    lines = [health.loads.left_out] if health.loads.others else []
    if health.left_out:
        out = f"{strokes(len(health.left_out))}{health.loads.under} ({spans(health.left_out)})"
        first = sorted({*health.left_out, *health.strokes["stroke"].astype(int)})[:REFERENCE]
        middle = f"the median of the first {strokes(len(first))}{health.loads.under} ({spans(first)})"
        like = f"within {percent(SAME_RANGE)}, {middle}"
        lines.append(f"Left out: {out}, not wound over {_range(health)} {like}.")
    last = int(health.strokes["stroke"].iloc[-1])
    others = [number for _, numbers in health.loads.others for number in numbers]
    since = sum(number > last for number in (*health.left_out, *others))
    if since:
        lines.append(f"Strokes left are counted from stroke {last}: the string did {counted(since, 'stroke')} since.")
    return lines


def _range(health: Health) -> str:
    low, high = health.range_turns
    return f"{low:.3g} to {high:.3g} turns"
