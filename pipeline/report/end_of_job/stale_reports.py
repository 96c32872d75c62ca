"""Stale reports: those of runs that are gone are removed, and after a failure no page shows an old state as new."""

import os
import shlex
import shutil
import subprocess
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from ...ground.input.words_by_file import by_file, spread
from ...ground.words.left_out import LeftOut, from_json, to_json

WORDS = Path(".snakemake/words")
ALL = "all of "  # before a material's name, where a whole material is left out


def remove_stale(noted: Iterable[str], wanted: Iterable[str]) -> list[str]:
    """Remove earlier reports that no run asks for any more; returns their paths.

    Touched is only what lies in `reports/` and was noted; a folder goes with it once it is empty.
    """
    gone = []
    for name in sorted(set(noted) - set(wanted)):
        path = Path(name)
        if path.parts[:1] != ("reports",) or ".." in path.parts or len(path.parts) < 3 or not os.path.lexists(path):
            continue
        if path.is_dir() and not path.is_symlink():
            shutil.rmtree(path)
        else:
            path.unlink()
        gone.append(name)
        if len(path.parts) > 2 and path.parent.name != "diagnosis" and not os.listdir(path.parent):
            path.parent.rmdir()
    return gone


def unmade(materials: Iterable[str], runs: Iterable[str], missing: set[str]) -> list[LeftOut]:
    """Materials and runs with files that this start should have made, but could not."""
    notes = []
    for material in materials:
        if any(path.startswith((f"reports/{material}/", f"processed/{material}/")) for path in missing):
            problem = "could not be made anew: what is shown of it, if anything, is of an earlier state"
            mend = "see the errors that the command printed, and run it again"
            notes.append(LeftOut(f"{ALL}{material}", material, f"reports/{material}", "tables", problem, mend))
    for run in runs:
        if f"reports/diagnosis/{run}" in missing:
            mend = f"see processed/logs/diagnose-{run}.log, and run it again"
            notes.append(LeftOut(run, "", f"reports/diagnosis/{run}", "diagnosis", "could not be made", mend))
    return notes


def without(command: str, all_left_out: list[LeftOut], names: Iterable[str]) -> list[str]:
    """The words of a rule's command without the left-out materials and runs; these go into an option of it.

    A material of which all reports, by their `names`, are still there stays on a page that says how old they are.
    """
    words = spread(shlex.split(command.partition(" > ")[0])[1:])
    start, names = words.index("-m") + 2, list(names)
    gone = {left_out.run for left_out in all_left_out if not left_out.run.startswith(ALL)}
    for material in (left_out.material for left_out in all_left_out if left_out.run.startswith(ALL)):
        all_there = all(Path("reports", material, name).is_file() for name in names)
        if not (all_there and "--planned" in words):
            gone.add(material)

    def stays(word: str) -> bool:
        path = Path(word)
        return word not in gone and not (len(path.parts) > 2 and (path.parts[1] in gone or path.parts[2] in gone))

    words = words[:start] + [word for word in words[start:] if stays(word)]
    if "--planned" in words:
        at = words.index("--planned") + 1
        words[at] = to_json(from_json(words[at]) + all_left_out)
    return words


def rewrite(commands: Iterable[str], all_left_out: list[LeftOut], names: Iterable[str], project: str) -> list[str]:
    """Run the commands of the last pages without the parts that could not be made; returns the errors."""
    wrong = []
    environment = {**os.environ, "PYTHONPATH": project}
    for command in commands:
        words = without(command, all_left_out, names)
        with suppress(ValueError):  # more words than a command may have
            words = [*words[:3], by_file(words[3:], WORDS)]
        done = subprocess.run(words, env=environment, capture_output=True, text=True, errors="replace")
        if done.returncode:
            wrong.append(f"{words[2]}: {(done.stderr.strip().splitlines() or ['failed'])[-1]}")
    return wrong
