"""A loop on a synthetic rig whose tie one run can decide: friction or backlash, told apart by the load alone."""

import json
import shutil
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import once
import pytest
import yaml
from ready import Program, start

ROOT = Path(__file__).resolve().parents[2]
LIMITS = "{turns: [0, 21], turns_per_s: 9, load_n: [8, 45], seconds: 300}"
PROGRAMS = ("pipeline.new_run", *(f"pipeline.{program}.__main__" for program in ("capture", "rig", "settle")))
IMPORTS = (*PROGRAMS, "settle.undrawn")
SIZES = {"radius-mm": 0.4, "length-mm": 400, "stiffness-n-per-mm": 15, "torsion-zone-mm": 150, "separator-mm": 8}


def set_up(folder: Path) -> None:
    """A set-up with a poor motion, equal strokes under one load, and concealed friction."""
    content = yaml.safe_load((ROOT / "pipeline" / "rig" / "setups" / "small.yaml").read_text())
    stroke = {"repeat": 8, "top_turns": 20, "speed_turns_per_s": 4, "speed_up_s": 0.2, "slow_down_s": 0.2}
    content["motion"] = {"rest_s": 3, "strokes": [stroke | {"hold_s": 0.2, "rest_s": 0.2, "load_n": 20}]}
    content["effects"] = {"friction_hysteresis": {"turns_per_n": 0.01, "reach_turns": 0.2}}
    (folder / "rig.yaml").write_text(yaml.safe_dump(content))


@contextmanager
def rig(place: Path, *options: object) -> Iterator[str]:
    """A standing rig at the link `port` in a folder."""
    at_work = program(place, "rig", "rig.yaml", "--link", "port", "--standing", *options)
    try:
        while not (place / "port").is_symlink():
            assert at_work.poll() is None, at_work.communicate()[0]
            time.sleep(0.01)
        yield "port"
    finally:
        at_work.terminate()
        at_work.communicate()


def program(place: Path, module: str, *words: object) -> Program:
    """A program of ours in a folder, without a terminal and not waited for."""
    return start(f"pipeline.{module}", *words, cwd=place, imports=IMPORTS)


def ended(place: Path, module: str, *words: object) -> subprocess.CompletedProcess:
    """The same program at its end, with what it said."""
    process = program(place, module, *words)
    printed = process.communicate(timeout=400)[0]
    return subprocess.CompletedProcess(process.args, process.returncode, printed)


def described(place: Path) -> None:
    """The folder of the poor run, without a recording."""
    sizes = [word for name, value in SIZES.items() for word in (f"--{name}", value)]
    done = ended(place, "new_run", "poor-1", "--material", "example", *sizes, "--string-id", "poor-1", "--out", "raw")
    assert done.returncode == 0, done.stdout


def begun(place: Path) -> str:
    """Record the poor run, and ask for the loop without a terminal; what was said."""
    set_up(place)
    described(place)
    with rig(place, "--pace", "inf") as port:
        captured = ended(place, "capture", port, "raw/poor-1")
        assert captured.returncode == 0, captured.stdout
        loop = ended(place, "settle", "raw/poor-1", "--port", port, "--out", "out")
    assert loop.returncode == 2, loop.stdout
    return loop.stdout


def begun_once(factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """A loop whose first step is proposed, one for all tests, which leave it as it is; and what was said."""
    shared = once.place(factory)

    def make() -> tuple[Path, str]:
        (shared / "begun").mkdir()
        return shared / "begun", begun(shared / "begun")

    return once.made_once(shared, "a loop that has begun", make)


def copied(begun_at: Path, place: Path) -> Path:
    """A loop that stands where another one does."""
    shutil.copytree(begun_at, place, symlinks=True)
    return place


def state(place: Path, number: int = 1) -> dict:
    """State of a step."""
    return json.loads((place / "out" / f"step-{number}" / "state.json").read_text())


def settled(place: Path) -> dict:
    """How the loop ended."""
    return json.loads((place / "out" / "settled.json").read_text())


def auto(place: Path, *words: object, limits: str = LIMITS) -> subprocess.CompletedProcess:
    """The loop, unattended."""
    fixed = ("raw/poor-1", "--port", "port", "--out", "out", "--approve", "auto", "--limits", limits)
    return ended(place, "settle", *fixed, *words)


def started(place: Path, *words: object) -> Program:
    """The loop, unattended and not waited for."""
    fixed = ["raw/poor-1", "--port", "port", "--out", "out", "--approve", "auto", "--limits", LIMITS]
    return program(place, "settle", *fixed, *words)


def until(process: Program, path: Path, least: int = 1) -> None:
    """Wait until a file has so many bytes."""
    while not path.is_file() or path.stat().st_size < least:
        assert process.poll() is None, process.stdout.read() if process.stdout else ""
        time.sleep(0.01)
