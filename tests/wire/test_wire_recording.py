"""A byte log becomes samples, and every frame of it is accounted for."""

import json
import struct
import sys
import time
import tracemalloc
from collections.abc import Iterator
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pipeline.wire import Channel, Decoder, Event, Hello, Kind, Reason, encode, read_account, read_recording
from pipeline.wire.frames import END, EVENT
from pipeline.wire.growing_account import Ledger

CHANNELS = (Channel("motor_turns", "turns", "i32", 0.25, 1.0), Channel("displacement_mm", "mm", "i16", 0.02))
HELLO = Hello("a rig", "1.0", "00000001", 50.0, 2, CHANNELS)
EVERY_20_MS = 20_000


def log(count: int, first_us: int = 0, hello: Hello = HELLO) -> list[bytes]:
    """Frames of a complete recording: HELLO, `count` samples with an event before the second, END."""
    frames = [encode(Kind.HELLO, 0, hello.pack())]
    samples = np.zeros(count, hello.sample_type)
    samples["t_us"] = (first_us + np.arange(count) * EVERY_20_MS) % 2**32
    samples["motor_turns"] = np.arange(count) - 3
    samples["displacement_mm"] = np.arange(count) * 7 % 30_000
    for number, sample in enumerate(samples):
        if number == 1:
            stamp = (first_us + 12_345) % 2**32
            frames.append(encode(Kind.EVENT, len(frames), EVENT.pack(stamp, Event.STROKE_START, 1)))
        frames.append(encode(Kind.SAMPLE, len(frames), sample.tobytes()))
    return [*frames, encode(Kind.END, len(frames), END.pack(count, Reason.COMPLETE))]


def test_a_whole_recording_is_read_in_the_channels_units():
    recording = read_recording(b"".join(log(100)))
    assert recording.hello == HELLO
    np.testing.assert_allclose(recording.time_s, np.arange(100) * 0.02)
    np.testing.assert_allclose(recording.channels["motor_turns"], 0.25 * (np.arange(100) - 3) + 1.0)
    np.testing.assert_allclose(recording.channels["displacement_mm"], 0.02 * (np.arange(100) * 7))
    account = recording.account
    assert (account.sent, account.received, account.lost, account.bad) == (103, 103, 0, 0)
    assert (account.samples_sent, account.end.reason) == (100, Reason.COMPLETE)
    (event,) = recording.events
    assert (event.time_s, event.code, event.value) == (pytest.approx(0.012345), Event.STROKE_START, 1)


def test_the_count_while_it_grows_is_of_what_came_so_far_and_names_the_events():
    frames = log(100)
    ledger = Ledger()
    assert ledger.tally().received == ledger.tally().lost == 0
    ledger.feed(b"".join([*frames[:10], *frames[13:40], b"\7garbage\0", *frames[41:60]]))
    tally = ledger.tally()
    assert (tally.received, tally.lost, tally.bad) == (56, 4, 1)
    assert tally.events == ((2, Event.STROKE_START, 1),)


def test_the_clock_may_wrap():
    recording = read_recording(b"".join(log(100, first_us=2**32 - 10_000)))
    np.testing.assert_allclose(recording.time_s, np.arange(100) * 0.02)
    assert recording.events[0].time_s == pytest.approx(0.012345)


@given(st.sets(st.integers(1, 61), max_size=20))
def test_lost_frames_are_counted_and_located(lost):
    frames = log(60)  # 63 frames: HELLO, one sample, EVENT, 59 samples, END
    account = (recording := read_recording(b"".join(f for n, f in enumerate(frames) if n not in lost))).account
    assert account.sent == 63 == account.received + account.lost
    assert account.lost == len(lost) == sum(gap.frames for gap in account.gaps)
    assert len(recording.time_s) == 60 - len(lost - {2})
    for after in (gap.after_samples for gap in account.gaps):
        before = recording.seq[after - 1] if after else 0
        assert {int(before) + 1, int(before) + 2} & lost


