"""The last words of a main job that did not make everything: failed jobs and left-out runs, with reasons and mends."""

from collections.abc import Collection, Iterable, Sequence
from pathlib import Path

from ...ground.words.counts import counted
from ...ground.words.left_out import LeftOut

ALL_ELSE = "All else that was asked for is made. What is to be mended:"
FAILS = "Until then the main job ends as failed. Nothing else went wrong, whatever Snakemake says below."
EVERYTHING = "reports/index.html"  # the page of all materials
ENDS_OPTIONS = "--"  # of a command line
LAST = "left_out"  # the rule that fails where a run was left out, after everything else
ELSE = "What other runs need is made with --keep-going."
STOPPED = "Stopped by Ctrl-C. What is made is kept: the same command goes on from there."


def reasons(log: Path) -> list[str]:
    """Why a job failed, from its log: the runs that it left out, and its last error, or else the log's last line."""
    try:
        lines = [line.strip() for line in log.read_text(encoding="utf-8", errors="replace").splitlines()]
    except OSError:
        return ["it wrote no log: see what is printed above"]
    errors = [line.removeprefix("error: ") for line in lines if line.startswith("error: ")]
    left_out = [line for line in lines if line.startswith("left out: ")]
    return left_out + (errors[-1:] or [next((line for line in reversed(lines) if line), "it said nothing")])


def concerned(left_out: Iterable[LeftOut], asked_files: Collection[str]) -> list[LeftOut]:
    """The left-out runs that belong to the files asked for: to their materials and runs, or to no known material.

    All, where everything was asked for.
    """
    folders = {part for file in asked_files for part in Path(file).parts[:-1]}
    return [
        entry
        for entry in left_out
        if EVERYTHING in asked_files or not entry.material or {entry.material, entry.run} & folders
    ]


def told_at_start(left_out: Sequence[LeftOut], words: Sequence[str]) -> list[str]:
    """What a start says of what was left out, by the words of its command line; what was not asked for is counted.

    What stands behind `--` is asked for. All is named where that is nothing, or more than files of materials and runs.
    """
    targets = list(words[words.index(ENDS_OPTIONS) + 1 :]) if ENDS_OPTIONS in words else []
    is_of_some = bool(targets) and all(len(Path(target).parts) > 2 for target in targets)
    named = concerned(left_out, [f"{target}/part" for target in targets]) if is_of_some else left_out
    lines = [f"left out: {entry.why}" for entry in named]
    others = len(left_out) - len(named)
    if others:
        lines.append(f"left out beside what is asked for: {counted(others, 'run')}; a start without targets names each")
    return lines


def without(left_out: Iterable[str]) -> str:
    """The last lines of a main job that made everything else: each left-out run with its reason."""
    lines = [f"left out: {why}" for why in dict.fromkeys(left_out)]
    return "\n".join([ALL_ELSE, *lines]) if lines else ""


def told(failed: Iterable[tuple[str, str]], left_out: Iterable[str], keep_going: bool) -> str:
    """The last lines on failed jobs, each a name and a log, and on left-out runs, each a reason.

    A reason is said once. That other runs could still be made is said where the command line did not ask for it.
    """
    reasons_out, jobs = list(dict.fromkeys(left_out)), sorted(failed)
    text = [f"left out: {why}" for why in reasons_out]
    for name, log in jobs:
        for reason in reasons(Path(log)):
            if reason.removeprefix("left out: ") not in reasons_out:
                reasons_out.append(reason.removeprefix("left out: "))
                text.append(reason if reason.startswith("left out: ") else f"failed: {name}: {reason} Its log: {log}")
    if [name for name, _ in jobs] == [LAST] and not any(line.startswith("failed: ") for line in text):
        return f"{without(reasons_out)}\n{FAILS}"
    head = "Not all was made:" if text else "Not all was made: see the errors above."
    return "\n".join([head, *text, *([] if keep_going else [ELSE])])
