"""Run folders → a diagnosis of them in a folder: what programs write and say, without a command line."""

import json
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from ..diagnosis.document.content import Verdict
from ..diagnosis.in_memory import optional
from ..diagnosis.numerics.judge import judge
from ..diagnosis.proposal.foretold import foretold
from ..diagnosis.words.language.vocabulary import Vocabulary
from ..diagnosis.words.measured.run_zeros import fitted
from ..diagnosis.written import draw, write_block, write_words
from ..ground.stored.files import write_text
from ..run.description import STRING_ACTUATORS, Run
from ..string.from_raw import read
from ..string.history import Recorded, in_order
from ..string.jumps_beside import Beside, Reader, are_beside, jumps_into
from ..string.not_compared import not_compared
from ..string.rests import Rests
from .diagnosis import diagnosis_of, study_of

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
    reader: Reader = read
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
        if entries := [jump.entry for jump in jumps if not jump.checked]:
            self.content["zero_jumps"] = entries
        for note in optional(ZEROS, self.name, lambda: not_compared(self.rests)) or []:
            print(f"{self.name}: {note} {OWN_ZERO}", file=sys.stderr)
        words = Vocabulary.of(self.runs[0].system)
        doubts = [
            " ".join(filter(None, (jump.in_short, fitted(self.content, jump.before, jump.run, words), OWN_ZERO)))
            for jump in jumps
        ]
        return write_words(self.content, self.runs[0].system, self.folders, self.out, doubts)


def once_read() -> Callable[[Path], Recorded]:
    """A reader that reads each run once, however often it is asked for; raises BadInput as reading does."""
    return cache(read)


def diagnose(folders: list[Path], out: Path, options: Options = Options(), beside: Beside | None = None) -> str:
    """Diagnose one run, or several of one rig together; write json, words and figures; return the words.

    A program that holds what was read of runs beside these gives `beside`, and they are not read again. Raises BadInput
    for runs that are none, or not of one rig.
    """
    decided = decide(folders, out, options)
    return decided.write(beside or Beside(decided.rests, options.reader))


def decide(folders: list[Path], out: Path, options: Options) -> Decided:
    """As `diagnose`; its json and words are not written yet, for they tell of the zeros of the runs beside too."""
    started, name = time.monotonic(), "+".join(folder.name for folder in folders)

    def say(step: str) -> None:
        print(f"{name}: {step} ({time.monotonic() - started:.1f} s)", file=sys.stderr, flush=True)

    say("reading")
    recorded_runs = in_order([options.reader(folder) for folder in folders])
    runs, folders = [recorded.run for recorded in recorded_runs], [recorded.folder for recorded in recorded_runs]
    name = "+".join(folder.name for folder in folders)
    if len(runs) > 1:
        say(f"taken in the order in which they were recorded: {', '.join(run.run for run in runs)}")
    by = judge(options.judge_file) if options.judge_file else None
    diagnosis = diagnosis_of(recorded_runs, options.without, by, say)
    content = diagnosis.content
    if options.together:
        content["run"] = [run.run for run in runs]
    if options.rivals:
        fixed_load = bool((content["next_run"] or {}).get("fixed_load"))
        write_text(out / "next_runs.json", json.dumps(foretold(study_of(diagnosis), runs[0], fixed_load)) + "\n")
    optional("the page of figures", name, lambda: draw(study_of(diagnosis), content, out / "diagnosis", options.mark))
    write_block(content, runs[0].system, out)
    of_string = runs[0].actuator in STRING_ACTUATORS
    rests = optional(ZEROS, name, lambda: [Rests.of(recorded) for recorded in recorded_runs]) if of_string else None
    return Decided(content, runs, rests or [], folders, out)
