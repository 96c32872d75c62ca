"""While recording: faults of the samples themselves, each told in one sentence, once."""

import struct
from pathlib import Path

from ..run.doubts.wrong_sign import FALLS, POSITIVE, turned_sign
from ..run.folder import described
from ..run.mend_command import mend_command
from ..wire import Frame, Hello
from .motion_faults import FROZEN, LEAST_TURNS, REVERSED, MotionFaults, stands_words

CODES = {"i8": "b", "u8": "B", "i16": "h", "u16": "H", "i32": "i", "u32": "I"}
LOOKS_HZ = 50.0  # so many samples a second are looked at
STANDS = 10  # so many looks in a row at which a clock has not gone on


class Watch:
    """Looks at some samples of a recording: the newest values, and whether a sensor is frozen or reversed.

    `folder` is that of the run: a channel that its run.yaml turns over is read so.
    """

    def __init__(self, hello: Hello, folder: Path | None = None) -> None:
        self.hello, self._folder = hello, folder
        self._run = described(folder) if folder else None  # one that cannot be read is said when the recording begins
        self.now: dict[str, float] = {}
        self._layout = struct.Struct("<I" + "".join(CODES[channel.type] for channel in hello.channels))
        self._every = max(1, round(hello.rate_hz / LOOKS_HZ))
        self._seen = self._stands = 0
        self._t_us: int | None = None
        self._said: set[str] = set()
        self._motion = MotionFaults(next((abs(c.scale) for c in hello.channels if c.name == "displacement_mm"), 0.0))

    def look(self, frame: Frame) -> str | None:
        """Take note of a SAMPLE; a sentence when something new is wrong."""
        self._seen += 1
        if len(frame.payload) != self._layout.size:
            return self._say("size", "samples are not of the size that HELLO declares, so they cannot be read")
        if self._seen % self._every:
            return None
        t_us, *numbers = self._layout.unpack(frame.payload)
        clock = self._clock(t_us)
        if clock:
            return clock
        channels = self.hello.channels
        self.now = {c.name: c.scale * n + c.offset for c, n in zip(channels, numbers, strict=True)}
        turns, measured_mm = self._as_read("motor_turns"), self._as_read("displacement_mm")
        if turns is None or measured_mm is None:
            return None
        wrong = self._motion.look(turns, measured_mm)
        if wrong == FROZEN:
            return self._say(wrong, stands_words(LEAST_TURNS))
        if wrong == REVERSED:
            return self._say(wrong, f"displacement_mm {FALLS}; {self._turned()}")
        return None

    def _as_read(self, name: str) -> float | None:
        """The newest value of a channel, with the scale that run.yaml gives it; None where it did not come."""
        own = self._run.channels.get(name) if self._run else None
        value = self.now.get(str(own.column) if own and own.column is not None else name)
        return value if value is None or own is None else value * own.scale

    def _turned(self) -> str:
        """The mend of a displacement that falls, with the command where the run is described."""
        firmware = "swap the sensor's sign in the firmware, or"
        if self._run is None or self._folder is None:
            return f"{POSITIVE}: {firmware} set channels.displacement_mm.scale to -1 in run.yaml"
        to_type = mend_command(turned_sign(self._run), self._folder)
        return f"{POSITIVE}: {firmware}, when the recording has ended: {to_type}"

    def _clock(self, t_us: int) -> str | None:
        """A sentence when the device's clock stands or runs backwards."""
        went_us = STANDS if self._t_us is None else (t_us - self._t_us + 2**31) % 2**32 - 2**31
        self._t_us = t_us
        self._stands = self._stands + 1 if went_us <= 0 else 0
        if self._stands < STANDS:
            return None
        how = "stands" if went_us == 0 else "runs backwards"
        return self._say("clock", f"the device's clock (t_us) {how}: nobody will know when samples were taken")

    def _say(self, what: str, sentence: str) -> str | None:
        if what in self._said:
            return None
        self._said.add(what)
        return sentence
