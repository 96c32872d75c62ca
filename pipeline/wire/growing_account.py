"""The account of a recording that grows piece by piece; its size grows with the faults, not with the length."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from .batch import Batch, read_batch, samples_of
from .counters import Whole, from_one, steps_of
from .frame_account import Account, End, Tally
from .frames import END, EVENT, MAX_STUFFED, Kind, decode, greeting
from .hello import Hello
from .possible_numbers import LATE, Numbers
from .timeline import FIRST, Timeline

NONE: Whole = np.zeros(0, np.int64)


@dataclass
class Ledger:
    """Feed it a byte log in chunks of any size; it never raises, whatever the bytes.

    Only what the device sent between its first HELLO and a reset is entered. Frames that came twice count once, and
    those whose number cannot be true not at all.
    """

    hello: Hello | None = None
    counts_only: bool = False  # then nothing grows with the pieces, and there is a tally and no account
    _rest: bytes = b""  # after the last zero, no more than it takes to see that it is no frame
    _cut: int = 0  # bytes that hang over beyond that
    _bad: int = 0
    _good: int = 0
    _resets: int = 0
    _numbers: Numbers = field(default_factory=lambda: Numbers(0.0))
    _sample: int = -1  # number of the sample that came last
    _out_of_order: int = 0
    _stamp: tuple[int, int] = (-1, 0)  # number and t_us of the last sample that came in order
    _backward: int = 0
    _repeated: int = 0
    _low: Whole = field(default_factory=lambda: NONE)  # numbers that came are low..high of one of these
    _high: Whole = field(default_factory=lambda: NONE)
    _runs: list[Whole] = field(default_factory=list)
    _events: list[tuple[int, int, int, int]] = field(default_factory=list)  # number, t_us, code, value
    _end: End | None = None

    def feed(self, chunk: bytes) -> tuple[Whole, NDArray[np.void]] | None:
        """Enter a chunk. Returns numbers, as counts, and contents of new samples, rising, each of shape (samples,)."""
        zero = chunk.rfind(b"\0") + 1
        whole, rest = (self._rest + chunk[:zero], chunk[zero:]) if zero else (b"", self._rest + chunk)
        self._cut = (0 if zero else self._cut) + max(len(rest) - MAX_STUFFED - 1, 0)
        self._rest = rest[: MAX_STUFFED + 1]
        if self.hello is None and whole:
            whole = self._from_hello(whole)
        return self._enter(read_batch(whole, self.hello.protocol)) if self.hello and whole else None

    def _from_hello(self, whole: bytes) -> bytes:
        """The bytes from the device's HELLO on, which names the protocol's version; empty if there is no HELLO."""
        at = 0
        while (zero := whole.find(b"\0", at)) >= 0:
            frame = decode(whole[at:zero], None)
            self.hello = greeting(frame)
            if self.hello is not None:
                self._numbers.rate_hz = self.hello.rate_hz
                return whole[at:]
            self._bad += frame is None and zero > at
            at = zero + 1
        return b""

    def _enter(self, batch: Batch) -> tuple[Whole, NDArray[np.void]] | None:
        self._bad += len(batch.bad_at)
        assert self.hello is not None
        frames = np.arange(self._stop(batch, self.hello))
        self._good += len(frames)
        numbers = self._numbers.high + from_one(batch.seq[frames].astype(np.uint32), self._numbers.high)
        believed = self._believed(batch, numbers)
        numbers, frames = numbers[believed], frames[believed]
        numbers, once = np.unique(numbers, return_index=True)
        new = ~self._covered(numbers)
        numbers, frames = numbers[new], frames[once[new]]
        if not len(numbers):
            return None
        place, samples = samples_of(batch, self.hello, frames)
        came = numbers[place][np.argsort(frames[place], kind="stable")]
        if len(came):
            self._out_of_order += int(np.count_nonzero(np.diff(came, prepend=max(self._sample, 0)) < 0))
            self._sample = int(came[-1])
            self._clock(numbers[place], samples["t_us"])
        self._others(batch, frames, numbers)
        self._cover(self._run(numbers, place, samples["t_us"]))
        return numbers[place], samples

    def _stop(self, batch: Batch, hello: Hello) -> int:
        """The end of the recording in this piece: frames after a reset, told by a new HELLO, do not belong to it."""
        stop = 0 if self._resets else len(batch.kind)
        for frame in np.flatnonzero(batch.kind == Kind.HELLO).tolist():
            try:
                later_hello = Hello.unpack(batch.payload(frame))
            except ValueError:
                continue
            if later_hello.nonce != hello.nonce:
                stop = min(stop, frame)
                self._resets += 1
        return stop

    def _believed(self, batch: Batch, numbers: Whole) -> NDArray[np.bool_]:
        """Which numbers can be true; frames are checked one by one only where a number leaps, or an END is there."""
        high = np.maximum.accumulate(np.append(self._numbers.high, numbers))
        kinds = batch.kind[: len(numbers)]
        if len(numbers) and not (np.diff(high) > LATE).any() and (numbers >= 0).all() and not (kinds == Kind.END).any():
            self._numbers.high = int(high[-1])
            self._numbers.others += int((kinds != Kind.SAMPLE).sum())
            samples = np.flatnonzero(kinds == Kind.SAMPLE)
            if len(samples):
                last = int(samples[-1])
                self._numbers.believe(Kind.SAMPLE, int(numbers[last]), batch.payload(last))
            return np.ones(len(numbers), bool)
        each = zip(kinds.tolist(), numbers.tolist(), range(len(numbers)), strict=True)
        return np.array([self._numbers.believe(kind, number, batch.payload(at)) for kind, number, at in each], bool)

    def _clock(self, numbers: Whole, t_us: NDArray[np.uint32]) -> None:
        """Count the stamps that stand or fall back, between samples whose numbers rise."""
        number, before = self._stamp
        steps = steps_of(t_us, before)[0 if 0 <= number < numbers[0] else 1 :]
        self._backward += int((steps < 0).sum())
        self._repeated += int((steps == 0).sum())
        self._stamp = max(self._stamp, (int(numbers[-1]), int(t_us[-1])))

    def _covered(self, numbers: Whole) -> NDArray[np.bool_]:
        at = np.searchsorted(self._low, numbers, side="right") - 1
        return (at >= 0) & (numbers <= np.append(self._high, 0)[at])

    def _cover(self, spans: Whole) -> None:
        low, high = np.append(self._low, spans[:, 0]), np.append(self._high, spans[:, 1])
        order = np.argsort(low, kind="stable")
        low, high = low[order], high[order]
        apart = np.flatnonzero(low[1:] > high[:-1] + 1)
        self._low, self._high = low[np.append(0, apart + 1)], high[np.append(apart, len(high) - 1)]

    def _others(self, batch: Batch, frames: Whole, numbers: Whole) -> None:
        kinds = batch.kind[frames]
        for place in np.flatnonzero((kinds == Kind.EVENT) | (kinds == Kind.END)).tolist():
            payload, number = batch.payload(int(frames[place])), int(numbers[place])
            if kinds[place] == Kind.EVENT and len(payload) == EVENT.size:
                self._events.append((number, *EVENT.unpack(payload)))
            elif kinds[place] == Kind.END and len(payload) == END.size and (not self._end or number < self._end.seq):
                samples, reason = END.unpack(payload)
                self._end = End(samples, reason, number)

    def _run(self, numbers: Whole, place: Whole, t_us: NDArray[np.uint32]) -> Whole:
        """Note the runs of a piece; their first and last numbers, shape (runs, 2)."""
        sample, stamps = np.zeros(len(numbers), bool), np.zeros(len(numbers), np.uint32)
        sample[place], stamps[place] = True, t_us
        ends = np.flatnonzero(np.append((np.diff(numbers) != 1) | ~sample[:-1], True))
        begins = np.append(0, ends[:-1] + 1)
        count = ends - begins + sample[ends]
        lasts = np.maximum(begins + count - 1, 0)
        passed = np.cumsum(steps_of(stamps, int(stamps[0])))
        first_us, last_us = stamps[begins].astype(np.int64), stamps[lasts].astype(np.int64)
        runs = np.stack([numbers[begins], count, first_us, last_us, passed[lasts] - passed[begins]], axis=1)
        if not self.counts_only:
            self._runs.append(runs[count > 0])
        return np.stack([numbers[begins], numbers[ends]], axis=1)

    def tally(self) -> Tally:
        """Counts so far, cheap however long the recording is."""
        received = int((self._high - self._low + 1).sum())
        lost = int(self._high[-1]) + 1 - received if received else 0
        return Tally(received, lost, self._bad, tuple(sorted((event[0], *event[2:]) for event in self._events)))

    def account(self) -> Account:
        """All that was entered so far."""
        tail_bytes = len(self._rest) + self._cut
        if self.hello is None or not len(self._low):
            return Account(bad=self._bad, resets=self._resets, tail_bytes=tail_bytes)
        last = self._end.seq if self._end else int(self._high[-1])
        low, high = self._low[self._low <= last], np.minimum(self._high[self._low <= last], last)
        received = int((high - low + 1).sum())
        runs = np.concatenate([np.zeros((0, 5), np.int64), *self._runs])
        runs = runs[np.argsort(runs[:, FIRST], kind="stable")]
        runs = runs[runs[:, FIRST] <= last]
        line = Timeline.of(runs)
        before = np.append(-1, high[:-1]) + 1  # the first number that is missing, if it is
        missing = low - before
        return Account(
            sent=last + 1,
            received=received,
            lost=last + 1 - received,
            bad=self._bad,
            repeated=self._good - received,
            samples=int(line.samples[-1]),
            out_of_order=self._out_of_order,
            resets=self._resets,
            backward_stamps=self._backward,
            repeated_stamps=self._repeated,
            gaps=tuple(line.gap(*gap) for gap in zip(before.tolist(), missing.tolist(), strict=True) if gap[1] > 0),
            events=tuple(line.event(*event) for event in sorted(self._events) if event[0] <= last),
            last_s=line.time_s(len(runs) - 1, line.end_us) or 0.0,
            tail_bytes=tail_bytes,
            end=self._end,
        )
