"""Snakemake's locks: a killed Snakemake's are removed, a live one's stay, and so do those of which nothing is known."""

import os
from pathlib import Path

from launcher.processes import Running, running
from launcher.words import say

LOCKS = Path(".snakemake/locks")


def is_snakemake(words: list[bytes]) -> bool:
    """Whether a command runs Snakemake: as a program, as a script of a Python, or behind `-m`."""
    return any(os.path.basename(word) in (b"snakemake", b"snakemake.exe") for word in words[:8])


def is_stale(owner: int, seen: Running | None) -> bool:
    """Whether no Snakemake of a lock's owner can be at work in this folder."""
    if seen is None or not (seen.complete or owner == os.geteuid()):
        return False
    for process in seen.processes:
        if process.user == owner and process.id not in seen.line and is_snakemake(process.words):
            try:
                if process.folder is None or os.path.samefile(process.folder, "."):
                    return False
            except FileNotFoundError:
                continue  # it ended meanwhile
            except OSError:
                return False
    return True


def at_work(seen: Running | None) -> int | None:
    """A Snakemake that is known to be at work in this folder: the id of its process."""
    if seen is None:
        return None
    for process in seen.processes:
        if process.id not in seen.line and is_snakemake(process.words) and process.folder is not None:
            try:
                if os.path.samefile(process.folder, "."):
                    return process.id
            except OSError:
                continue
    return None


def clear_stale_locks() -> None:
    """Remove the locks that a killed Snakemake left in this folder, and say so, or what to do about those that stay."""
    try:
        locks = {path: path.stat().st_uid for path in LOCKS.glob("*")}
    except OSError as error:
        say(f"{LOCKS}: cannot be read ({error.strerror})")
        return
    if not locks:
        return
    seen = running()
    stale = {owner: is_stale(owner, seen) for owner in set(locks.values())}
    stay = []
    for path, owner in locks.items():
        try:
            if stale[owner]:
                path.unlink(missing_ok=True)
            else:
                stay.append(path)
        except OSError:
            stay.append(path)
    number = at_work(seen)
    if stay and number is not None:
        say(f"a main job runs in this folder already (process {number}): wait until it has ended")
    elif stay:
        say(
            f"{LOCKS}: a Snakemake may be at work in this folder, so its locks stay; "
            "when none is, on any machine: snakemake --unlock"
        )
    else:
        say("the main job before was killed: its locks are removed, and what it had not finished is made now")
