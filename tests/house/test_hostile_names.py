"""Every program that takes names or paths is given hostile ones: it refuses them in words and touches nothing else."""

import argparse
import importlib
import os
import re
import shutil
import sys
from pathlib import Path

import pytest

from pipeline.ground.errors import program as command

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
    actions = [one for one in parser_of(main, monkeypatch)._actions if one.dest != "help"]
    asked = [one for one in actions if one.type in (None, Path) and one.nargs != 0 and not one.choices]
    device = os.stat("/dev/full")
    for action in asked:
        for value in HOSTILE:
            needed = [one for one in actions if one is not action and (one.required or not one.option_strings)]
            line = [word for one in needed if one.nargs != "?" for word in words(one, harmless(one))]
            monkeypatch.setattr(sys, "argv", [program, *line, *words(action, value)])
            with pytest.raises(SystemExit) as end:
                command(main)()
            said = capsys.readouterr().err
            status = end.value.code
            assert status in (0, 2), (action.dest, value, said)
            if action.type is Path:  # which may lead there
                remove(tmp_path / "x")
            assert not (tmp_path / "x").exists(), (action.dest, value)
            assert status == 0 or "error: " in said, (action.dest, value, said)
    assert not list(tmp_path.rglob("PWNED")) and (home / "file").read_text() == "kept"
    assert os.stat("/dev/full").st_rdev == device.st_rdev
