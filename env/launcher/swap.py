"""The swap of an environment, and the removal of those that nobody uses any more."""

import os
import secrets
import shutil
from pathlib import Path

from launcher import locking, stamp
from launcher.places import ENV, HELD, LINK, LOCK, ONE_AT_A_TIME, environments
from launcher.processes import names, running
from launcher.words import say

UNKNOWN = (
    "older environments stay, as this system does not tell whether they are used; when no job runs, delete in env/: {}"
)


def swap(place: Path) -> None:
    """Let `env/.venv` name an environment, unless it names one of this lock or a job runs by that name."""
    named = Path(os.path.realpath(LINK))
    if named == place or (is_another_pythons(named) and not is_moved(named)):
        return
    if os.path.lexists(LINK):
        seen = running()
        users = [process.id for process in seen.processes if names(process, LINK)] if seen else []
        if users or (seen is None and LINK.exists()):
            say(f"env/.venv names the environment from before until nothing runs by that name (process {users or '?'})")
            return
    temporary = ENV / f".venv-link-{secrets.token_hex(3)}"
    os.symlink(os.path.relpath(place, ENV), temporary)
    if LINK.is_dir() and not LINK.is_symlink():  # as the launcher made it once
        LINK.rename(ENV / f".venv-before-{secrets.token_hex(3)}")
    os.replace(temporary, LINK)


def is_another_pythons(place: Path) -> bool:
    """Whether an environment is of this lock too, and made by another kind of Python."""
    content = stamp.read(place)
    if content is None or content["lock"] != stamp.lock_sum(LOCK):
        return False
    return content["python"] != stamp.python_tag() and stamp.stands(place, content)


def is_moved(place: Path) -> bool:
    """Whether an environment was made elsewhere than where it lies."""
    content = stamp.read(place)
    return content is None or content["place"] != str(place)


def out_of_date(place: Path) -> list[Path]:
    """Environments beside `place` that no launcher would choose, and remains of killed attempts and swaps."""
    kept = (place, Path(os.path.realpath(LINK)))
    return [
        path for path in ENV.glob(".venv-*") if path not in kept and (path.is_symlink() or not is_another_pythons(path))
    ]


def tidy(place: Path) -> None:
    """Remove what is out of date and used by nobody, unless another launcher is at work."""
    old = out_of_date(place)
    if not old:
        return
    try:
        turn = locking.exclusive(ONE_AT_A_TIME, wait=False)
    except BlockingIOError:
        return
    if turn is None:
        return say(UNKNOWN.format(", ".join(path.name for path in old)))
    seen = running()
    try:
        if seen is None:
            return say(UNKNOWN.format(", ".join(path.name for path in old)))
        for path in old:
            if path.is_symlink():
                path.unlink(missing_ok=True)
            elif not any(names(process, path) for process in seen.processes):
                remove(path)
    finally:
        os.close(turn)


def clear_remains() -> None:
    """Remove what killed attempts left; their disk is needed."""
    remains = [path for path in environments() if not (path / stamp.STAMP).exists()]
    seen = running() if remains else None
    for path in remains:
        if seen and not any(names(process, path) for process in seen.processes):
            remove(path)


def remove(place: Path) -> None:
    """Delete an environment that no launcher's command holds, its stamp first."""
    held = None
    try:
        if (place / HELD).exists():
            held = locking.exclusive(place / HELD, wait=False, create=False)
    except BlockingIOError:
        return
    (place / stamp.STAMP).unlink(missing_ok=True)
    shutil.rmtree(place, ignore_errors=True)
    if held is not None:
        os.close(held)
