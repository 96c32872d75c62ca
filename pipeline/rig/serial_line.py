"""A pseudo-terminal as the rig's serial line: raw, under a name of our choice, with the kernel's back-pressure."""

import math
import os
import select
import stat
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..ground.errors import BadInput
from .device import Device

try:
    import pty
    import tty
except ImportError:  # no POSIX system
    pty = tty = None  # type: ignore[assignment]

REPEAT_END_S = 0.2
FORGET_END_S = 10.0


@contextmanager
def line(link: Path) -> Iterator[int]:
    """Open a pseudo-terminal, yield the device's end of it and name the host's end `link`; both go afterwards.

    Raises BadInput when `link` is taken by what is no link or by a live rig, or the system has no pseudo-terminals.
    """
    if pty is None:
        raise BadInput(link, "--link", "needs a pseudo-terminal, which this system does not have", "use Linux")
    if link.exists() and not link.is_symlink():
        raise BadInput(link, "--link", "is there and is no link", "choose a path that is free")
    if _leads_to_a_rig(link):
        raise BadInput(link, "--link", "another rig is there", "end it, or choose another --link")
    ours, theirs = pty.openpty()
    name = os.ttyname(theirs)
    try:
        tty.setraw(theirs)  # a fresh one echoes and turns newlines
        os.set_blocking(ours, False)
        temporary = link.with_name(f".{link.name}.{os.getpid()}")
        temporary.symlink_to(name)
        temporary.replace(link)
        yield ours
    finally:
        os.close(ours)
        os.close(theirs)  # kept open until now: a host may come, go and come back
        if link.is_symlink() and os.readlink(link) == name:  # another rig may have taken the name since
            link.unlink(missing_ok=True)


def _leads_to_a_rig(link: Path) -> bool:
    """Whether a link leads to a terminal: that of a rig which has ended is gone, and its link is stale."""
    return link.is_symlink() and link.exists() and stat.S_ISCHR(link.stat().st_mode)


def serve(end: int, device: Device, pace: float = math.inf) -> bool:
    """Serve one recording at `pace` times real time; False when its END is not acknowledged within 10 s.

    Waits as long as it takes for a host to begin and to read.
    """
    pending = b""
    started_s: float | None = None
    ended_s: float | None = None
    told_s = time.monotonic()  # when the host last said something
    while not device.acknowledged:
        now_s = time.monotonic()
        if not pending:
            device_s = math.inf if math.isinf(pace) else pace * (now_s - (started_s or now_s))
            pending = device.speak(device_s)
        if device.waiting:
            ended_s = ended_s if ended_s is not None else now_s
            if now_s - ended_s > FORGET_END_S:
                return False
        else:
            ended_s = None
        writers = [end] if pending else []
        waits = math.isinf(pace) and device.silence_s is None
        patience_s = REPEAT_END_S if device.waiting else None if waits else 0.02
        readable, writable, _ = select.select([end], writers, [], patience_s)
        if readable:
            before, told_s = device.recording, time.monotonic()
            device.hear(os.read(end, 4096))
            if device.recording and not before:
                started_s = time.monotonic()
        elif device.silence_s is not None and time.monotonic() - told_s > device.silence_s:
            device.alone()  # only where nothing waits to be read: this program may have been slow itself
        if writable:
            pending = pending[os.write(end, pending) :]
        if not (readable or writable) and device.waiting and not pending:
            pending = device.again()
    return True
