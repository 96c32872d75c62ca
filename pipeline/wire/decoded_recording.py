"""A recording's bytes as samples, with the account of its frames: which came, which are lost, and where."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from .counters import Whole
from .frame_account import Account, Event
from .growing_account import Ledger
from .hello import Hello
from .in_order import Part, in_order, joined
from .mending import Mending, Steps, steps_between
from .stamps import Array

PIECE = 1 << 20  # bytes that are decoded at once
KEPT = 1 << 24  # bytes of decoded samples that are kept for the next time that they are asked for


@dataclass(frozen=True)
class Recording:
    """The content of a byte log, by the frames' numbers; without a readable HELLO it is empty, and `hello` is None."""

    hello: Hello | None
    time_s: Array  # since the first sample, by stamps that are mended where a few of them cannot be, (samples,)
    channels: dict[str, Array]  # by the HELLO's names, in its units, each (samples,)
    seq: Whole  # of every sample's frame, a count, (samples,)
    account: Account
    mended: dict[str, int] = field(default_factory=dict)  # how often each rule of Mending was needed

    @property
    def events(self) -> tuple[Event, ...]:
        """EVENT frames."""
        return self.account.events


@dataclass(frozen=True)
class Pieces:
    """The content of a byte log, piece by piece; memory grows with its faults, not with its length.

    A log whose samples are more than `KEPT` is decoded anew for `mended`, and each time that they are asked for.
    """

    hello: Hello | None
    account: Account
    _parts: Callable[[], Iterator[Part]]  # samples as they came
    _firsts: Whole  # number of the first sample of each part, (parts,)

    def _in_order(self) -> Iterator[Part]:
        return in_order(self._parts(), self._firsts, self.account.sent)

    def _steps(self) -> Iterator[Steps]:
        return steps_between((numbers, samples["t_us"]) for numbers, samples in self._in_order())

    @cached_property
    def _mending(self) -> Mending:
        return Mending.of(self._steps)

    @property
    def mended(self) -> dict[str, int]:
        """How often each rule of Mending is needed."""
        return self._mending.counted

    def samples(self) -> Iterator[tuple[Array, dict[str, Array], Whole]]:
        """Times, channels and numbers of samples as Recording has them, from at least one piece.

        Shape (samples,) each, in s and the channels' units; without a HELLO there is no piece.
        """
        if self.hello is None:
            return
        waiting: list[Part] = [(np.zeros(0, np.int64), np.zeros(0, self.hello.sample_type))]

        def passing() -> Iterator[tuple[Whole, NDArray[np.uint32]]]:
            for part in self._in_order():
                waiting.append(part)
                yield part[0], part[1]["t_us"]

        empty = True
        for time_us in self._mending.stamps(steps_between(passing())):  # mended stamps come after their samples
            numbers, raw = joined(waiting)
            waiting[:] = [(numbers[len(time_us) :], raw[len(time_us) :])]
            empty = False
            yield self._piece(self.hello, time_us, numbers[: len(time_us)], raw[: len(time_us)])
        if empty:
            yield self._piece(self.hello, np.zeros(0), *waiting[0])

    @staticmethod
    def _piece(
        hello: Hello, time_us: Array, numbers: Whole, raw: NDArray[np.void]
    ) -> tuple[Array, dict[str, Array], Whole]:
        return time_us * 1e-6, {c.name: raw[c.name] * c.scale + c.offset for c in hello.channels}, numbers


def read_account(chunks: Iterable[bytes]) -> tuple[Hello | None, Account]:
    """The device and the account of a byte log; memory does not grow with its length. Never raises."""
    ledger = Ledger()
    for chunk in chunks:
        ledger.feed(chunk)
    return ledger.hello, ledger.account()


def _parts(ledger: Ledger, chunks: Iterable[bytes]) -> Iterator[Part]:
    """Samples of a byte log as they come, entered into a ledger."""
    for chunk in chunks:
        part = ledger.feed(chunk)
        if part is not None and len(part[0]):
            yield part


def read_pieces(chunks: Callable[[], Iterable[bytes]]) -> Pieces:
    """The content of a byte log that comes in chunks, the same chunks each time; read as by `read_recording`."""
    ledger, firsts, kept, size = Ledger(), list[int](), list[Part](), 0
    for numbers, samples in _parts(ledger, chunks()):
        firsts.append(int(numbers[0]))
        size += numbers.nbytes + samples.nbytes
        if size <= KEPT:
            kept.append((numbers, samples))
        else:
            kept.clear()

    def parts() -> Iterator[Part]:
        return iter(kept) if size <= KEPT else _parts(Ledger(counts_only=True), chunks())

    return Pieces(ledger.hello, ledger.account(), parts, np.array(firsts, np.int64))


def read_recording(data: bytes) -> Recording:
    """Samples, events and account of a byte log; never raises, whatever the bytes.

    Only what the device sent between its first HELLO and a reset is read. Frames that came twice count once, and
    those that came in the wrong order are put right by their numbers.
    """
    ledger = Ledger()
    parts = list(_parts(ledger, (data[at : at + PIECE] for at in range(0, len(data), PIECE))))
    firsts = np.array([numbers[0] for numbers, _ in parts], np.int64)
    pieces = Pieces(ledger.hello, ledger.account(), lambda: iter(parts), firsts)
    if pieces.hello is None:
        return Recording(None, np.zeros(0), {}, np.zeros(0, np.int64), pieces.account)
    times, channels, numbers = zip(*pieces.samples(), strict=True)
    named = {name: np.concatenate([piece[name] for piece in channels]) for name in channels[0]}
    time_s, seq = np.concatenate(times), np.concatenate(numbers)
    return Recording(pieces.hello, time_s, named, seq, pieces.account, pieces.mended)
