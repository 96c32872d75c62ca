"""The rig's device: speaks the wire protocol over any byte stream; no I/O and no clock of its own."""

import math

import numpy as np

from ..wire import Decoder, Event, Frame, Kind, Reason, encode
from ..wire.frames import END, EVENT
from .recorded_at_once import Simulated

AT_ONCE = 128  # samples in one go: a STOP is heard between them


class Device:
    """One recording, served on request; hand it what the host says with `hear`, send what `speak` returns."""

    def __init__(self, simulated: Simulated) -> None:
        self.simulated = simulated
        self.heard = Decoder(simulated.hello.protocol)
        self.acknowledged = False
        self._answer = b""
        self._end: bytes | None = None  # the END that waits for its ACK
        self._stop = False
        self._sample: int | None = None  # the next one to be sent, while recording
        self._event = 0
        self._seq = 1

    @property
    def silence_s(self) -> float | None:
        """How long the host may say nothing while a program moves the motor; None where none does."""
        return None

    def alone(self) -> None:
        """The host has said nothing for that long."""

    @property
    def recording(self) -> bool:
        """Whether the recording was started and has not come to its END."""
        return self._sample is not None

    @property
    def waiting(self) -> bool:
        """Whether the END was sent but is not acknowledged, so that it must be sent again."""
        return self._end is not None and not self.acknowledged

    def again(self) -> bytes:
        """The END, byte for byte."""
        return self._end or b""

    def hear(self, data: bytes) -> None:
        """Take bytes from the host; bytes that are no frame of the protocol are ignored."""
        for heard in self.heard.feed(data):
            self._obey(heard.frame)

    def _obey(self, frame: Frame) -> None:
        if frame.kind == Kind.GREET:
            self._sample, self._end, self._stop = None, None, False
            self._answer += encode(Kind.HELLO, 0, self.simulated.hello.pack())
        elif frame.kind == Kind.START and self._sample is None and self._end is None:
            self._sample, self._event, self._seq, self._stop = 0, 0, 1, False
        elif frame.kind == Kind.STOP:
            self._stop = self._sample is not None
        elif frame.kind == Kind.ACK and self.waiting:
            self.acknowledged = True

    def speak(self, until_s: float = math.inf) -> bytes:
        """The next bytes to send, up to a moment of the device's clock; nothing when there is nothing to say."""
        answer, self._answer = self._answer, b""
        if self._sample is None:
            return answer
        samples, events = self.simulated.samples, self.simulated.events
        ready = int(np.searchsorted(self.simulated.time_s, until_s, side="right"))
        stop = min(self._sample + AT_ONCE, ready)
        frames = [answer]
        while self._sample < stop and not self._stop:
            while self._event < len(events) and events[self._event][0] <= self._sample:
                frames.append(self._tell(*events[self._event][1:]))
                self._event += 1
            frames.append(encode(Kind.SAMPLE, self._next(), samples[self._sample].tobytes()))
            self._sample += 1
        if self._stop or self._sample == len(samples):
            frames.append(self._end_with(Reason.STOPPED if self._stop else Reason.COMPLETE))
        return b"".join(frames)

    def _end_with(self, reason: Reason) -> bytes:
        """END after the samples that were sent."""
        self._end = encode(Kind.END, self._next(), END.pack(self._sample or 0, reason))
        self._sample = None
        return self._end

    def _tell(self, t_us: int, code: Event, value: int) -> bytes:
        return encode(Kind.EVENT, self._next(), EVENT.pack(t_us, code, value))

    def _next(self) -> int:
        self._seq += 1
        return self._seq - 1
