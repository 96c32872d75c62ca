"""An account of a recording that grows piece by piece; its size goes by what went wrong, not by how much came."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from pipeline.wire.account import Account, End
from pipeline.wire.batch import Batch, Whole, read_batch
from pipeline.wire.frames import END, EVENT, MAX_STUFFED, Kind
from pipeline.wire.hello import Hello
from pipeline.wire.timeline import FIRST, Timeline, steps_of

NONE: Whole = np.zeros(0, np.int64)


@dataclass
class Ledger:
    """Feed it a byte log in chunks of any size; it never raises, whatever the bytes.

    Only what the device sent between its first HELLO and a reset is entered. Frames that came twice count once.
    """

    hello: Hello | None = None
    _rest: bytes = b""  # after the last zero, no more than it takes to see that it is no frame
    _cut: int = 0  # bytes that hang over beyond that
    _bad: int = 0
    _good: int = 0
    _resets: int = 0
    _number: int = 0  # of the frame that came last
    _sample: int = -1  # number of the sample that came last
    _out_of_order: int = 0
    _low: Whole = field(default_factory=lambda: NONE)  # numbers that came are low..high of one of these
    _high: Whole = field(default_factory=lambda: NONE)
    _runs: list[Whole] = field(default_factory=list)
    _events: list[tuple[int, int, int, int]] = field(default_factory=list)  # number, t_us, code, value
    _end: End | None = None

    def feed(self, chunk: bytes) -> tuple[Whole, NDArray[np.void]] | None:
        """Enter what ends in a chunk; the numbers and contents of its samples that had not come before, rising."""
        zero = chunk.rfind(b"\0") + 1
        whole, rest = (self._rest + chunk[:zero], chunk[zero:]) if zero else (b"", self._rest + chunk)
        self._cut = (0 if zero else self._cut) + max(len(rest) - MAX_STUFFED - 1, 0)
        self._rest = rest[: MAX_STUFFED + 1]
        return self._enter(read_batch(whole)) if whole else None

    def _enter(self, batch: Batch) -> tuple[Whole, NDArray[np.void]] | None:
        self._bad += len(batch.bad_at)
        begin, stop = self._bounds(batch)
        if self.hello is None or begin >= stop:
            return None
        frames = np.arange(begin, stop)
        self._good += len(frames)
        numbers = self._number + np.cumsum(steps_of(batch.seq[frames].astype(np.uint32), self._number))
        self._number = int(numbers[-1])
        numbers, once = np.unique(numbers, return_index=True)
        new = (numbers >= 0) & ~self._covered(numbers)
        numbers, frames = numbers[new], frames[once[new]]
        if not len(numbers):
            return None
        place, samples = _samples(batch, self.hello, frames)
        came = numbers[place][np.argsort(frames[place], kind="stable")]
        if len(came):
            self._out_of_order += int(np.count_nonzero(np.diff(came, prepend=max(self._sample, 0)) < 0))
            self._sample = int(came[-1])
        self._others(batch, frames, numbers)
        self._cover(self._run(numbers, place, samples["t_us"]))
        return numbers[place], samples

    def _bounds(self, batch: Batch) -> tuple[int, int]:
        """The piece's first frame of the recording, and the one behind its last."""
        begin, stop = (len(batch.kind) if self.hello is None else 0), (0 if self._resets else len(batch.kind))
        for frame in np.flatnonzero(batch.kind == Kind.HELLO).tolist():
            try:
                found = Hello.unpack(batch.payload(frame))
            except ValueError:
                continue
            if self.hello is None:
                self.hello, begin = found, frame
            elif found.nonce != self.hello.nonce:
                stop = min(stop, frame)
                self._resets += 1
        return begin, stop

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
        self._runs.append(runs[count > 0])
        return np.stack([numbers[begins], numbers[ends]], axis=1)

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
            gaps=tuple(line.gap(*one) for one in zip(before.tolist(), missing.tolist(), strict=True) if one[1] > 0),
            events=tuple(line.event(*one) for one in sorted(self._events) if one[0] <= last),
            last_s=line.time_s(len(runs) - 1, line.end_us) or 0.0,
            tail_bytes=tail_bytes,
            end=self._end,
        )


def _samples(batch: Batch, hello: Hello, frames: Whole) -> tuple[Whole, NDArray[np.void]]:
    """Places among `frames` of the SAMPLE frames, rising, and their numbers under the HELLO's type."""
    layout = np.dtype(hello.sample_type)
    as_they_came = np.argsort(frames, kind="stable")
    came = frames[as_they_came]
    places, found = [NONE], [np.zeros(0, layout)]
    for members, payloads in batch.matrices:  # several, if there are many frames
        if payloads.shape[1] != layout.itemsize:
            continue
        at = np.minimum(np.searchsorted(came, members), len(came) - 1)
        there = (came[at] == members) & (batch.kind[members] == Kind.SAMPLE)
        places.append(as_they_came[at[there]])
        found.append(np.ascontiguousarray(payloads[there]).view(layout)[:, 0])
    place, samples = np.concatenate(places), np.concatenate(found)
    order = np.argsort(place, kind="stable")
    return place[order], samples[order]
