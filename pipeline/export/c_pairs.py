"""Whether a twist was recorded around a load, or around what else the state tells, in C: half-planes of each hull."""

from itertools import pairwise

from ..ground.kinematics import Array
from ..models.parts.recorded_pairs import Paired
from .c_text import function, real
from .interface import Source

CALL = "tsa_recorded(&state, motor_turns)"
USAGE = (
    f"{CALL} returns TSA_UNRECORDED where nothing was recorded around that twist",
    "together with the state's other numbers; 0 where there was, and TSA_BAD_... as above. The two functions above",
    "answer all the same: give it the twist that you asked with, or that you got.",
)


def checked_pairs(source: Source) -> str:
    """The function, or nothing where what was recorded together is not known; it refuses what the others refuse."""
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
    for paired in source.pairs:
        if paired.name in source.inputs.names:
            planes = [
                f"motor_turns {beyond} {_along(edge, paired.name)}"
                for corners, beyond in zip(paired.corners, "<>", strict=True)
                for edge in _edges(corners, paired)
            ]
            lines += [f"if ({' ||'.join(chr(10) + ' ' * 8 + plane for plane in planes).lstrip()}) {{"]
            lines += ["    return TSA_UNRECORDED;", "}"]
    has = "#define TSA_HAS_RECORDED 1 /* tsa_recorded is there */\n\n"
    return has + function("int", "tsa_recorded(const tsa_state *at, tsa_real motor_turns)", *lines, "return TSA_OK;")


def _edges(corners: Array, paired: Paired) -> list[tuple[float, float, float]]:
    """Of each edge of a hull's side the first corner and the rise: the condition in its unit, twist in turns."""
    edges = [(float(x), float(y), float((y_next - y) / (x_next - x))) for (x, y), (x_next, y_next) in pairwise(corners)]
    return edges or [(float(paired.values[0]), float(corners[0][1]), 0.0)]


def _along(edge: tuple[float, float, float], name: str) -> str:
    """The twist of an edge at the state's value of a condition."""
    at, turns, rise = edge
    if rise == 0.0:
        return real(turns)
    return f"{real(turns)} + {real(rise)} * (at->{name} - {real(at)})"
