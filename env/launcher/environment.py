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
from launcher.places import ENV, HELD, LINK, LOCK, ONE_AT_A_TIME, PROFILE, environments, shown
from launcher.swap import clear_remains
from launcher.words import say


def candidates() -> list[Path]:
    """The folders that may be the environment, what `env/.venv` names first; never `env/.venv` itself.

    While another launcher makes that link, it is absent now and there a moment later.
    """
    named = Path(os.path.realpath(LINK))
    there = [named] if named != LINK else []
    return [*there, *(path for path in environments() if path != named)]


def usable(mending: bool = False) -> Path | None:
    """An environment of this lock and this Python that is whole where it lies; `mending` fits a moved one."""
    for place in candidates():
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
    say(f"making the environment in {shown(place)}, once for each lock")
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
            if turn is not None:
                clear_remains()
            if bad and place:
                say(f"{shown(place)} is damaged: {bad[0]} ({len(bad)} in all)")
                if place.parent == ENV:
                    (place / stamp.STAMP).unlink(missing_ok=True)
            place = (None if bad else usable(mending=True)) or build(turn)
            if turn is not None:
                os.close(turn)
        if hold(place):
            return place
