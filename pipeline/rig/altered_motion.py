"""Altered copies of a motion, in which the referee tests what an effect claims about itself.

An effect that claims to vanish in another motion than these defines an `Otherwise` of its own, in its own file.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from ..ground.kinematics import Array
from .motion_commands import Commands

Paced = tuple[Commands, float]  # what is commanded, and how long a step of it lasts, in s


@dataclass(frozen=True)
class Otherwise:
    """An altered motion: its name in a case's answer, and its changes to commands and to a step's length."""

    name: str
    made: Callable[[Commands, float], Paced]
    after_one_winding: bool = False  # counts from the second stroke on: what the first winding does is no growth


def turns(name: str, to_turns: Callable[[Array], Array], after_one_winding: bool = False) -> Otherwise:
    """A motion of other twist: `to_turns` maps twist to twist, both in turns and of shape (steps,)."""
    return Otherwise(
        name,
        lambda commands, step_s: (replace(commands, motor_turns=to_turns(commands.motor_turns)), step_s),
        after_one_winding,
    )


def load(name: str, to_load_n: Callable[[Array], Array]) -> Otherwise:
    """A motion under another load: `to_load_n` maps load to load, both in N and of shape (steps,)."""
    return Otherwise(name, lambda commands, step_s: (replace(commands, load_n=to_load_n(commands.load_n)), step_s))


def pace(name: str, times: float) -> Otherwise:
    """The same motion, that many times as fast."""
    return Otherwise(name, lambda commands, step_s: (commands, step_s / times))


IN_NO_TIME = pace("in no time", 1e6)
INFINITELY_SLOWLY = pace("infinitely slowly", 0.001)
AT_HALF_SPEED = pace("at half speed", 0.5)
A_HUNDRED_TIMES_AS_FAST = pace("a hundred times as fast", 100.0)
WITHOUT_LOAD = load("without load", lambda load_n: 1e-6 * load_n)
UNDER_ONE_LOAD = load("under one load", lambda load_n: np.full_like(load_n, load_n.mean()))
UNDER_TWICE_THE_LOAD = load("under twice the load", lambda load_n: 2.0 * load_n)
AT_REST = turns("at rest", lambda motor_turns: np.full_like(motor_turns, motor_turns[0]))
WOUND_UP_ONCE = turns("wound up once", np.maximum.accumulate, after_one_winding=True)
HALF_WOUND = turns("half wound", lambda motor_turns: 0.4 * motor_turns)
NEVER_UNWOUND = turns("never unwound", lambda motor_turns: 0.5 * motor_turns.max() + 0.5 * motor_turns)
BY_WHOLE_TURNS = turns("by whole turns", np.rint)
