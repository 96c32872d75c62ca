"""Diagnose runs: where simulation and recording differ, which physics is missing, and what it improves."""

import sys
import time
import traceback
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from .diagnosis.arguments import parsed
from .diagnosis.written import write_seconds
from .ground.code.own_process import each_alone
from .ground.errors import BadInput, program
from .ground.stored.files import write_text
from .notebook.of_folders import Decided, Options, decide, diagnose
from .run.run_arguments import real_name, refuse_twice
from .string.history import read_recorded
from .string.jumps_beside import Beside

MODULES = tuple(
    f"{__package__}.{name}" for name in ("notebook.of_folders", "diagnosis.drawing.figures")
)  # of many runs


@dataclass(frozen=True)
class Outcome:
    """What came of one run: its words or its error, and whether that counts as done, None for a fault of ours.

    A verdict that must wait for the runs beside it is `decided`, and has no words yet.
    """

    text: str
    fine: bool | None
    decided: Decided | None = None
    seconds: float = 0.0  # of CPU time, of its own process

    def written(self, beside: Beside) -> "Outcome":
        """The same, its verdict written."""
        if self.decided is None:
            return self
        try:
            return replace(self, text=self.decided.write(beside), decided=None)
        except Exception:
            return replace(self, text=_fault(self.decided.name), fine=None, decided=None)


def _timed(folder: Path, *options: Any) -> Outcome:
    """As `_one`, and the CPU seconds that it took of this process."""
    began_s = time.process_time()
    return replace(_one(folder, *options), seconds=time.process_time() - began_s)


def _one(folder: Path, out: Path, options: Options, note: bool) -> Outcome:
    """What comes of one run; `note` writes a refusal where the words would be."""
    folder_out = out / real_name(folder)
    try:
        decided = decide([folder], folder_out, options)
        outcome = Outcome("", True, decided)
        return outcome if decided.waits else outcome.written(Beside(decided.rests))
    except BadInput as error:
        if note:
            write_text(folder_out / "verdict.txt", f"{folder.name}: not decided: {error}\n")
        return Outcome(f"error: {error}", note)
    except Exception:  # a fault of ours in one run must not cost the others
        return Outcome(_fault(str(folder)), None)


def _fault(name: str) -> str:
    """What is said of the error that is being handled."""
    return f"error: {name}: the diagnosis failed, please report it:\n{traceback.format_exc()}"


@program
def main() -> int:
    """Command line."""
    arguments = parsed(__doc__ or "")
    folders: list[Path] = arguments.run_dir
    options = Options(arguments.together, frozenset(arguments.without), arguments.judge, mark=arguments.mark)
    if arguments.processed:
        options = replace(options, reader=partial(read_recorded, processed=arguments.processed))
    if arguments.together:
        refuse_twice(folders, "what it shows would count twice")
        began_s = time.process_time()
        print(diagnose(folders, arguments.out, options))
        write_seconds(arguments.cpu_seconds, {"+".join(map(real_name, folders)): time.process_time() - began_s})
        return 0
    outcomes: list[Outcome] = []
    waiting = each_alone(
        _timed, folders, arguments.out, options, arguments.note_refusals, jobs=arguments.jobs, preload=MODULES
    )
    try:
        outcomes.extend(waiting)
    finally:  # what was decided is written, whatever became of the others
        beside = Beside(rests for outcome in outcomes if outcome.decided for rests in outcome.decided.rests)
        outcomes = [outcome.written(beside) for outcome in outcomes]
    for outcome in outcomes:
        print(outcome.text, file=sys.stdout if outcome.fine else sys.stderr)
    taken_s = [outcome.seconds for outcome in outcomes]
    write_seconds(arguments.cpu_seconds, dict(zip(map(real_name, folders), taken_s, strict=True)))
    fine = [outcome.fine for outcome in outcomes]
    return 1 if None in fine else 0 if all(fine) else 2


if __name__ == "__main__":
    main()
