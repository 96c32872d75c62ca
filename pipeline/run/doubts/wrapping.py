"""An angle that begins anew each turn, as from a single-turn encoder: found by its jumps; and how to mend it."""

from pathlib import Path

import numpy as np

from ...ground.errors import BadInput
from ...ground.kinematics import Array
from ...ground.stored.rows import Rows
from ...ground.words.counts import counted

JUMP = 0.5  # of the range: what a motor does not do from sample to sample
SAME_WAY = 3  # jumps that follow a jump the same way: the angle came back slowly in between
MOST_ROWS = 1_000_000  # of a recording that are looked at
TURN = {"turns": 1.0, "rad": 2.0 * np.pi, "deg": 360.0}
NUMPY = "numpy.unwrap(angle, "
ABOUT = (0.9, 1.02)  # of a turn, that the range of a wrapped angle is


def wraps(angle: Array) -> bool:
    """Whether an angle, shape (rows,), in any unit, jumps by its range again and again, and goes on after each jump."""
    finite = angle[np.isfinite(angle)]
    if len(finite) < 2:
        return False
    steps = np.diff(finite)
    jumps = np.sign(steps[np.abs(steps) > JUMP * np.ptp(finite)])
    return int(np.count_nonzero(jumps[1:] == jumps[:-1])) >= SAME_WAY


def unit_of_turn(angle: Array) -> str | None:
    """The unit in which a wrapped angle, shape (rows,), in any unit, has the range of a turn; None if there is none."""
    span = float(np.nanmax(angle) - np.nanmin(angle))
    return next((unit for unit, turn in TURN.items() if ABOUT[0] * turn <= span <= ABOUT[1] * turn), None)


def unwrapping(unit: str | None) -> str:
    """The mend of a wrapped angle in a known unit, or in an unknown one."""
    turn = f"{TURN[unit]:g}" if unit in TURN else "a turn"
    does = f"period={turn}) does it" if unit in TURN else "period=360) does it for degrees"
    return f"unwrap it in the file: from each jump down on add {turn}, from each jump up on take it off; {NUMPY}{does}"


def wrapped(samples: Rows, path: Path) -> BadInput | None:
    """What is wrong with a recording whose `motor_turns` wrap; None where they do not."""
    turns = samples.read("motor_turns", 0, min(len(samples), MOST_ROWS))
    if not wraps(turns):
        return None
    by = counted(max(round(float(np.ptp(turns))), 1), "turn")
    problem = f"jumps by about {by} again and again and goes on: the angle wraps"
    return BadInput(path, "motor_turns", problem, unwrapping(None))
