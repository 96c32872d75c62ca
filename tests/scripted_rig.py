"""Rigs at a pseudo-terminal: one whose every answer a test says, and the synthetic one as a program of its own."""

import os
import pty
import threading
import time
import tty
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import ready

from pipeline.wire import Channel, Decoder, Hello, Kind, encode
from pipeline.wire.motion import PROGRAM, TAKEN, Answer

CHANNELS = (Channel("motor_turns", "turns", "i32", 0.001), Channel("displacement_mm", "mm", "i32", 0.001))


class ScriptedRig(threading.Thread):
    """Answers GREET with its `hello`, and programs by `answers`; notes what it hears.

    An answer is how long it waits, in s, and the payload, empty where the program is taken.
    """

    def __init__(self, hello: Hello, answers: list[tuple[float, bytes]] | None = None) -> None:
        super().__init__(daemon=True)
        self.ours, self.theirs = pty.openpty()
        tty.setraw(self.theirs)
        self.port, self.answers, self.hello = os.ttyname(self.theirs), answers or [], hello
        self.heard: list[int] = []
        self.start()

    def run(self) -> None:
        version = self.hello.protocol
        decoder = Decoder(version)
        while True:
            try:
                frames = decoder.feed(os.read(self.ours, 4096))
            except OSError:
                return
            for heard_frame in frames:
                self.heard.append(heard_frame.frame.kind)
                if heard_frame.frame.kind == Kind.GREET:
                    os.write(self.ours, encode(Kind.HELLO, 0, self.hello.pack(), version))
                if heard_frame.frame.kind == Kind.PROGRAM and self.answers:
                    wait_s, payload = self.answers.pop(0)
                    count, crc = PROGRAM.unpack(heard_frame.frame.payload)
                    time.sleep(wait_s)
                    taken = payload or TAKEN.pack(count, crc, Answer.TAKEN, 0)
                    os.write(self.ours, encode(Kind.TAKEN, 0, taken, version))


@contextmanager
def synthetic_rig(link: Path, setup: object, *options: object) -> Iterator[Path]:
    """The synthetic rig of a set-up behind a link, until the end."""
    program = ready.start("pipeline.rig", setup, "--link", link, "--seed", 0, *options)
    try:
        while not link.is_symlink():
            assert program.poll() is None, program.communicate()[0]
            time.sleep(0.01)
        yield link
    finally:
        program.terminate()
        program.communicate()
