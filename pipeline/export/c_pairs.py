"""In C: whether a twist was recorded around a load, or another condition; a load around a size; a stroke around a load.

Half-planes of the hulls of condition and twist and of size and load, quadrants of the strokes around a load.
"""

import math
from collections.abc import Iterable
from itertools import pairwise

from ..ground.kinematics import Array
from ..models.parts.inside.recorded_pairs import Paired
from ..models.parts.inside.recorded_strokes import LOAD, Under
from ..models.parts.inside.strokes_around import StrokesAround
from .c_text import function, real
from .interface import Source

CALL = "tsa_recorded(&state, motor_turns)"
USAGE = (
    f"{CALL} returns TSA_UNRECORDED where that twist was not recorded around one of",
    "the state's other numbers, or its load not around one of the string's sizes (a load that only a string of another",
    "size was under); 0 where both were, and TSA_BAD_... as above. Which of several strings of one size is meant it",
    "does not know. The two functions above answer all the same: give it the twist that you asked with, or that you",
    "got. tsa_stroke_recorded(&state) asks whether the stroke was recorded under the load at all, at whatever twist.",
    "Both return TSA_UNRECORDED too where the stroke is further ahead than errors were measured.",
)


def checked_pairs(source: Source) -> str:
    """The check function, or nothing if recorded combinations are unknown; it refuses like the other functions."""
    if source.pairs is None:
        return ""
    lines = [
        "const int refused = tsa_check(at);",
        "if (refused != TSA_OK) {",
        "    return refused;",
        "}",
        "if (!(motor_turns >= TSA_MOTOR_TURNS_MIN && motor_turns <= TSA_MOTOR_TURNS_MAX)) {",
        "    return TSA_BAD_MOTOR_TURNS;",
        "}",
    ]
    lines += ["if (tsa_stroke_recorded(at) != TSA_OK) {", "    return TSA_UNRECORDED;", "}"]
    for paired in source.pairs:
        if paired.name in source.inputs.names:
            lines += _refused_beyond(paired, "motor_turns")
    for paired in source.loads:
        if {paired.name, LOAD} <= set(source.inputs.names):
            lines += _refused_beyond(paired, f"at->{LOAD}")
    if source.under and source.under.name in source.inputs.names:
        last = real(source.under.last)
        stroke = f"const tsa_real stroke = (tsa_real)at->stroke < {last} ? (tsa_real)at->stroke : {last};"
        under = [stroke, *_refused_strokes(source.under.around[0], source.under.name)]
        as_far = _refused_as_far(source.under)
        lines = [*([stroke] if as_far else []), *lines, *as_far]
    else:
        under = []
    under += _refused_too_far(source) or ["(void)at;"]
    has = "#define TSA_HAS_RECORDED 1 /* tsa_recorded and tsa_stroke_recorded are there */\n\n"
    has += function("int", "tsa_stroke_recorded(const tsa_state *at)", *under, "return TSA_OK;")
    return has + function("int", "tsa_recorded(const tsa_state *at, tsa_real motor_turns)", *lines, "return TSA_OK;")


def _refused_too_far(source: Source) -> list[str]:
    """Lines that refuse a stroke further ahead than errors were measured; none where that is unknown."""
    if source.foreseen is None:
        return []
    farthest = source.inputs.last_stroke + source.foreseen[1]
    return [f"if (at->stroke > {farthest}) {{", "    return TSA_UNRECORDED;", "}"]


def _refused_as_far(under: Under) -> list[str]:
    """Lines that refuse a stroke that was not wound that far under its load."""
    lines = []
    for level, around in zip(under.levels[1:].tolist(), under.around[1:], strict=True):
        beyond = "\n".join(_refused_strokes(around, under.name)).replace("\n", "\n    ")
        lines += [f"if (motor_turns >= {real(level)}) {{", f"    {beyond}", "}"]
    return lines


def _refused_strokes(around: StrokesAround, load: str) -> list[str]:
    """Lines that refuse a `stroke` that does not count under its load, which has this name in C."""
    quadrants = []
    for beyond in around.beyond():
        quadrant = f"stroke {'>' if beyond.is_later else '<'} {real(beyond.stroke)}"
        if math.isfinite(beyond.load_n):
            quadrant = f"({quadrant} && at->{load} {'>' if beyond.is_higher else '<'} {real(beyond.load_n)})"
        quadrants.append(quadrant)
    return _refused_where_any(quadrants)


def _refused_beyond(paired: Paired, number: str) -> list[str]:
    """Lines that refuse a number, by its name in C, beyond an edge of the hull of a condition and that number."""
    return _refused_where_any(
        f"{number} {beyond} {_along(edge, f'at->{paired.name}')}"
        for corners, beyond in zip(paired.corners, "<>", strict=True)
        for edge in _edges(corners, paired)
    )


def _refused_where_any(conditions: Iterable[str]) -> list[str]:
    """Lines that refuse where a condition in C holds."""
    any_of_them = " ||".join(f"\n{' ' * 8}{condition}" for condition in conditions).lstrip()
    return [f"if ({any_of_them}) {{", "    return TSA_UNRECORDED;", "}"]


def _edges(corners: Array, paired: Paired) -> list[tuple[float, float, float]]:
    """Of each edge of a hull's side the first corner and the rise: condition in its unit, twist in turns, load in N."""
    edges = [(float(x), float(y), float((y_next - y) / (x_next - x))) for (x, y), (x_next, y_next) in pairwise(corners)]
    return edges or [(float(paired.values[0]), float(corners[0][1]), 0.0)]


def _along(edge: tuple[float, float, float], condition: str) -> str:
    """The twist, or the load, of an edge at a condition."""
    at, number, rise = edge
    if rise == 0.0:
        return real(number)
    return f"{real(number)} + {real(rise)} * ({condition} - {real(at)})"