@given(st.sets(st.integers(1, 61), max_size=12), st.sets(st.integers(1, 60), max_size=6))
def test_frames_in_the_wrong_order_are_put_right_and_losses_among_them_located(lost, swaps):
    frames = log(60)
    sent = [number for number in range(63) if number not in lost]
    for at in swaps:
        if at < len(sent) - 2:
            sent[at], sent[at + 1] = sent[at + 1], sent[at]
    recording = read_recording(b"".join(frames[number] for number in sent))
    right = read_recording(b"".join(frames[number] for number in sorted(sent)))
    assert recording.account.gaps == right.account.gaps
    assert recording.account.lost == len(lost) == sum(gap.frames for gap in recording.account.gaps)
    assert recording.events == right.events
    np.testing.assert_array_equal(recording.seq, right.seq)
    np.testing.assert_array_equal(recording.time_s, right.time_s)
    np.testing.assert_array_equal(recording.channels["motor_turns"], right.channels["motor_turns"])
    samples = [number for number in sent if number not in (0, 2, 62)]
    assert recording.account.out_of_order == sum(after < before for before, after in pairwise(samples))


def test_numbers_that_cannot_be_are_not_counted_as_losses():
    frames = log(20)  # 23 frames
    late, early = encode(Kind.SAMPLE, 2**20, b"1234567890"), encode(Kind.SAMPLE, 2**32 - 5, b"1234567890")
    account = read_recording(b"".join([*frames[:9], late, *frames[9:14], early, *frames[14:]])).account
    assert (account.sent, account.received, account.lost, account.repeated) == (23, 23, 0, 2)


@given(
    st.sets(st.integers(1, 61), max_size=12),
    st.lists(st.tuples(st.integers(0, 62), st.integers(0, 62)), max_size=6),
    st.lists(st.integers(1, 4000), min_size=1, max_size=4),
    st.binary(max_size=30),
)
@pytest.mark.long
def test_the_account_is_the_same_in_pieces_of_any_size(lost, moves, sizes, garbage):
    sent = [number for number in range(63) if number not in lost]
    for at, to in moves:  # some come late, or early, or again
        sent.insert(to % len(sent), sent[at % len(sent)])
        if at % 2:
            sent.pop(at % len(sent))
    frames = log(60, first_us=2**32 - 700_000)
    data = frames[0] + b"".join(frames[number] for number in sent[:30]) + garbage + b"\0"
    data += b"".join(frames[number] for number in sent[30:]) + garbage
    pieces, at = [], 0
    while at < len(data):
        pieces.append(data[at : at + sizes[len(pieces) % len(sizes)]])
        at += len(pieces[-1])
    hello, account = read_account(pieces)
    recording = read_recording(data)
    assert (hello, account) == (recording.hello, recording.account)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("pipeline.wire.decoded_recording.PIECE", sizes[0])
        again = read_recording(data)
    assert again.seq.tolist() == recording.seq.tolist() and again.time_s.tolist() == recording.time_s.tolist()
    assert account.sent == account.received + account.lost
    assert account.samples == len(recording.time_s)
    assert account.last_s == (pytest.approx(recording.time_s[-1]) if account.samples else 0.0)
    for gap in account.gaps:
        after_s = recording.time_s[gap.after_samples - 1] if gap.after_samples else None
        rest = recording.time_s[gap.after_samples :]
        assert gap.after_s == (after_s if after_s is None else pytest.approx(after_s, abs=1e-9))
        assert gap.until_s == (pytest.approx(rest[0], abs=1e-9) if len(rest) else None)
    for event in account.events:
        assert event.time_s == pytest.approx(0.012345 - 0.02 * int(recording.seq[0] - 1 - (recording.seq[0] > 2)))


