"""A rig on a pseudo-terminal that does, frame by frame, what a test tells it to: right or wrong."""

import contextlib
import os
import pty
import select
import time
import tty
from pathlib import Path

import numpy as np

from pipeline.wire import Channel, Decoder, Event, Frame, Hello, Kind, Reason, encode
from pipeline.wire.frames import END, EVENT

CHANNELS = (Channel("motor_turns", "turns", "i32", 0.25), Channel("displacement_mm", "mm", "i16", 0.02))
RATE_HZ = 50.0
STEP_US = 20_000
SAMPLES = 60
MARKS = {5: (Event.STROKE_START, 1), 28: (Event.STROKE_END, 1), 32: (Event.STROKE_START, 2), 55: (Event.STROKE_END, 2)}


def hello(nonce: str = "00000001", protocol: int = 2, channels: tuple[Channel, ...] = CHANNELS) -> Hello:
    """What this rig says of itself."""
    return Hello("scripted rig", "1.0", nonce, RATE_HZ, 2, channels, protocol)


def frames(
    count: int = SAMPLES,
    first_us: int = 0,
    step_us: int = STEP_US,
    nonce: str = "00000001",
    rise: int = 7,
    protocol: int = 2,
    stamps: dict[int, int] | None = None,
) -> list[bytes]:
    """A whole recording: HELLO, `count` samples, an EVENT before each sample of MARKS, END; by their numbers.

    `stamps` has those of some samples in us, instead of what a clock says.
    """
    encoded = [encode(Kind.HELLO, 0, hello(nonce, protocol).pack(), protocol)]
    samples = np.zeros(count, hello().sample_type)
    times_us = first_us + np.arange(count, dtype=np.int64) * step_us
    times_us[list(stamps or {})] = list((stamps or {}).values())
    samples["t_us"] = times_us % 2**32
    samples["motor_turns"] = np.arange(count)
    samples["displacement_mm"] = np.arange(count) * rise % 30_000 if rise > 0 else np.arange(count) * rise
    t_us, payloads, size = samples["t_us"].tolist(), samples.tobytes(), samples.itemsize
    for number in range(count):
        if number in MARKS:
            encoded.append(encode(Kind.EVENT, len(encoded), EVENT.pack(t_us[number], *MARKS[number]), protocol))
        encoded.append(encode(Kind.SAMPLE, len(encoded), payloads[number * size : (number + 1) * size], protocol))
    return [*encoded, encode(Kind.END, len(encoded), END.pack(count, Reason.COMPLETE), protocol)]


def received(data: bytes, faster: int) -> bytes:
    """What a UART reads at `faster` times the sender's baud rate."""
    bits = [1, 1]
    for byte in data:
        bits += [0, *((byte >> at) & 1 for at in range(8)), 1]
    wave = [bit for bit in bits for _ in range(faster)]
    read_bytes, at = bytearray(), 0
    while at + 10 <= len(wave):
        if wave[at]:
            at += 1
            continue
        read_bytes.append(sum(wave[at + 1 + bit] << bit for bit in range(8)))
        at += 10
    return bytes(read_bytes)


class Rig:
    """A serial port in our hands; `name` is what the host opens."""

    def __init__(self) -> None:
        self._ours, self._theirs = pty.openpty()
        tty.setraw(self._theirs)
        self.name = os.ttyname(self._theirs)
        self._decoder = Decoder()
        self._heard: list[Frame] = []

    def hear(self, kind: Kind, within_s: float = 30.0) -> Frame:
        """Wait for the host's next frame of a kind, passing over others; raises TimeoutError."""
        until_s = time.monotonic() + within_s
        while True:
            while self._heard:
                frame = self._heard.pop(0)
                if frame.kind == kind:
                    return frame
            left_s = until_s - time.monotonic()
            if left_s <= 0 or not select.select([self._ours], [], [], left_s)[0]:
                raise TimeoutError(f"the host sent no {kind.name}")
            self._heard += [decoded.frame for decoded in self._decoder.feed(os.read(self._ours, 4096))]

    def unheard(self) -> list[Frame]:
        """Frames of the host's that came and were not waited for."""
        while select.select([self._ours], [], [], 0)[0]:
            self._heard += [decoded.frame for decoded in self._decoder.feed(os.read(self._ours, 4096))]
        unread, self._heard = self._heard, []
        return unread

    def say(self, *chunks: bytes) -> None:
        """Send bytes, waiting for the host to take them."""
        data = memoryview(b"".join(chunks))
        while data:
            data = data[os.write(self._ours, data[:4096]) :]

    def say_what_fits(self, outgoing: list[bytes]) -> tuple[list[bytes], bytes]:
        """Send frames, dropping those that nobody takes: which were sent, and what of the last is still to be."""
        os.set_blocking(self._ours, False)
        sent, waiting = [], b""
        for frame in outgoing:
            with contextlib.suppress(BlockingIOError):
                while waiting:  # a frame half of which is out is sent to its end
                    waiting = waiting[os.write(self._ours, waiting) :]
            if waiting:
                continue
            sent.append(frame)
            waiting = frame
        os.set_blocking(self._ours, True)
        return sent, waiting

    def begin(self, outgoing: list[bytes]) -> None:
        """Answer the host's GREET with HELLO, and wait for its START."""
        self.hear(Kind.GREET)
        self.say(outgoing[0])
        self.hear(Kind.START)

    def unplug(self) -> None:
        """Pull the cable."""
        for end in (self._ours, self._theirs):
            with contextlib.suppress(OSError):
                os.close(end)


def link(rig: Rig, path: Path) -> Path:
    """Give a rig's port a name that stays when it is plugged in again."""
    path.unlink(missing_ok=True)
    path.symlink_to(rig.name)
    return path
