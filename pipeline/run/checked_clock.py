"""The clock of a recording, checked at the door: it goes on, at a rate that a rig of this kind has."""

from pathlib import Path

import pandas as pd

from ..ground.command import command
from ..ground.errors import BadInput
from ..ground.input.strict_yaml import read_yaml
from ..ground.stored.rows import Rows, rows_of
from ..ground.words.counts import counted
from .folder import RECORDINGS
from .option_mend import import_command
from .run_yaml import RunYaml
from .table.clock import Clock
from .table.file_lines import Where, by_row
from .table.rate import STEP_S, is_rate, lasting, no_rate, unit_of_rate

SLOWEST_S = 600.0  # between samples of a rig that is no string: a tank may take a minute to fill
LONGEST_GAP_S = 7 * 86_400.0


class WrongClock(BadInput):
    """Time stamps that stand still or run backwards; `importing` says what the import makes of them."""

    importing = f"{command('import_run')} mends repeated and backward time stamps and says so"

    def by_import(self, content: RunYaml, recording: Path, name: str, out: Path) -> BadInput:
        """The same, with the command that imports the recording as run `name` of such a content as its mend."""
        mend = f"import it: {import_command(content, recording, name, out)}; {self.importing}"
        return BadInput(self.file, self.field, self.problem, mend)


def check_clock(
    samples: pd.DataFrame | Rows,
    path: Path,
    slowest_s: float = STEP_S[1],
    where: Where = by_row,
    unit: str | None = None,
) -> None:
    """Raise BadInput for a clock that stands, runs backwards, or has a rate that no rig of this kind has.

    `where` says where a row stands, and `unit` in which unit run.yaml reads the time, where it says so.
    """
    clock = Clock.of(rows_of(samples))
    if clock.wrong:
        word = "runs backwards" if clock.least_s < 0 else "stands still"
        problem = f"{word} at {where(clock.first_wrong + 1)} ({counted(clock.wrong, 'time')} in all)"
        refusal = WrongClock(path, "time_s", problem, WrongClock.importing)
        folder, described = path.parent, path.parent / "run.yaml"
        if path.name not in RECORDINGS or not described.is_file():
            raise refusal
        raise refusal.by_import(read_yaml(described), path, f"{folder.name}-mended", folder.parent)
    if clock.most_s > LONGEST_GAP_S:
        ends = f"{clock.leap_s[0]:.6g} s in {where(clock.leap)} and {clock.leap_s[1]:.6g} s after it"
        mend = "correct the stamp that is wrong, or cut the recording there into two runs"
        raise BadInput(path, "time_s", f"leaps by more than a week: {ends}", mend)
    if not is_rate(clock.usual_s, slowest_s):
        rates = f"{lasting(STEP_S[0])} to {lasting(slowest_s)}"
        told_unit = unit_of_rate(clock.usual_s, unit, slowest_s)
        mend = f"set channels.time_s.unit {told_unit}, or record a sample every {rates}"
        raise BadInput(path, "time_s", no_rate(clock.usual_s), mend)