@given(st.binary(max_size=400), st.binary(max_size=100))
def test_no_bytes_make_it_raise(garbage, more):
    read_recording(garbage)
    frames = log(10)
    read_recording(b"".join([*frames[:5], garbage, *frames[5:], more]))
    read_recording(garbage + b"\0" + b"".join(frames))


@given(st.lists(st.tuples(st.integers(0, 2000), st.integers(1, 255)), max_size=12))
def test_it_reads_the_frames_that_the_decoder_hears(flips):
    data = bytearray(b"".join(log(80)))
    for at, bits in flips:
        data[at % len(data)] ^= bits
    recording, decoder = read_recording(bytes(data)), Decoder()
    heard = [decoded.frame for decoded in decoder.feed(bytes(data))]
    assert recording.account.bad == decoder.bad
    if recording.hello == HELLO:
        assert recording.seq.tolist() == [frame.seq for frame in heard if frame.kind == Kind.SAMPLE]
        assert recording.account.sent == recording.account.received + recording.account.lost


def test_a_repeated_frame_counts_once():
    frames = log(20)
    account = read_recording(b"".join([frames[0], *frames[:5], *frames[4:], frames[-1]])).account
    assert (account.sent, account.received, account.lost, account.repeated) == (23, 23, 0, 3)


def test_what_follows_a_reset_is_not_read():
    second = Hello("a rig", "1.0", "00000002", 50.0, 2, CHANNELS)
    recording = read_recording(b"".join(log(50)[:31] + log(20, hello=second)))
    assert (recording.account.resets, recording.account.sent, recording.account.end) == (1, 31, None)
    assert len(recording.time_s) == 29


def test_what_follows_a_reset_is_not_read_in_later_pieces_either():
    second = Hello("a rig", "1.0", "00000002", 50.0, 2, CHANNELS)
    _, account = read_account(log(50)[:31] + log(60, hello=second))
    assert (account.resets, account.sent, account.samples, account.end) == (1, 31, 29, None)


def test_frames_after_the_end_are_not_of_the_recording():
    frames = log(20)
    sample, again = (encode(Kind.SAMPLE, 23, b"1234567890"), encode(Kind.END, 24, END.pack(21, Reason.STOPPED)))
    recording = read_recording(b"".join([*frames, sample, again]))
    account = recording.account
    assert (account.sent, account.received, account.samples, account.repeated) == (23, 23, 20, 2)
    assert len(recording.time_s) == 20 and account.end.samples == 20


def test_an_event_is_timed_however_often_the_clock_has_wrapped():
    step_us = 2_000_000_000  # the clock wraps at every other sample
    frames = [encode(Kind.HELLO, 0, HELLO.pack())]
    for number in range(1, 21, 2):
        stamp = number * step_us // 2
        frames.append(encode(Kind.SAMPLE, number, struct.pack("<Iih", stamp % 2**32, 0, 0)))
        frames.append(encode(Kind.EVENT, number + 1, EVENT.pack((stamp + 200_000_000) % 2**32, Event.STROKE_START, 1)))
    events = read_recording(b"".join(frames)).events
    assert [event.time_s for event in events] == pytest.approx([number * 2000 + 200 for number in range(10)])


def test_a_log_that_breaks_off_says_how_many_bytes_hang_over():
    data = b"".join(log(50)[:-2])
    account = read_recording(data + b"\5\1\2").account
    assert (account.tail_bytes, account.end, account.lost) == (3, None, 0)


@pytest.mark.parametrize("data", [b"", b"\0", b"abc", b"\0\0", b"\1\0", encode(Kind.SAMPLE, 0, b"1234")])
def test_without_a_hello_there_is_nothing(data):
    recording = read_recording(data)
    assert recording.hello is None and not len(recording.time_s) and recording.account.sent == 0


