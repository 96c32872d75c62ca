"""A device that follows programs: it takes a program as a whole, refuses an impossible one, and stops when alone."""

import math

from ..wire import Event, Frame, Kind, Reason, encode
from ..wire.motion import LEG, PROGRAM, TAKEN, Answer, Leg, packed, refusal
from .device import Device
from .kept_string import Standing

STALLED = 1  # the fault's number


class Commanded(Device):
    """One recording of a standing rig, by its own motion or a program, which stalls beyond the twist `stalls_at`."""

    def __init__(self, standing: Standing, stalls_at: float | None = None) -> None:
        self.standing, self.stalls_at = standing, stalls_at
        self.legs: dict[int, bytes] = {}
        self.program: list[Leg] | None = None
        super().__init__(standing.declared)

    @property
    def silence_s(self) -> float | None:
        """How long the host may say nothing while a program moves the motor; None where none does."""
        return self.standing.limits.silence_s if self.program and self.recording else None

    def alone(self) -> None:
        """The motor stops where it is."""
        if self.recording:
            self._answer += self._end_with(Reason.SILENCE)

    def _obey(self, frame: Frame) -> None:
        if frame.kind == Kind.GREET:
            if self.recording:
                self.standing.stopped(self._sample or 0)
            self.legs, self.program, self.simulated = {}, None, self.standing.declared
        elif frame.kind == Kind.LEG and len(frame.payload) == LEG.size and not self.recording:
            self.legs[LEG.unpack(frame.payload)[0]] = frame.payload
        elif frame.kind == Kind.PROGRAM and len(frame.payload) == PROGRAM.size:
            self._answer += self._weigh(*PROGRAM.unpack(frame.payload))
        elif frame.kind == Kind.START and self._sample is None and self._end is None:
            self.simulated = self.standing.perform(self.program) if self.program else self.standing.own()
        super()._obey(frame)

    def _weigh(self, count: int, crc: int) -> bytes:
        """The answer to a program that the host has sent completely."""
        if self.recording or self.waiting:
            return _taken(count, crc, Answer.BUSY)
        kept = [payload for number, payload in sorted(self.legs.items()) if number < count]
        legs = [Leg.unpack(payload) for payload in kept]
        ours, self.legs, self.program = packed(legs)[1] if legs else 0, {}, None
        if (len(legs), ours) != (count, crc):
            return _taken(len(legs), ours, Answer.BROKEN)
        reason = refusal(legs, self.standing.limits)
        if reason is not None:
            return _taken(count, crc, reason[0], reason[1])
        self.program = legs
        return _taken(count, crc, Answer.TAKEN)

    def speak(self, until_s: float = math.inf) -> bytes:
        """The next bytes, as for any device; a motor that stalls ends the recording as a fault."""
        frames = super().speak(until_s)
        if self.program and self.recording and self.stalls_at is not None:
            sent = self.simulated.truth["motor_turns"][: self._sample]
            if sent.max(initial=0.0) > self.stalls_at:
                at_us = int(self.simulated.samples["t_us"][len(sent) - 1])
                frames += self._tell(at_us, Event.FAULT, STALLED) + self._end_with(Reason.FAULT)
        return frames

    def _end_with(self, reason: Reason) -> bytes:
        if reason != Reason.COMPLETE:
            self.standing.stopped(self._sample or 0)
        return super()._end_with(reason)


def _taken(count: int, crc: int, answer: Answer, leg: int = 0) -> bytes:
    return encode(Kind.TAKEN, 0, TAKEN.pack(count, crc, answer, leg))
