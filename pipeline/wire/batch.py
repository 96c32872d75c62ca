"""Many frames at once: the frames of a whole byte log as numpy arrays, short ones decoded side by side."""

import zlib
from binascii import crc_hqx
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .check import CRC, PROTOCOL
from .counters import Whole
from .frames import HEAD, MAX_STUFFED, Kind, decode
from .hello import Hello

Bytes = NDArray[np.uint8]

LONGEST_SHORT = 254  # stuffed bytes; up to here COBS has no group of 254 and needs no special case
ROWS = 1 << 16  # decoded side by side: what the processor's cache holds
_TABLE_16 = np.array([crc_hqx(bytes([byte]), 0) for byte in range(256)], np.uint16)
_TABLE_32 = ~np.array([zlib.crc32(bytes([byte]), 0xFFFFFFFF) for byte in range(256)], np.uint32)


@dataclass(frozen=True)
class Batch:
    """Good frames in the order of the log, and where bad ones begin.

    kind, seq, start, end: shape (frames,), as counts and places.

    `start` and `end` are positions in the log, `end` after the zero byte.
    `payloads` has each frame's payload by its position in these arrays, short ones of one length as a matrix.
    """

    kind: Whole
    seq: Whole
    start: Whole
    end: Whole
    bad_at: Whole
    matrices: list[tuple[Whole, Bytes]]  # rows' frame numbers, and payloads of shape (rows, length)
    long: dict[int, bytes]
    tail: int  # bytes after the last zero: a frame that was cut off

    def payload(self, frame: int) -> bytes:
        """Payload of one frame."""
        if frame in self.long:
            return self.long[frame]
        for frames, payloads in self.matrices:
            row = int(np.searchsorted(frames, frame))
            if row < len(frames) and frames[row] == frame:
                return payloads[row].tobytes()
        raise IndexError(frame)


def unstuff_rows(rows: Bytes) -> tuple[Bytes, NDArray[np.bool_]]:
    """Unstuff stuffed frames of one length, at most LONGEST_SHORT: shapes (n, length) → (n, length − 1), (n,).

    The second array says which rows were stuffed properly. No row may hold a zero.
    Rows hold frames, as bytes.
    """
    length = rows.shape[1]
    code_at = rows[:, 0].astype(np.int16)  # where the next code byte stands
    data = np.empty((len(rows), length - 1), np.uint8)
    for column in range(1, length):
        byte = rows[:, column]
        is_code = code_at == column
        data[:, column - 1] = np.where(is_code, 0, byte)
        code_at += np.where(is_code, byte, 0).astype(np.int16)
    return data, code_at == length


def checksum_rows(rows: Bytes, protocol: int = PROTOCOL) -> NDArray[np.unsignedinteger[Any]]:
    """A protocol's check of every row: shape (n, length) → (n,). Rows are given as bytes; a check is without a unit."""
    if protocol == 1:
        short = np.full(len(rows), 0xFFFF, np.uint16)
        for column in range(rows.shape[1]):
            short = (short << 8) ^ _TABLE_16[(short >> 8) ^ rows[:, column]]
        return short
    crc = np.full(len(rows), 0xFFFFFFFF, np.uint32)
    for column in range(rows.shape[1]):
        crc = (crc >> 8) ^ _TABLE_32[(crc & 0xFF) ^ rows[:, column]]
    return ~crc


def _short(log: Bytes, start: Whole, length: int, protocol: int) -> Iterator[tuple[Whole, Bytes, NDArray[np.bool_]]]:
    """Positions, frames without their check, and which are good, for stuffed frames of one length."""
    size = CRC[protocol].size
    for first in range(0, len(start), ROWS):
        block = start[first : first + ROWS]
        body, good = unstuff_rows(log[block[:, None] + np.arange(length)])
        data, check = body[:, :-size], np.ascontiguousarray(body[:, -size:])
        yield block, data, good & (checksum_rows(data, protocol) == check.view(f"<u{size}")[:, 0])


def read_batch(data: bytes, protocol: int = PROTOCOL) -> Batch:
    """All frames of a byte log in one version of the protocol; never raises, whatever the bytes."""
    least = HEAD.size + CRC[protocol].size
    log = np.frombuffer(data, np.uint8)
    zeros = np.flatnonzero(log == 0).astype(np.int64)
    starts = np.concatenate([[0], zeros[:-1] + 1]).astype(np.int64) if len(zeros) else zeros
    lengths = zeros - starts
    bad = [starts[(lengths > MAX_STUFFED) | ((lengths > 0) & (lengths <= least))]]
    blocks: list[tuple[Whole, Bytes]] = []  # positions, and whole frames as rows
    lone: list[tuple[int, int, int, bytes]] = []
    for length in np.unique(lengths[(lengths > least) & (lengths <= LONGEST_SHORT)]).tolist():
        for block, rows, good in _short(log, starts[lengths == length], length, protocol):
            bad.append(block[~good])
            blocks.append((block[good], rows[good]))
    for number in np.flatnonzero((lengths > LONGEST_SHORT) & (lengths <= MAX_STUFFED)).tolist():
        at = int(starts[number])
        frame = decode(data[at : int(zeros[number])], protocol)
        if frame is None:
            bad.append(np.array([at], np.int64))
        else:
            lone.append((at, frame.kind, frame.seq, frame.payload))

    def joined(parts: list[Whole], last: list[int]) -> Whole:
        return np.concatenate([*parts, np.array(last, np.int64)])

    heads = [rows[:, : HEAD.size].astype(np.int64) for _, rows in blocks]
    start = joined([block for block, _ in blocks], [frame[0] for frame in lone])
    kind = joined([head[:, 0] for head in heads], [frame[1] for frame in lone])
    seq = joined([head[:, 1:] @ (1 << np.arange(0, 32, 8)) for head in heads], [frame[2] for frame in lone])
    order = np.argsort(start, kind="stable")
    start = start[order]
    ends = zeros[np.searchsorted(zeros, start)] + 1 if len(zeros) else zeros
    matrices = [(np.searchsorted(start, block), rows[:, HEAD.size :]) for block, rows in blocks if len(block)]
    long = {int(np.searchsorted(start, frame[0])): frame[3] for frame in lone}
    tail = len(data) - (int(zeros[-1]) + 1 if len(zeros) else 0)
    return Batch(kind[order], seq[order], start, ends, np.sort(np.concatenate(bad)), matrices, long, tail)


def samples_of(batch: Batch, hello: Hello, frames: Whole) -> tuple[Whole, NDArray[np.void]]:
    """Places among `frames` of the SAMPLE frames, rising, and the samples in them under the HELLO's type.

    Both of shape (samples,): places, and numbers of a sample, as counts of the channel's quantum.
    """
    layout = np.dtype(hello.sample_type)
    as_they_came = np.argsort(frames, kind="stable")
    came = frames[as_they_came]
    places, rows = [np.zeros(0, np.int64)], [np.zeros(0, layout)]
    for members, payloads in batch.matrices:  # several, if there are many frames
        if payloads.shape[1] != layout.itemsize:
            continue
        at = np.minimum(np.searchsorted(came, members), len(came) - 1)
        is_sample = (came[at] == members) & (batch.kind[members] == Kind.SAMPLE)
        places.append(as_they_came[at[is_sample]])
        rows.append(np.ascontiguousarray(payloads[is_sample]).view(layout)[:, 0])
    place, samples = np.concatenate(places), np.concatenate(rows)
    order = np.argsort(place, kind="stable")
    return place[order], samples[order]
