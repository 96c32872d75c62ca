"""A synthetic rig that was slow itself does not take its host for silent."""

import os
import pty
import threading
import time
import tty

from pipeline.rig.serial_line import serve
from pipeline.wire import Decoder, Kind, encode


class Slow:
    """A device that thinks for longer than it lets its host be silent, and then says that it is done."""

    silence_s, waiting = 0.3, False

    def __init__(self, thinks_s: float) -> None:
        self.thinks_s, self.heard, self.stopped, self.recording = thinks_s, 0, False, False

    @property
    def acknowledged(self) -> bool:
        return self.stopped or self.heard >= 4

    def hear(self, data: bytes) -> None:
        self.recording, self.heard = True, self.heard + len(Decoder().feed(data))

    def speak(self, device_s: float) -> bytes:
        if self.recording:
            time.sleep(self.thinks_s)
        return b""

    def alone(self) -> None:
        self.stopped = True


def served(device: Slow, beats: int) -> None:
    """The device is told START, and then so many times that somebody is there, while it thinks."""
    ours, theirs = pty.openpty()
    tty.setraw(theirs)
    server = threading.Thread(target=serve, args=(ours, device, 1.0), daemon=True)
    server.start()
    os.write(theirs, encode(Kind.START, 0))
    for number in range(beats):
        time.sleep(0.1)
        os.write(theirs, encode(Kind.BEAT, number))
    server.join(timeout=60)
    os.close(ours)
    os.close(theirs)


def test_a_host_that_was_heard_while_the_rig_thought_is_there():
    device = Slow(thinks_s=1.0)
    served(device, beats=3)
    assert device.heard == 4 and not device.stopped


def test_a_host_that_says_nothing_is_silent():
    device = Slow(thinks_s=0.01)
    served(device, beats=0)
    assert device.heard == 1 and device.stopped