@pytest.mark.parametrize(
    ("change", "expected_words"),
    [
        ({"protocol": 3}, "protocol"),
        ({"rate_hz": 0}, "rate_hz"),
        ({"rate_hz": 1e308}, "rate_hz"),
        ({"rate_hz": 1e-308}, "rate_hz"),
        ({"strokes": -1}, "strokes"),
        ({"strokes": 10**400}, "strokes"),
        ({"device": "\ud800"}, "device"),
        ({"channels": []}, "channels"),
        ({"channels": [{"name": "a", "unit": "mm", "type": "f32", "scale": 1}]}, "type"),
        ({"channels": [{"name": "a", "unit": "mm", "type": "i16", "scale": 1e308}]}, "scale"),
        ({"channels": [{"name": "a", "unit": "mm", "type": "i16", "scale": 1, "offset": -1e31}]}, "offset"),
        ({"channels": [{"name": "a", "unit": "mm", "type": "i16", "scale": 1}] * 2}, "same name"),
        ({"nonce": 7}, "nonce"),
    ],
)
def test_a_hello_that_cannot_be_is_refused_with_the_field(change, expected_words):
    content = json.loads(HELLO.pack()) | change
    with pytest.raises(ValueError, match=expected_words):
        Hello.unpack(json.dumps(content).encode())


def test_a_hello_may_say_more_than_we_know():
    content = json.loads(HELLO.pack()) | {"colour": "red"}
    assert Hello.unpack(json.dumps(content).encode()) == HELLO


def test_a_long_recording_is_read_to_its_end():
    frames = log(150_000)
    frames[3] = frames[3][:-1] + b"\1\0"  # damaged
    recording = read_recording(b"".join(frames))
    assert len(recording.time_s) == recording.account.received - 3 == 149_999
    assert recording.time_s[-1] == pytest.approx(149_999 * 0.02)
    assert recording.channels["motor_turns"][-1] == 0.25 * (149_999 - 3) + 1.0


@pytest.mark.long
def test_the_account_of_a_long_recording_takes_no_more_memory_than_of_a_short_one():
    per_piece = 4_000

    def pieces(count: int) -> Iterator[bytes]:
        yield encode(Kind.HELLO, 0, HELLO.pack())
        for piece in range(count):
            numbers = range(1 + piece * per_piece, 1 + (piece + 1) * per_piece)
            yield b"".join(
                encode(Kind.SAMPLE, number, struct.pack("<Iih", number * 20_000 % 2**32, 1, 2)) for number in numbers
            )

    def peak(count: int) -> int:
        tracemalloc.start()
        _, account = read_account(pieces(count))
        assert account.samples == account.received - 1 == count * per_piece
        used = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return used

    peak(1)  # what is made once
    assert peak(16) < 1.1 * peak(4)


def test_numbers_that_follow_each_other_are_held_as_one_span():
    ledger = Ledger()
    frames = log(60)
    for frame in (*frames[:20], *frames[30:-1], *frames[20:29]):
        ledger.feed(frame)
    assert len(ledger._low) == len(ledger._high) == 2, "a gap of one frame"
    ledger.feed(frames[29])
    assert len(ledger._low) == len(ledger._high) == 1 and ledger.account().lost == 0


def test_a_stretch_without_an_end_takes_no_memory():
    hello, account = read_account([b"".join(log(5)[:-1]), *(b"x" * 10_000 for _ in range(50)), b"x\0", log(5)[-1]])
    assert hello == HELLO and (account.bad, account.lost, account.tail_bytes) == (1, 0, 0)
    ledger = Ledger()
    for _ in range(50):
        ledger.feed(b"x" * 10_000)
        assert sys.getsizeof(ledger._rest) < 4000
    assert ledger.account().tail_bytes == 500_000


def test_a_long_recording_is_read_fast():
    sample_frame = b"".join(log(2000)[1:2])
    data = log(1)[0] + sample_frame * 200_000
    start_s = time.process_time()
    assert read_recording(data).account.repeated == 199_999
    assert time.process_time() - start_s < 3.0
