"""Which frame numbers can be true: 16 bits of check let one damaged frame in a million pass as a good one."""

import struct
from dataclasses import dataclass

from .frames import END, EVENT, Kind

LATE = 1000  # so many frames may be lost in one place, or come late, without anything else that speaks for it
STAMP = struct.Struct("<I")


@dataclass
class Numbers:
    """The numbers of a recording's frames so far, from HELLO's 0 on: `high` is the highest that is believed.

    A number that leaps ahead by more than LATE is believed when the device's clock has gone on by as much, when an END
    has counted as many samples, or when the next frame goes on from there; else one false frame would be millions lost.
    """

    rate_hz: float
    high: int = 0
    t_us: int | None = None  # of the last believed SAMPLE
    others: int = 0  # frames so far that are no SAMPLE
    _doubted: int | None = None

    def of(self, seq: int) -> int:
        """The number that a wrapping 32-bit `seq` stands for; negative when it cannot be."""
        return self.high + (seq - self.high + 2**31) % 2**32 - 2**31

    def believe(self, kind: int, number: int, payload: bytes) -> bool:
        """Take note of a frame, and say whether its number can be true."""
        if kind == Kind.END and len(payload) == END.size and not self.ends(number, payload):
            return False
        if number < 0:
            return False
        doubted, self._doubted = self._doubted, None
        far = number - self.high > LATE
        if far and not (doubted is not None and 0 < number - doubted <= LATE):
            is_end = kind == Kind.END and len(payload) == END.size
            if not is_end and not self._went_on(kind, number, payload):
                self._doubted = number
                return False
        self.high = max(self.high, number)
        self.others += kind != Kind.SAMPLE
        if kind == Kind.SAMPLE and len(payload) >= STAMP.size:
            (self.t_us,) = STAMP.unpack_from(payload)
        return True

    def ends(self, number: int, payload: bytes) -> bool:
        """Whether an END can bear this number. It may lie at most LATE below the highest number so far.

        A larger leap must fit the count of samples in the END.
        """
        samples, _ = END.unpack(payload)
        if number - self.high > LATE:
            return 0 <= number - 1 - samples <= LATE + self.others
        return number > 0 and number >= self.high - LATE

    def _went_on(self, kind: int, number: int, payload: bytes) -> bool:
        """Whether the device's clock has gone on by as much as a number has."""
        timed = (kind == Kind.SAMPLE and len(payload) >= STAMP.size) or (
            kind == Kind.EVENT and len(payload) == EVENT.size
        )
        if not timed or self.t_us is None:
            return False
        passed_us = (STAMP.unpack_from(payload)[0] - self.t_us) % 2**32
        return number - self.high <= LATE + 2.0 * self.rate_hz * passed_us * 1e-6
