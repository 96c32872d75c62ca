"""The motion of a proposed run, leg by leg in numbers: seconds, turns, turns/s and load."""

from collections.abc import Sequence
from typing import NamedTuple

from ..capture.motion_program import as_legs, strokes_of
from ..ground.words.counts import counted
from ..wire.motion import cruise
from .step import STANDS, Step

HEAD = ("leg", "s", "turns", "turns/s", "load (N)")
LONGEST = 8  # legs that repeat together
SHOWN = 2  # numbers of legs that repeat, before the last one


class Row(NamedTuple):
    """A leg, or legs that are alike, in words."""

    legs: str
    seconds: str
    turns: str
    turns_per_s: str
    load_n: str


def begins(step: Step) -> str:
    """The motor's place before a run, and the load at that time."""
    hangs = step.proposal.get("load")
    load = f", under {hangs:.4g} N" if hangs is not None else ""
    stands = f"Before it the motor stands at {step.proposal.get('from', 0.0):.2f} turns{load}."
    if not step.number or len(step.legs) < 2:
        return stands
    moves = abs(step.legs[0]["motor_turns"] - step.proposal.get("from", 0.0)) > STANDS
    return f"{stands} Leg 1 {'leads to where the run begins' if moves else 'is the rest before the run'}."


def size(step: Step) -> str:
    """The length of a run as its verdict says it, with its strokes, and the way to its beginning."""
    strokes = counted(step.strokes, "stroke")
    if not step.number or len(step.legs) < 2:
        return f"{step.seconds:.0f} s, {strokes}"
    first_s = step.legs[0]["seconds"]
    return f"{step.seconds - first_s:.0f} s, {strokes}; before it leg 1, {first_s:.0f} s"


def table(step: Step) -> list[Row]:
    """Legs of a run, with repeated ones in one row; the speed is that between this rig's ramps."""
    rows = _rows(step)
    short, at = list[Row](), 0
    while at < len(rows):
        size, times = _repeated(rows, at)
        for number in range(size):
            numbers = [str(at + number + 1 + size * time) for time in range(times)]
            all_of_them = ", ".join(numbers)
            legs = all_of_them if times <= SHOWN + 1 else f"{', '.join(numbers[:SHOWN])} … {numbers[-1]}"
            short.append(rows[at + number]._replace(legs=legs))
        at += size * times
    return short


def lines(step: Step) -> list[str]:
    """The same table as lines of a terminal."""
    rows = [HEAD, *table(step)]
    widths = [max(len(row[column]) for row in rows) for column in range(len(HEAD))]
    return ["  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows]


def winds(step: Step) -> int:
    """How often a run begins to wind, as a rig counts its strokes."""
    return strokes_of(as_legs(step.legs), step.proposal.get("from", 0.0))


def speed(way_turns: float, seconds: float, turns_per_s2: float | None) -> float:
    """The highest speed of a leg in turns/s; the mean speed where the ramps are unknown."""
    between_ramps = cruise(way_turns, seconds, turns_per_s2) if turns_per_s2 else None
    return abs(way_turns) / seconds if between_ramps is None else between_ramps


def _rows(step: Step) -> list[Row]:
    """A row for each leg, without its number."""
    at, hangs_n, rows = step.proposal.get("from", 0.0), step.proposal.get("load"), []
    for leg in step.legs:
        to, load_n = leg["motor_turns"], leg.get("load_n")
        hangs_n = hangs_n if load_n is None else load_n
        moves = abs(to - at) > STANDS
        fast = f"{speed(to - at, leg['seconds'], step.proposal.get('turns_per_s2')):.2f}" if moves else "0"
        way = f"{at:.2f} to {to:.2f}" if moves else f"stands at {to:.2f}"
        load = "as it hangs" if hangs_n is None else f"{hangs_n:.4g}"
        rows.append(Row("", f"{leg['seconds']:.1f}", way, fast, load))
        at = to
    return rows


def _repeated(rows: Sequence[Row], at: int) -> tuple[int, int]:
    """How many rows from `at` on repeat together, and how often; the choice that saves most rows."""
    best, saves = (1, 1), 0
    for size in range(1, min(LONGEST, (len(rows) - at) // 2) + 1):
        times = 1
        while rows[at + times * size : at + (times + 1) * size] == rows[at : at + size]:
            times += 1
        if size * (times - 1) > saves:
            best, saves = (size, times), size * (times - 1)
    return best
