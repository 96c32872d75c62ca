"""Every program that takes names or paths is given hostile ones: it refuses them in words and touches nothing else.

Of most programs another argument is refused first. `LINES` has whole command lines, of which one word is spoilt.
"""

import argparse
import contextlib
import hashlib
import importlib
import json
import os
import re
import resource
import shlex
import shutil
import signal
import sys
import zipfile
from pathlib import Path

import pytest
from hostile import ended
from made_recording import content, recording
from models.made_dataset import made_dataset

from pipeline.capture import port
from pipeline.ground.errors import program as command
from pipeline.ground.stored import schemas
from pipeline.pack.manifest import NAME, File, Manifest

ROOT = Path(__file__).parents[2]
PROGRAMS = sorted(
    ".".join(path.relative_to(ROOT).with_suffix("").parts)
    for path in (ROOT / "pipeline").rglob("*.py")
    if re.search(r'^if __name__ == "__main__":', path.read_text(encoding="utf-8"), re.M)
    and path.relative_to(ROOT).parts[1] not in ("rig", "proof")  # which make what they are told from nothing
)
HOSTILE = ["", "../../x", "$(touch PWNED)", "a\nb", "<img src=x>", "x" * 300, "loop", "folder", "pipe", "file/below"]
HOSTILE += ["/dev/full"]


class Stopped(Exception):
    """The parser of a program, caught as it begins to read the command line."""


def parser_of(main, monkeypatch):
    """The parser that a program reads its command line with."""

    def stop(parser, *_, **__):
        raise Stopped(parser)

    with monkeypatch.context() as patch:
        patch.setattr(argparse.ArgumentParser, "parse_args", stop)
        with pytest.raises(Stopped) as caught:
            main()
    return caught.value.args[0]


def words(action, value):
    """What stands on the command line for an option with a value, or without one."""
    if action.nargs == 0:
        return []
    count = action.nargs if isinstance(action.nargs, int) else 1
    return [action.option_strings[0], *[value] * count] if action.option_strings else [value] * count


def remove(path):
    """Take away a file, or a folder with all that is in it."""
    if path.is_dir():
        shutil.rmtree(path)
    path.unlink(missing_ok=True)


def harmless(action):
    """A value that an option takes."""
    if action.choices:
        return str(next(iter(action.choices)))
    return "1" if action.type in (int, float) else "nowhere"


@pytest.mark.parametrize("program", PROGRAMS)
def test_hostile_names_and_paths_are_refused_in_words(program, tmp_path, monkeypatch, capsys):
    home = tmp_path / "at" / "work"
    (home / "folder").mkdir(parents=True)
    (home / "file").write_text("kept")
    (home / "loop").symlink_to("loop")
    os.mkfifo(home / "pipe")
    monkeypatch.chdir(home)
    main = importlib.import_module(program).main
    monkeypatch.setattr(sys, "argv", [program])
    actions = [option for option in parser_of(main, monkeypatch)._actions if option.dest != "help"]
    free_options = [
        option for option in actions if option.type in (None, Path) and option.nargs != 0 and not option.choices
    ]
    device = os.stat("/dev/full")
    for action in free_options:
        for value in HOSTILE:
            needed = [
                option for option in actions if option is not action and (option.required or not option.option_strings)
            ]
            line = [word for option in needed if option.nargs != "?" for word in words(option, harmless(option))]
            monkeypatch.setattr(sys, "argv", [program, *line, *words(action, value)])
            with pytest.raises(SystemExit) as end:
                command(main)()
            complaint = capsys.readouterr().err
            status = end.value.code
            assert status in (0, 2), (action.dest, value, complaint)
            if action.type is Path:  # which may lead there
                remove(tmp_path / "x")
            assert not (tmp_path / "x").exists(), (action.dest, value)
            assert status == 0 or "error: " in complaint, (action.dest, value, complaint)
    assert not list(tmp_path.rglob("PWNED")) and (home / "file").read_text() == "kept"
    assert os.stat("/dev/full").st_rdev == device.st_rdev


LINES = {  # command lines whose every word is read, with what they end in: 0, or the word of a refusal that comes last
    "new_run": [
        (
            "b-1 --material m --radius-mm 0.4 --length-mm 400 --torsion-zone-mm 150 --separator-mm 8 --string-id s "
            "--channels '{load_n: load_n}' --file '{skip: 0}' --tolerance '{radius: 0.1}' --recording log.csv "
            "--out out/raw",
            0,
        ),
        ("b-1 --like raw/a-3 --recording log.csv --tare run --out out/raw", 0),
    ],
    "import_run": [
        ("log.csv --map map.yaml --run b-1 --string-id s --out out/raw", 0),
        ("logs --map map.yaml --run b-1 --files *.csv --out out/raw", 0),
        ("log.csv --guess --actuator separator --out out/map.yaml", 0),
    ],
    "capture.__main__": [
        ("log.csv raw/b-1 --program legs.json --baud 9600 --longest 1", "is it a serial port"),
        ("log.csv raw/b-1 --text --columns time_s,motor_turns --wait 1", "is it a serial port"),
        ("--recover raw/a-1", "run that was being captured"),
    ],
    "settle.__main__": [("raw/a-1 --port log.csv --limits '{turns: [0, 30], turns_per_s: 9}' --out out/s", "stroke")],
    "pack.unpack": [("all.zip", 0)],
    "simulate": [
        ("raw/a-3 --simulation simulation.json --motion plan.csv --out out/s.csv", 0),
        ("raw/a-3 --simulation simulation.json --out out/s.parquet", 0),
    ],
    "dataset": [("raw/a-3 raw/a-1 --out out/d", 0)],
    "fit_model": [("polynomial points.parquet --settings {} --seed 0 --out out/m", 0)],
    "predict": [("dataset.parquet questions.csv --model polynomial --settings {} --level 0.9 --out out/a.csv", 0)],
}
DEEP = "deep/" * 500
LONGEST_S, MOST_BYTES = 60, 3 << 30  # of a command: one that reads a pipe or /dev/full comes to no end
QUICK = ("", "../../x", "loop", "pipe", "folder", "/dev/full", DEEP)


