"""Diagnose runs: where simulation and recording differ, which physics is missing, and what it improves."""

import json
import sys
import time
import traceback
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from .diagnosis.arguments import parsed
from .diagnosis.document.content import Verdict
from .diagnosis.in_memory import diagnosed, optional
from .diagnosis.numerics.judge import judge
from .diagnosis.proposal.foretold import foretold
from .diagnosis.recording.recorded_run import RecordedRun
from .diagnosis.written import draw, write_block, write_seconds, write_words
from .ground.errors import BadInput, program
from .ground.files import write_text
from .ground.own_process import each_alone
from .run.description import STRING_ACTUATORS, Run
from .run.run_dir import real_name, refuse_twice
from .string.from_raw import read
from .string.history import in_order, read_recorded
from .string.jumps_beside import Beside, Reader, are_beside, jumps_into
from .string.not_compared import not_compared
from .string.rests import Rests

MODULES = tuple(f"{__package__}.diagnosis.{name}" for name in ("in_memory", "drawing.figures"))  # of each of many runs
ZEROS = "the zero of this string's runs"
OWN_ZERO = "This verdict does not depend on it: each run has a zero of its own in it."


@dataclass(frozen=True)
class Options:
    """How runs are diagnosed.

    `together`: several runs of one rig in one diagnosis. The library lacks the mechanisms in `without`; `judge_file`
    holds a judge in place of the library's. `rivals`: write `next_runs.json` too, every run that could be made next and
    what each explanation foretells of it. A program that read runs before gives a `reader`. The figure wears `mark`.
    """

    together: bool = False
    without: frozenset[str] = frozenset()
    judge_file: Path | None = None
    rivals: bool = False
    reader: Reader | None = None
    mark: str = ""


@dataclass(frozen=True)
class Decided:
    """A verdict on runs that is not written yet, and the runs' rests, none where they are of no string."""

    content: Verdict
    runs: list[Run]
    rests: list[Rests]
    folders: list[Path]
    out: Path

    @property
    def name(self) -> str:
        """The runs, as messages name them."""
        return "+".join(folder.name for folder in self.folders)

    @property
    def waits(self) -> bool:
        """Whether other runs beside these name their string, which may tell of a jump of the zero."""
        return bool(self.rests and optional(ZEROS, self.name, lambda: are_beside(self.rests)))

    def write(self, beside: Beside) -> str:
        """Write the verdict, with what the zero did between its runs and those beside them; return the words."""
        jumps = (optional(ZEROS, self.name, lambda: jumps_into(self.rests, beside)) if self.rests else None) or []
        if jumps:
            self.content["zero_jumps"] = [jump.entry for jump in jumps]
        for note in optional(ZEROS, self.name, lambda: not_compared(self.rests)) or []:
            print(f"{self.name}: {note} {OWN_ZERO}", file=sys.stderr)
        doubts = [f"{jump.advice} {OWN_ZERO}" for jump in jumps]
        return write_words(self.content, self.runs[0].system, self.folders, self.out, doubts)


def diagnose(folders: list[Path], out: Path, options: Options = Options(), beside: Beside | None = None) -> str:
    """Diagnose one run, or several of one rig together; write json, words and figures; return the words.

    A program that holds what was read of runs beside these gives `beside`, and they are not read again. Raises BadInput
    for runs that are none, or not of one rig.
    """
    decided = decide(folders, out, options)
    return decided.write(beside or Beside(decided.rests, options.reader or read))


def decide(folders: list[Path], out: Path, options: Options) -> Decided:
    """As `diagnose`; its json and words are not written yet, for they tell of the zeros of the runs beside too."""
    started, name = time.monotonic(), "+".join(folder.name for folder in folders)

    def say(step: str) -> None:
        print(f"{name}: {step} ({time.monotonic() - started:.1f} s)", file=sys.stderr, flush=True)

    say("reading")
    recordings = in_order([(options.reader or read)(folder) for folder in folders])
    runs, folders = [recorded.run for recorded in recordings], [recorded.folder for recorded in recordings]
    name = "+".join(folder.name for folder in folders)
    if len(runs) > 1:
        say(f"taken in the order in which they were recorded: {', '.join(run.run for run in runs)}")
    by = judge(options.judge_file) if options.judge_file else None
    recorded_runs = [RecordedRun(each.run, each.table, each.strokes, each.folder) for each in recordings]
    content, study = diagnosed(recorded_runs, options.without, by, say)
    if options.together:
        content["run"] = [run.run for run in runs]
    if options.rivals:
        fixed_load = bool((content["next_run"] or {}).get("fixed_load"))
        write_text(out / "next_runs.json", json.dumps(foretold(study, runs[0], fixed_load)) + "\n")
    optional("the page of figures", name, lambda: draw(study, content, out / "diagnosis", options.mark))
    write_block(content, runs[0].system, out)
    of_string = runs[0].actuator in STRING_ACTUATORS
    rests = optional(ZEROS, name, lambda: [Rests.of(recorded) for recorded in recordings]) if of_string else None
    return Decided(content, runs, rests or [], folders, out)


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
    reader = partial(read_recorded, processed=arguments.processed) if arguments.processed else None
    options = Options(arguments.together, frozenset(arguments.without), arguments.judge, False, reader, arguments.mark)
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
