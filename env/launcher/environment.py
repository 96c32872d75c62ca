"""The environment: found whole, or built beside, verified and then swapped in.

Each attempt builds in a folder of its own, `env/.venv-<python>-<lock>-<chance>`, and stamps it when it is whole.
Nothing is ever installed into a folder that somebody uses. `env/.venv` is a link to the one that people mean.
Commands run in the folder itself, so that a swap leaves a running job what it started with.
"""

import os
import secrets
import shutil
import sys
from pathlib import Path

from launcher import locking, moved, records, stamp
from launcher.install import Installer, finish_activation
from launcher.processes import names, running
from launcher.words import say

ENV = Path(__file__).resolve().parents[1]
LINK, LOCK, PROFILE, ONE_AT_A_TIME = (
    ENV / ".venv",
    ENV / "requirements.lock",
    ENV / "profile",
    ENV / ".venv.lock",
)
HELD = "pyvenv.cfg"  # the file that a command holds as long as it works in an environment


def places() -> list[Path]:
    """The folders that may be the environment, what `env/.venv` names first."""
    named = Path(os.path.realpath(LINK))
    beside = [path for path in sorted(ENV.glob(".venv-*")) if path.is_dir() and not path.is_symlink()]
    return [named, *(path for path in beside if path != named)]


def usable(mending: bool = False) -> Path | None:
    """An environment of this lock and this Python that is whole where it lies; `mending` fits a moved one."""
    for place in places():
        content = stamp.read(place)
        if content is None or not stamp.is_of(content, LOCK) or not stamp.stands(place, content):
            continue
        fault = records.shrunk(place, content["outline"])
        if fault:
            if mending:
                say(f"{shown(place)} is damaged: {fault}")
            continue
        moved_from = "" if content["place"] == str(place) else content["place"]
        if not moved_from or (mending and place.parent == ENV and moved.mend(place, moved_from, LOCK, PROFILE)):
            return place
    return None


def shown(place: Path) -> str:
    """A path as the person sees it from the project's folder."""
    return str(place.relative_to(ENV.parent)) if place.is_relative_to(ENV.parent) else str(place)


def take_turn() -> int | None:
    """Wait until no other launcher or installer is at work."""
    try:
        return locking.exclusive(ONE_AT_A_TIME, wait=False)
    except BlockingIOError:
        say("another launcher is making the environment; waiting for it")
        return locking.exclusive(ONE_AT_A_TIME, wait=True)


def build(turn: int | None) -> Path:
    """A whole environment in a new folder; ends the program with a sentence when that cannot be."""
    name = f".venv-{sys.implementation.cache_tag}-{stamp.lock_sum(LOCK)[:8]}-{secrets.token_hex(3)}"
    place = ENV / name
    say(f"making the environment in {shown(place)}; this happens once")
    place.mkdir()
    try:
        installer = Installer(place, turn)
        installer.make_venv()
        installer.packages(LOCK)
        shutil.rmtree(installer.temporary, ignore_errors=True)
        faults = records.faults(place, LOCK)
        if faults:
            more = f", and {len(faults) - 1} more" if len(faults) > 1 else ""
            sys.exit(f"env: what was installed is not whole: {faults[0]}{more}; run the same command again")
        finish_activation(place, PROFILE)
        stamp.write(place, LOCK)
    except BaseException:
        shutil.rmtree(place, ignore_errors=True)
        if (LINK / "bin" / "python").exists():
            say("env/.venv still holds the environment from before; to work with that one: . env/.venv/bin/activate")
        raise
    return place


def clear_remains(turn: int | None) -> None:
    """Remove what killed attempts left; their disk is needed, and with the turn held nobody works in them."""
    for path in ENV.glob(".venv-*"):
        if turn is not None and not path.is_symlink() and not (path / stamp.STAMP).exists():
            remove(path)


def hold(place: Path) -> bool:
    """Mark an environment as used for as long as this process and the command that it becomes live."""
    try:
        descriptor = locking.shared(place / HELD)
    except OSError:
        return False  # it is being removed
    if descriptor is not None:
        os.set_inheritable(descriptor, True)
    return (place / stamp.STAMP).exists()


def ready(check: bool = False) -> Path:
    """The environment to run in, made first where there is none; `check` reads every file of it."""
    while True:
        place = usable()
        bad = records.faults(place, LOCK) if place and check else []
        if place is None or bad:
            turn = take_turn()
            clear_remains(turn)
            if bad and place:
                say(f"{shown(place)} is damaged: {bad[0]} ({len(bad)} in all)")
                (place / stamp.STAMP).unlink(missing_ok=True)
            place = usable(mending=True) or build(turn)
            if turn is not None:
                os.close(turn)
        if hold(place):
            return place


def swap(place: Path) -> None:
    """Let `env/.venv` name an environment, unless it names one of this lock or a job runs by that name."""
    named = Path(os.path.realpath(LINK))
    if named == place or is_another_pythons(named):
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
    if content is None or content["lock"] != stamp.lock_sum(LOCK) or content["place"] != str(place):
        return False
    return content["python"] != stamp.python_tag() and stamp.stands(place, content)


def out_of_date(place: Path) -> list[Path]:
    """Environments beside `place` that no launcher would choose, and remains of killed attempts and swaps."""
    kept = (place, Path(os.path.realpath(LINK)))
    return [
        path for path in ENV.glob(".venv-*") if path not in kept and (path.is_symlink() or not is_another_pythons(path))
    ]


UNKNOWN = (
    "older environments stay, as this system does not tell whether they are used; when no job runs, delete in env/: {}"
)


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
