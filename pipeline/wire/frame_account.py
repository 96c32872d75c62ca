"""The account of a recording's frames: how many came, which are missing, where, and how the recording ended."""

from dataclasses import dataclass

from .stamps import no_clock


@dataclass(frozen=True)
class End:
    """The END frame: how many samples the device sent, and why it ended (a frames.Reason)."""

    samples: int
    reason: int
    seq: int


@dataclass(frozen=True)
class Event:
    """An EVENT frame; `code` is a frames.Event, `time_s` since the first sample."""

    time_s: float
    code: int
    value: int


@dataclass(frozen=True)
class Gap:
    """Frames that are missing in one place: the samples before it, and the times of its neighbours, None at an end."""

    after_samples: int
    frames: int
    after_s: float | None
    until_s: float | None


@dataclass(frozen=True)
class Tally:
    """Frames of a recording that still grows; for each event its frame number, code and value."""

    received: int
    lost: int
    bad: int
    events: tuple[tuple[int, int, int], ...]


@dataclass(frozen=True)
class Account:
    """Frames of one recording. `sent` = `received` + `lost`: up to END, or without one up to the last frame seen.

    The frames of one recording are numbered 0 (HELLO) to `sent` − 1, and `gaps` are sorted by them. What a reset
    device sent is not counted.
    """

    sent: int = 0
    received: int = 0
    lost: int = 0
    bad: int = 0  # stretches between two zeros that were no frame: damaged frames are lost, garbage is not
    repeated: int = 0  # came again, or after END, or bear a number that cannot be
    samples: int = 0  # among those received
    out_of_order: int = 0  # times that a sample came after one with a greater number
    resets: int = 0
    backward_stamps: int = 0  # samples whose time stamp is before that of the sample before it
    repeated_stamps: int = 0
    gaps: tuple[Gap, ...] = ()
    events: tuple[Event, ...] = ()
    last_s: float = 0.0  # time of the last sample since the first
    tail_bytes: int = 0  # after the last zero byte
    end: End | None = None

    @property
    def samples_sent(self) -> int | None:
        """Samples that the device says it sent, or None without an END."""
        return self.end.samples if self.end else None

    @property
    def no_clock(self) -> bool:
        """Whether the device's clock stands or runs backwards too often to be mended."""
        return no_clock(self.samples, self.backward_stamps, self.repeated_stamps)
