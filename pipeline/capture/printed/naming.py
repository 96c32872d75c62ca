"""Names for columns that nothing names: those of run.yaml, else gaps; the order is never guessed."""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from ...ground.command import START
from ...ground.errors import BadInput
from ...run.description import Run
from ...run.folder import read_run

LIKELY = ("motor_turns", "displacement_mm", "load_n", "temperature_c", "motor_current_a")
USUAL: tuple[str, ...] = ("time_s", *LIKELY)  # of a run that nobody described yet
NEEDED = 3  # of a system's columns, which a recording must have
ORDER_UNKNOWN = "the order is that of run.yaml, and the rig's may be another; check each name by the last line"
GAP = "..."  # no name: what is left as it stands is refused
WHOLE = re.compile(rf": ({re.escape(START)}.* --columns [^\s;]+)(?=; |$)")  # a command inside a mend


class Naming(NamedTuple):
    """`own`: the columns' names in run.yaml, in its order; `wanted`: names for the columns that the run needs.

    The run is that of `folder`, if it has one.
    """

    own: tuple[str, ...] = ()
    wanted: tuple[str, ...] = USUAL
    folder: Path = Path()

    def option(self, size: int, clock: str = "") -> str:
        """An option that names that many columns; `clock` is the first column's name if it is known to be a clock."""
        if len(self.own) == size:
            return f"--columns {','.join(self.own)}"
        first = clock if clock and "time_s" in self.wanted else GAP
        return f"--columns {','.join([first, *[GAP] * (size - 1)])}"

    def mend(
        self, size: int, recover: str, clock: str = "", order: Sequence[str] = (), last: Sequence[str] = ()
    ) -> str:
        """How the command `recover`, which takes that option, names the columns.

        `order` is that of the names by the numbers, where these tell it, and `last` the last numbers.
        """
        in_order, named = "name them in the order in which the rig prints them", f"{recover} {self.option(size, clock)}"
        if len(self.own) == size:
            names = order or self.own
            values = ", ".join(f"{name} = {value}" for name, value in zip(names, last, strict=False))
            check = "these are the names in run.yaml, in its order, which must be checked with the rig's first line"
            if order:
                check = f"in this order alone the numbers move as this string does; check it by the last line: {values}"
            elif last:
                check = f"{ORDER_UNKNOWN}: {values}; where a value is another column's, exchange the names"
            return f"{in_order}: {recover} --columns {','.join(names)}; {check}"
        time = [] if clock else ["time_s or time_ms"]
        wanted = [each for name in self.wanted for each in (time if name == "time_s" else [name])]
        return f"{in_order}, with a name for each {GAP} ({', '.join(wanted)}, or one of your own): {named}"


def command_below(mend: str) -> str:
    """The mend with its command on a line of its own, where it is one whole command; else the mend as it stands."""
    command = WHOLE.search(mend)
    if command is None or GAP in command[1] or mend.count(START) > 1:
        return mend
    return f"{mend[: command.start()]}, by the command below{mend[command.end() :]}\n  {command[1]}"


def after_screen(problem: str, mend: str, screen_mend: str) -> tuple[str, str]:
    """The problem and the mend for the end: of what the screen has told with `screen_mend`, the command alone.

    An order of the columns that the screen did not tell so is told whole.
    """
    command = WHOLE.search(mend)
    if command is None or not WHOLE.search(screen_mend):
        return problem, mend
    is_same = mend.partition(" = ")[0] == screen_mend.partition(" = ")[0]  # all but the last line's values
    return "no line is read, as said above", f"name the columns: {command[1]}" if is_same else mend


def naming_of(run: Run, folder: Path) -> Naming:
    """How a run's columns are named; those that run.yaml gives by their places have no names in it."""
    columns = [name if channel.column is None else channel.column for name, channel in run.channels.items()]
    own = tuple(column for column in columns if isinstance(column, str))
    calls = dict(zip(run.channels, columns, strict=True))
    wanted = [calls.get(name, name) for name in run.system.columns if name in calls or name in _usual(run)]
    return Naming(own if len(own) == len(columns) else (), tuple(str(name) for name in wanted), folder)


def _usual(run: Run) -> tuple[str, ...]:
    return (*run.system.columns[:NEEDED], *(name for name in USUAL if name in run.system.columns))


def naming_in(folder: Path) -> Naming:
    """How the columns of the run in a folder are named, described or not."""
    try:
        return naming_of(read_run(folder), folder)
    except BadInput:
        return Naming()
