"""The ready lines that make a proposed run: its folder, its recording, and its diagnosis together with the old one."""

import shlex
from pathlib import Path

from ...ground.command import command

DIAGNOSE = command("diagnose")
CAPTURE = (
    "PORT is the rig's; --text where it prints lines of numbers. With a file of your own logger give new_run "
    "--recording FILE instead, and leave the capture line out."
)


def lines(folders: list[Path], out: Path | None, loads: list[str]) -> list[str]:
    """The commands for one new run beside the last of `folders` for each of `loads`, then that of the diagnosis.

    A load is that of `--load-n`, empty where it stays. `out` is the folder of the diagnosis that proposes the run.
    """
    old = folders[-1]
    endings = [f"-{number}" for number in range(1, len(loads) + 1)] if len(loads) > 1 else [""]
    new = [old.with_name(f"{old.name}-next{ending}") for ending in endings]
    made = []
    for folder, load in zip(new, loads, strict=True):
        other = f" --load-n {load}" if load else ""
        made.append(f"{command('new_run')} {shlex.quote(folder.name)} --like {shlex.quote(str(old))}{other}")
        made.append(f"{command('capture')} PORT {shlex.quote(str(folder))}")
    where = shlex.quote(str(out.with_name(f"{out.name}-next"))) if out else "DIR"
    named = " ".join(shlex.quote(str(folder)) for folder in (*folders, *new))
    return [*made, f"{DIAGNOSE} {named} --together --out {where}"]


def block(commands: list[str], old: str, twisted: bool) -> list[str]:
    """The commands as a verdict shows them, with what they take from the run `old` and what to fill in."""
    taken = f"--like takes the dimensions{' and the string id' if twisted else ''} from {old}"
    return [f"The commands, in this order; {taken}:", *(f"  {line}" for line in commands), CAPTURE]
