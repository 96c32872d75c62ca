"""Frames survive any chunking and garbage, and damage is noticed."""

import struct
from itertools import pairwise

import pytest
from cobs import cobs
from hypothesis import given
from hypothesis import strategies as st

from pipeline.wire import Decoder, Frame, encode
from pipeline.wire.cobs import stuff, unstuff
from pipeline.wire.frames import MAX_PAYLOAD, MAX_STUFFED, checksum, decode

payloads = st.binary(max_size=64) | st.binary(min_size=240, max_size=520)
frames = st.builds(Frame, st.integers(0, 255), st.integers(0, 2**32 - 1), payloads)


def sent(frame: Frame) -> bytes:
    return encode(frame.kind, frame.seq, frame.payload)


def heard(chunks: list[bytes]) -> list[Frame]:
    decoder = Decoder()
    return [heard.frame for chunk in chunks for heard in decoder.feed(chunk)]


def test_the_checksum_is_crc_16_ccitt_false():
    assert checksum(b"123456789") == 0x29B1


@given(st.binary(max_size=1000) | st.binary().map(lambda data: data * 300).filter(lambda data: len(data) < 4000))
def test_stuffing_is_that_of_the_cobs_package(data):
    assert stuff(data) == cobs.encode(data)
    assert unstuff(stuff(data)) == data


@given(st.binary(min_size=1, max_size=600))
def test_unstuffing_refuses_what_the_cobs_package_refuses(data):
    try:
        expected = cobs.decode(data)
    except cobs.DecodeError:
        expected = None
    assert unstuff(data) == expected


@given(st.lists(frames, max_size=8), st.data())
def test_any_chunking_decodes_the_same(said, data):
    stream = b"".join(map(sent, said))
    cuts = sorted(data.draw(st.lists(st.integers(0, len(stream)), max_size=12)))
    edges = [0, *cuts, len(stream)]
    assert heard([stream[a:b] for a, b in pairwise(edges)]) == said


@given(frames)
def test_a_decoder_returns_the_exact_bytes_and_where_they_end(frame):
    (one,) = Decoder().feed(b"\0" + sent(frame) + b"more")
    assert one.raw == sent(frame)
    assert one.end == 1 + len(one.raw)


@given(frames, st.data())
def test_a_single_burst_of_up_to_16_bits_is_caught(frame, data):
    body = bytearray(struct.pack("<BI", frame.kind, frame.seq) + frame.payload)
    body += struct.pack("<H", checksum(bytes(body)))
    burst = data.draw(st.integers(1, 0xFFFF)) << data.draw(st.integers(0, 8 * len(body) - 16))
    # the checksum is little-endian on the wire: a burst is one of neighbouring bits of what the CRC runs over
    end = len(body) - 2
    flipped = bytes(a ^ b for a, b in zip(body[:end], burst.to_bytes(len(body), "big")[:end], strict=True))
    damaged = stuff(flipped + bytes(body[end:]))
    assert flipped == body[:end] or decode(damaged) is None


@given(frames, st.data())
def test_a_damaged_byte_on_the_wire_is_never_another_frame(frame, data):
    stream = bytearray(sent(frame))
    stream[data.draw(st.integers(0, len(stream) - 1))] ^= data.draw(st.integers(1, 255))
    assert all(found == frame for found in heard([bytes(stream) + b"\0"]))


@given(st.binary(max_size=300), st.lists(frames, min_size=1, max_size=4))
def test_it_finds_its_way_after_garbage(garbage, said):
    found = heard([garbage + b"\0" + b"".join(map(sent, said))])
    assert found[-len(said) :] == said


@given(st.lists(st.binary(max_size=400), max_size=10))
def test_no_bytes_make_it_raise(chunks):
    heard(chunks)


def test_its_memory_is_bounded():
    decoder = Decoder()
    for _ in range(100):
        decoder.feed(b"x" * 1000)
        assert len(decoder.rest) <= MAX_STUFFED
    frame = Frame(2, 7, b"abc")
    assert [one.frame for one in decoder.feed(b"\0" + sent(frame))] == [frame]
    assert decoder.bad == 1


def test_the_longest_payload_passes_and_a_longer_one_is_refused():
    frame = Frame(1, 0, b"\1" * MAX_PAYLOAD)
    assert heard([sent(frame)]) == [frame]
    with pytest.raises(ValueError, match="longer"):
        encode(1, 0, b"\1" * (MAX_PAYLOAD + 1))
