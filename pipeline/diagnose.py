"""Diagnose runs: where simulation and recording part, which physics is missing, and what it improves."""

import argparse
import json
import os
import sys
import time
import traceback
from pathlib import Path
from typing import Any

from .diagnosis import library
from .diagnosis.adopt import adoptions, block
from .diagnosis.content import Verdict
from .diagnosis.foretold import foretold
from .diagnosis.in_memory import diagnosed, optional
from .diagnosis.judge import judge
from .diagnosis.outcome import Study
from .diagnosis.words.details import details_text
from .diagnosis.words.verdict import verdict_text
from .ground.alone import each_alone
from .ground.command import command
from .ground.errors import BadInput, program
from .ground.files import write_text
from .ground.outputs import folder_to_write
from .run.samples import read_samples
from .string.beside import jumps_into

MODULES = tuple(f"{__package__}.diagnosis.{name}" for name in ("whole", "figures"))  # of each of many runs
OWN_ZERO = "This verdict does not depend on it: each run has a zero of its own in it."


def diagnose(
    folders: list[Path],
    out: Path,
    together: bool = False,
    without: frozenset[str] = frozenset(),
    judge_file: Path | None = None,
    rivals: bool = False,
) -> str:
    """Diagnose one run, or several of one rig together; write json, words and figures; return the words.

    `rivals`: write `next_runs.json` too, every run that could be made next and what each explanation foretells of it.
    The library lacks the mechanisms in `without`; `judge_file` holds a judge in place of the library's. Raises BadInput
    for runs that are none, or not of one rig.
    """
    started = time.monotonic()
    name = "+".join(folder.name for folder in folders)

    def say(step: str) -> None:
        print(f"{name}: {step} ({time.monotonic() - started:.1f} s)", file=sys.stderr, flush=True)

    say("reading")
    pairs = [read_samples(folder) for folder in folders]
    runs, tables = [run for run, _ in pairs], [table for _, table in pairs]
    by = judge(judge_file) if judge_file else None
    content, study = diagnosed(runs, tables, folders, without, by, say)
    jumps = optional("the zero of this string's runs", name, lambda: jumps_into(folders, runs, tables)) or []
    if jumps:
        keys = ("before", "run", "jump_mm", "floor_mm")
        content["zero_jumps"] = [{key: getattr(jump, key) for key in keys} for jump in jumps]
    if together:
        content["run"] = [run.run for run in runs]
    if rivals:
        fixed_load = bool((content["next_run"] or {}).get("fixed_load"))
        write_text(out / "next_runs.json", json.dumps(foretold(study, runs[0], fixed_load)) + "\n")
    write_text(out / "diagnosis.json", json.dumps(content, indent=1, ensure_ascii=False) + "\n")
    optional("the page of figures", name, lambda: draw(study, content, out / "diagnosis"))
    write_block(content, out)
    doubts = [f"{jump.advice} {OWN_ZERO}" for jump in jumps]
    texts_from = (dict(content), runs[0].system, folders, out, doubts)
    words = verdict_text(*texts_from)
    write_text(out / "details.txt", details_text(*texts_from) + "\n")
    write_text(out / "verdict.txt", words + "\n")
    return words


def draw(study: Study, content: Verdict, path: Path) -> None:
    """Draw the page of figures; what draws takes 40 MB, and is imported when the search has let go of more."""
    study.search.linear.let_go()
    from .diagnosis import figures

    figures.page(study, content, path)


def write_block(content: Verdict, out: Path) -> None:
    """Write the `simulation` of a diagnosis that names something, ready to be pasted into run.yaml; else remove it."""
    path = out / "simulation.yaml"
    if content["mechanisms"] and content["simulation"]:
        write_text(
            path,
            block(content["simulation"])
            + block(adoptions(content, str(out / "diagnosis.json"), str(content["run"])), "adopted"),
        )
    else:
        path.unlink(missing_ok=True)  # of an earlier diagnosis


def _timed(folder: Path, *options: Any) -> tuple[str, bool | None, float]:
    """As `_one`, and the CPU seconds that it took of this process."""
    began_s = time.process_time()
    return *_one(folder, *options), time.process_time() - began_s


def _one(
    folder: Path, out: Path, without: frozenset[str], note: bool, by: Path | None = None
) -> tuple[str, bool | None]:
    """Words on one run, or its error, and whether that counts as done, None for a fault of ours.

    `note` writes a refusal where the words would be.
    """
    folder_out = out / Path(os.path.realpath(folder)).name
    try:
        return diagnose([folder], folder_out, without=without, judge_file=by), True
    except BadInput as error:
        if note:
            write_text(folder_out / "verdict.txt", f"{folder.name}: not decided: {error}\n")
        return f"error: {error}", note
    except Exception:  # a fault of ours in one run must not cost the others
        return f"error: {folder}: the diagnosis failed, please report it:\n{traceback.format_exc()}", None


def _names(folders: list[Path]) -> list[str]:
    """Runs, as the folders of their diagnoses are named."""
    return [Path(os.path.realpath(folder)).name for folder in folders]


def _write_seconds(path: Path | None, seconds: dict[str, float]) -> None:
    """Write what was asked for of CPU seconds."""
    if path is not None:
        write_text(path, json.dumps({run: round(taken, 2) for run, taken in seconds.items()}) + "\n")


@program
def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(prog=command("diagnose"), description=__doc__)
    parser.add_argument("run_dir", type=Path, nargs="+")
    parser.add_argument("--out", type=Path, required=True, help="the folder in which each run gets a folder; required")
    parser.add_argument("--together", action="store_true", help="several runs of one rig in one diagnosis")
    parser.add_argument("--jobs", type=int, default=1, help="runs at a time")
    parser.add_argument(
        "--without", action="append", default=[], metavar="ID", help="a mechanism that the library shall lack"
    )
    parser.add_argument(
        "--judge", type=Path, metavar="FILE", help="a judge taught otherwise, in place of the library's"
    )
    parser.add_argument(
        "--note-refusals", action="store_true", help="write why a run is refused as its verdict.txt, and exit with 0"
    )
    parser.add_argument(
        "--cpu-seconds",
        type=Path,
        metavar="FILE",
        help="write what each diagnosis took, starting apart, as JSON by run",
    )
    arguments = parser.parse_args()
    folder_to_write(arguments.out)
    folders: list[Path] = [folder if folder.name else folder.resolve() for folder in arguments.run_dir]
    without = frozenset(arguments.without)
    for id_ in sorted(without - set(library.mechanisms())):
        raise BadInput("arguments", "--without", f"{id_} is no mechanism", f"use {', '.join(library.mechanisms())}")
    options = (arguments.out, without, arguments.note_refusals, arguments.judge)
    if arguments.together:
        began_s = time.process_time()
        print(diagnose(folders, arguments.out, together=True, without=without, judge_file=arguments.judge))
        _write_seconds(arguments.cpu_seconds, {"+".join(_names(folders)): time.process_time() - began_s})
        return 0
    outcomes = each_alone(_timed, folders, *options, jobs=arguments.jobs, preload=MODULES)
    for text, fine, _ in outcomes:
        print(text, file=sys.stdout if fine else sys.stderr)
    taken_s = [seconds for *_, seconds in outcomes]
    _write_seconds(arguments.cpu_seconds, dict(zip(_names(folders), taken_s, strict=True)))
    return 1 if any(fine is None for _, fine, _ in outcomes) else 0 if all(fine for _, fine, _ in outcomes) else 2


if __name__ == "__main__":
    main()
