"""A recording's bytes as samples, and an account of every frame: what came, what is lost, and where."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pipeline.wire.batch import Batch, Whole, read_batch
from pipeline.wire.frames import END, EVENT, Kind
from pipeline.wire.hello import Hello

Array = NDArray[np.float64]


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
class Account:
    """Frames of one recording. `sent` = `received` + `lost`: up to END, or without one up to the last frame seen.

    The frames of one recording are numbered 0 (HELLO) to `sent` − 1. `gaps` says where frames are missing:
    samples received before the gap, and number of frames lost there. What a reset device sent is not counted.
    """

    sent: int
    received: int
    lost: int
    bad: int  # stretches between two zeros that were no frame: damaged frames are lost, garbage is not
    repeated: int  # came again, or after END, or bear a number that cannot be
    out_of_order: int  # times that a sample came before one with a smaller number
    resets: int
    gaps: tuple[tuple[int, int], ...]
    bad_at: tuple[int, ...]  # positions in the log
    tail_bytes: int  # after the last zero byte
    end: End | None

    @property
    def samples_sent(self) -> int | None:
        """Samples that the device says it sent, or None without an END."""
        return self.end.samples if self.end else None


@dataclass(frozen=True)
class Recording:
    """What a byte log holds, by the frames' numbers; without a readable HELLO nothing, and `hello` is None."""

    hello: Hello | None
    time_s: Array  # since the first sample, (samples,)
    channels: dict[str, Array]  # by the HELLO's names, in its units, each (samples,)
    seq: Whole  # of every sample's frame
    events: tuple[Event, ...]
    account: Account


def unwrap_us(t_us: NDArray[np.uint32], first_us: int) -> Whole:
    """Microseconds since `first_us` of a 32-bit clock that wraps every 71.6 min, for stamps < 35 min apart."""
    if not len(t_us):
        return np.zeros(0, np.int64)
    steps = np.diff(t_us, prepend=np.uint32(first_us)).astype(np.uint32).view(np.int32)
    return np.cumsum(steps, dtype=np.int64)


def _hello(batch: Batch) -> tuple[Hello | None, int, int, int]:
    """First readable HELLO, its frame, the frame at which the device has reset, and how often it did."""
    hello, first, stop, resets = None, 0, len(batch.kind), 0
    for frame in np.flatnonzero(batch.kind == Kind.HELLO).tolist():
        try:
            found = Hello.unpack(batch.payload(frame))
        except ValueError:
            continue
        if hello is None:
            hello, first = found, frame
        elif found.nonce != hello.nonce:
            stop = min(stop, frame)
            resets += 1
    return hello, first, stop, resets


def _once(seq: Whole) -> tuple[Whole, Whole]:
    """Unwrapped numbers from 0 of a u32 sequence, rising, and where each number first came."""
    steps = np.diff(seq.astype(np.uint32), prepend=np.uint32(0)).astype(np.uint32).view(np.int32)
    numbers, first = np.unique(np.cumsum(steps, dtype=np.int64), return_index=True)
    possible = numbers >= 0
    return numbers[possible], first[possible].astype(np.int64)


def _end(batch: Batch, frames: Whole, numbers: Whole) -> tuple[End | None, int]:
    """The END, if it came, and its place among `frames`."""
    for place in np.flatnonzero(batch.kind[frames] == Kind.END).tolist():
        payload = batch.payload(int(frames[place]))
        if len(payload) == END.size:
            samples, reason = END.unpack(payload)
            return End(samples, reason, int(numbers[place])), place
    return None, len(frames) - 1


def _samples(batch: Batch, hello: Hello, frames: Whole) -> tuple[Whole, NDArray[np.void]]:
    """Places among `frames` of the SAMPLE frames, rising, and their numbers under the HELLO's type."""
    layout = np.dtype(hello.sample_type)
    as_they_came = np.argsort(frames, kind="stable")
    came = frames[as_they_came]
    places, found = [np.zeros(0, np.int64)], [np.zeros(0, layout)]
    for members, payloads in batch.matrices:  # several, if there are many frames
        if payloads.shape[1] != layout.itemsize or not len(came):
            continue
        at = np.minimum(np.searchsorted(came, members), len(came) - 1)
        there = (came[at] == members) & (batch.kind[members] == Kind.SAMPLE)
        places.append(as_they_came[at[there]])
        found.append(np.ascontiguousarray(payloads[there]).view(layout)[:, 0])
    place, samples = np.concatenate(places), np.concatenate(found)
    order = np.argsort(place, kind="stable")
    return place[order], samples[order]


def read_recording(data: bytes) -> Recording:
    """Samples, events and account of a byte log; never raises, whatever the bytes.

    Only what the device sent between its first HELLO and a reset is read. Frames that came twice count once, and
    those that came in the wrong order are put right by their numbers.
    """
    batch = read_batch(data)
    hello, first, stop, resets = _hello(batch)
    frames = np.arange(first, stop) if hello is not None else np.zeros(0, np.int64)
    numbers, once = _once(batch.seq[frames])
    frames = frames[once]
    end, last = _end(batch, frames, numbers)
    numbers, frames = numbers[: last + 1], frames[: last + 1]
    sent = int(numbers[-1]) + 1 if len(numbers) else 0
    if hello is None or not len(frames):
        nothing = Account(0, 0, 0, len(batch.bad_at), 0, 0, 0, (), tuple(batch.bad_at.tolist()), batch.tail, None)
        return Recording(None, np.zeros(0), {}, np.zeros(0, np.int64), (), nothing)

    place, raw = _samples(batch, hello, frames)
    first_us = int(raw["t_us"][0]) if len(raw) else 0
    time_s: Array = unwrap_us(raw["t_us"], first_us).astype(np.float64) * 1e-6
    channels = {c.name: raw[c.name] * c.scale + c.offset for c in hello.channels}

    missing = np.diff(numbers, prepend=-1) - 1
    gap_at = np.flatnonzero(missing > 0)
    gaps = zip(np.searchsorted(place, gap_at).tolist(), missing[gap_at].tolist(), strict=True)
    account = Account(
        sent=sent,
        received=len(numbers),
        lost=sent - len(numbers),
        bad=len(batch.bad_at),
        repeated=stop - first - len(frames),
        out_of_order=int(np.count_nonzero(np.diff(frames[place]) < 0)),
        resets=resets,
        gaps=tuple(gaps),
        bad_at=tuple(batch.bad_at.tolist()),
        tail_bytes=batch.tail,
        end=end,
    )
    events = _events(batch, frames, place, time_s, first_us)
    return Recording(hello, time_s, channels, numbers[place], events, account)


def _events(batch: Batch, frames: Whole, place: Whole, time_s: Array, first_us: int) -> tuple[Event, ...]:
    """EVENT frames, timed by the wrapping clock near the sample before each."""
    events = []
    for at in np.flatnonzero(batch.kind[frames] == Kind.EVENT).tolist():
        payload = batch.payload(int(frames[at]))
        if len(payload) != EVENT.size:
            continue
        t_us, code, value = EVENT.unpack(payload)
        before = int(np.searchsorted(place, at)) - 1
        near_us = round(time_s[before] * 1e6) if before >= 0 else 0
        step_us = (t_us - first_us - near_us + (1 << 31)) % (1 << 32) - (1 << 31)
        events.append(Event((near_us + step_us) * 1e-6, code, value))
    return tuple(events)
