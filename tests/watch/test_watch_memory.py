"""A recording of any length is followed in memory that does not grow, and nothing of its extent is lost."""

import os
import tracemalloc
from pathlib import Path

import numpy as np
import pytest
from test_watch import HELLO, folder, samples

from pipeline.watch.envelope import Envelope
from pipeline.watch.followed_recording import Followed
from pipeline.watch.snapshot import snapshot
from pipeline.wire import Kind, encode


@pytest.mark.parametrize("pieces", [[1] * 5000, [4999, 1], [7, 1000, 3993], [5000]])
def test_an_envelope_holds_the_least_and_the_greatest_whatever_the_pieces(pieces):
    rows = np.random.default_rng(1).normal(size=(5000, 2))
    envelope, at = Envelope(2, 64), 0
    for count in pieces:
        envelope.add(rows[at : at + count])
        at += count
    assert len(envelope.first) <= 64 and envelope.each == 128
    begins = np.arange(0, 5000, envelope.each)
    assert np.array_equal(envelope.first, rows[begins])
    assert np.array_equal(envelope.low, np.minimum.reduceat(rows, begins))
    assert np.array_equal(envelope.high, np.maximum.reduceat(rows, begins))
    for part, begin in enumerate(begins):
        block = rows[begin : begin + envelope.each]
        assert np.array_equal(envelope.low_s[part], block[block.argmin(axis=0), 0])
        assert np.array_equal(envelope.high_s[part], block[block.argmax(axis=0), 0])


@pytest.mark.parametrize("pieces", [[1] * 655, [655], [3, 600, 52]])
def test_few_samples_are_joined_as_they_came_over_the_twist(pieces):
    """Of 655 samples at 20 Hz, two in a part, the least and the greatest stood at one twist: a saw of 0.2 mm."""
    turns = 20.0 - np.abs(np.linspace(-20.0, 20.0, 655))
    rows = np.column_stack([np.arange(655) / 20.0, turns, 0.02 * turns**2])
    envelope, at = Envelope(3, 600, along=1), 0
    for count in pieces:
        envelope.add(rows[at : at + count])
        at += count
    assert envelope.each == 2
    for drawn, came in zip(envelope.line(2), rows[:, 1:].T, strict=True):
        assert np.array_equal(drawn, came)


def test_the_least_and_the_greatest_of_a_part_are_joined_in_the_order_in_which_they_came():
    turns = 20.0 - np.abs(np.linspace(-20.0, 20.0, 5000))
    envelope = Envelope(2, 64, along=1)
    envelope.add(np.column_stack([np.arange(5000.0), turns]))
    twist, drawn = envelope.line(1)
    assert np.array_equal(twist, drawn) and 64 < len(twist) <= 2 * 64
    top = int(np.argmax(drawn))
    assert np.all(np.diff(drawn[: top + 1]) > 0.0) and np.all(np.diff(drawn[top:]) < 0.0)


def test_what_is_no_number_stays_none_whatever_the_pieces():
    rows = np.column_stack([np.arange(64.0), np.where(np.arange(64) == 9, np.nan, 1.0)])
    whole, single = Envelope(2, 4), Envelope(2, 4)
    whole.add(rows)
    for row in rows:
        single.add(row[None])
    for envelope in (whole, single):
        assert (
            np.isnan(envelope.low[:, 1]).tolist()
            == np.isnan(envelope.high[:, 1]).tolist()
            == [True, False, False, False]
        )


@pytest.mark.long
def test_memory_and_what_is_sent_stay_flat(tmp_path: Path):
    run = folder(tmp_path)
    path, memory_bytes, sent = run / "recording.frames", [], []
    path.write_bytes(encode(Kind.HELLO, 0, HELLO.pack()))
    followed = Followed(run)
    tracemalloc.start()
    try:
        for at in range(40):  # a second each: the file is cut off before, as a day's would not fit
            with open(path, "ab") as file:
                file.write(samples(1 + 1000 * at, 1000))
            followed.poll()
            sent.append(len(snapshot(followed, tmp_path / "reports")))
            memory_bytes.append(tracemalloc.get_traced_memory()[0])
    finally:
        tracemalloc.stop()
    assert followed.samples == 40_000 and os.path.getsize(path) > 600_000
    assert memory_bytes[-1] - memory_bytes[19] < 150_000, "60 kB of curves are kept, as much came as before"
    assert max(sent) < 400_000
    assert not followed.source._ledger._runs, "nothing is kept for each piece"
