"""A recording's bytes as samples, with the account of every frame: what came, what is lost, and where."""

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np

from .account import Account, Event
from .counters import Whole
from .hello import Hello
from .ledger import Ledger
from .stamps import Array, mend, unwrap_us

PIECE = 1 << 20  # bytes that are decoded at once


@dataclass(frozen=True)
class Recording:
    """What a byte log holds, by the frames' numbers; without a readable HELLO nothing, and `hello` is None."""

    hello: Hello | None
    time_s: Array  # since the first sample, by stamps that are mended where a few of them cannot be, (samples,)
    channels: dict[str, Array]  # by the HELLO's names, in its units, each (samples,)
    seq: Whole  # of every sample's frame
    account: Account
    mended: dict[str, int] = field(default_factory=dict)  # how often each rule of stamps.mend was needed

    @property
    def events(self) -> tuple[Event, ...]:
        """EVENT frames."""
        return self.account.events


def read_account(chunks: Iterable[bytes]) -> tuple[Hello | None, Account]:
    """What a byte log says of its device, and its account, in memory that does not go by its length; never raises."""
    ledger = Ledger()
    for chunk in chunks:
        ledger.feed(chunk)
    return ledger.hello, ledger.account()


def read_recording(data: bytes) -> Recording:
    """Samples, events and account of a byte log; never raises, whatever the bytes.

    Only what the device sent between its first HELLO and a reset is read. Frames that came twice count once, and
    those that came in the wrong order are put right by their numbers.
    """
    ledger = Ledger()
    pieces = [ledger.feed(data[at : at + PIECE]) for at in range(0, len(data), PIECE)]
    account, hello = ledger.account(), ledger.hello
    if hello is None:
        return Recording(None, np.zeros(0), {}, np.zeros(0, np.int64), account)
    parts = [piece for piece in pieces if piece is not None]
    numbers = np.concatenate([np.zeros(0, np.int64), *(part[0] for part in parts)])
    raw = np.concatenate([np.zeros(0, hello.sample_type), *(part[1] for part in parts)])
    if (np.diff(numbers) < 0).any():
        order = np.argsort(numbers, kind="stable")
        numbers, raw = numbers[order], raw[order]
    received = int(np.searchsorted(numbers, account.sent))
    numbers, raw = numbers[:received], raw[:received]
    time_us, mended = mend(unwrap_us(raw["t_us"], int(raw["t_us"][0]) if len(raw) else 0), numbers)
    channels = {c.name: raw[c.name] * c.scale + c.offset for c in hello.channels}
    return Recording(hello, time_us * 1e-6, channels, numbers, account, mended)