class Endless(BaseException):
    """A command was still at work after the longest time."""


@contextlib.contextmanager
def bounded():
    """A time and a memory that no command needs; who goes beyond them fails."""

    def end(*_):
        raise Endless

    before, limits = signal.signal(signal.SIGALRM, end), resource.getrlimit(resource.RLIMIT_AS)
    pages = int(Path("/proc/self/statm").read_text().split()[0])
    resource.setrlimit(resource.RLIMIT_AS, (pages * resource.getpagesize() + MOST_BYTES, limits[1]))
    signal.setitimer(signal.ITIMER_REAL, LONGEST_S)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        resource.setrlimit(resource.RLIMIT_AS, limits)
        signal.signal(signal.SIGALRM, before)


def archive(path):
    """An archive of one file of a material."""
    inside = b"a table"
    table = File(len(inside), hashlib.sha256(inside).hexdigest(), 1)
    manifest = Manifest("0", "0", {"nylon": ["nylon-1"]}, [], {"reports/nylon/table.csv": table})
    with zipfile.ZipFile(path, "w") as zipped:
        zipped.writestr(NAME, manifest.to_json())
        zipped.writestr("reports/nylon/table.csv", inside)


@pytest.fixture
def work(tmp_path):
    """A folder in a folder, with what the command lines read, and with hostile files."""
    home = tmp_path / "at" / "work"
    for name, strokes in (("a-1", 1), ("a-3", 3)):
        (home / "raw" / name).mkdir(parents=True)
        (home / "raw" / name / "run.yaml").write_text(json.dumps(content(name)))
        recording(strokes, rate_hz=10.0).to_parquet(home / "raw" / name / "recording.parquet", index=False)
    for folder in ("folder", "logs"):
        (home / folder).mkdir()
    for path in ("log.csv", "logs/one.csv"):
        recording(3, rate_hz=10.0).to_csv(home / path, index=False)
    (home / "map.yaml").write_text(json.dumps({key: each for key, each in content("m").items() if key != "run"}))
    (home / "legs.json").write_text('[{"seconds": 5, "motor_turns": 10}, {"seconds": 5, "motor_turns": 0}]')
    (home / "simulation.json").write_text('{"run": "a-3", "parameters": {}, "simulation": []}')
    (home / "plan.csv").write_text("time_s,motor_turns,load_n\n0,0,20\n5,10,20\n10,0,20\n")
    (home / "questions.csv").write_text("stroke,direction,motor_turns\n1,1,3\n")
    schemas.write(made_dataset(40, 5), schemas.DATASET, home / "dataset.parquet")
    schemas.write(made_dataset(40, 5).assign(later=""), schemas.DATASET, home / "points.parquet")
    (home / "Snakefile").write_text("")
    archive(home / "all.zip")
    (home / "file").write_text("kept")
    (home / "loop").symlink_to("loop")
    os.mkfifo(home / "pipe")
    return home


def remove_new(folder, before):
    """Take away what a command made."""
    for path in sorted(folder.rglob("*"), reverse=True):
        if path not in before:
            path.rmdir() if path.is_dir() and not path.is_symlink() else path.unlink()


def of_files(folder):
    """The content of each file below a folder."""
    return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize(
    "values", [pytest.param(QUICK, id="quick"), pytest.param((*HOSTILE, DEEP), id="all", marks=pytest.mark.long)]
)
@pytest.mark.parametrize(("program", "line", "ends"), [(name, *line) for name in LINES for line in LINES[name]])
def test_each_word_of_a_command_line_is_spoilt_in_turn_and_refused_in_words(
    program, line, ends, values, work, monkeypatch
):
    monkeypatch.setattr(port.Port.__init__, "__defaults__", (0.0,))  # capture waits 10 s for a port that is not there
    above, kept = {*work.parents[1].rglob("*")}, of_files(work)
    good = shlex.split(line)
    status, complaint = ended(f"pipeline.{program}", good, work)
    assert (status, complaint.count("error: ")) == (0, 0) if ends == 0 else status == 2 and ends in complaint, complaint
    for at, word in enumerate(good):
        for value in values if not word.startswith("--") else ():
            remove_new(work.parents[1], above)
            words = [*good[:at], value, *good[at + 1 :]]
            try:
                with bounded():
                    status, complaint = ended(f"pipeline.{program}", words, work)
            except BaseException as error:
                raise AssertionError(f"{program} {words}"[:500]) from error
            assert status in (0, 2) and "Traceback" not in complaint, (words, complaint[:2000])
            assert status == 0 or ("error: " in complaint and len(complaint) < 2000), (
                words,
                len(complaint),
                complaint[:2000],
            )
            assert {path: path.read_bytes() for path in kept} == kept, words
    assert not list(work.rglob("PWNED")) and (work / "pipe").is_fifo() and Path("/dev/full").is_char_device()
