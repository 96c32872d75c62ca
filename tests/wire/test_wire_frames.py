"""Frames survive any chunking and garbage, and damage is noticed."""

import struct
from dataclasses import replace
from itertools import pairwise

import pytest
from cobs import cobs
from hypothesis import given
from hypothesis import strategies as st

from pipeline.wire import Channel, Decoder, Frame, Hello, Kind, encode
from pipeline.wire.check import CRC, MAX_PAYLOAD, checksum
from pipeline.wire.cobs import stuff, unstuff
from pipeline.wire.frames import MAX_STUFFED, decode
from pipeline.wire.motion import Limits

HELLO = Hello("a rig", "1.0", "00000001", 50.0, 2, (Channel("motor_turns", "turns", "i32", 0.25),))
payloads = st.binary(max_size=64) | st.binary(min_size=240, max_size=520)
frames = st.builds(Frame, st.integers(0, 255), st.integers(0, 2**32 - 1), payloads)


def sent(frame: Frame) -> bytes:
    return encode(frame.kind, frame.seq, frame.payload)


def heard(chunks: list[bytes]) -> list[Frame]:
    decoder = Decoder(2)
    return [heard.frame for chunk in chunks for heard in decoder.feed(chunk)]


def test_the_checks_are_crc_16_ccitt_false_and_crc_32():
    assert checksum(b"123456789", 1) == 0x29B1
    assert checksum(b"123456789", 2) == 0xCBF43926


@given(payloads)
def test_each_version_reads_its_own_frames_and_whoever_knows_neither_reads_both(payload):
    protocol_1_frame, two = (encode(2, 7, payload, protocol) for protocol in (1, 2))
    assert len(two) - len(protocol_1_frame) in (2, 3)
    for protocol, stream in ((1, protocol_1_frame), (2, two)):
        assert decode(stream[:-1], protocol) == decode(stream[:-1], None) == Frame(2, 7, payload, protocol)
        other = decode(stream[:-1], 3 - protocol)
        assert other is None or protocol == 2  # 16 bits agree once in 65,536


def test_what_a_device_says_first_decides_which_check_its_frames_must_have():
    for protocol in (1, 2):
        decoder = Decoder()
        hello = encode(1, 0, replace(HELLO, protocol=protocol).pack(), protocol)
        decoded = decoder.feed(encode(2, 9, b"before", 3 - protocol) + hello + encode(2, 1, b"after", 3 - protocol))
        assert decoded[0].frame.payload == b"before" and len(decoded) == 2
        assert (decoder.protocol, decoder.bad) == (protocol, 1)


def test_a_hello_under_another_versions_check_decides_nothing():
    decoder = Decoder()
    assert len(decoder.feed(encode(1, 0, replace(HELLO, protocol=2).pack(), 1))) == 1
    assert decoder.protocol is None


@pytest.mark.parametrize("kind", [kind for kind in Kind if kind >= Kind.GREET])
def test_no_command_of_one_version_is_one_of_the_other(kind):
    for seq in range(100):
        assert decode(encode(kind, seq, b"", 1)[:-1], 2) is None
        assert decode(encode(kind, seq, b"", 2)[:-1], 1) is None


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
def test_any_chunking_decodes_the_same(sent_frames, data):
    stream = b"".join(map(sent, sent_frames))
    cuts = sorted(data.draw(st.lists(st.integers(0, len(stream)), max_size=12)))
    edges = [0, *cuts, len(stream)]
    assert heard([stream[a:b] for a, b in pairwise(edges)]) == sent_frames


@given(frames)
def test_a_decoder_returns_the_exact_bytes_and_where_they_end(frame):
    (decoded,) = Decoder().feed(b"\0" + sent(frame) + b"more")
    assert decoded.raw == sent(frame)
    assert decoded.end == 1 + len(decoded.raw)


@pytest.mark.parametrize("protocol", [1, 2])
@given(frames, st.data())
def test_a_single_burst_as_long_as_the_check_is_caught(protocol, frame, data):
    bits = 8 * CRC[protocol].size
    body = bytearray(struct.pack("<BI", frame.kind, frame.seq) + frame.payload)
    body += CRC[protocol].pack(checksum(bytes(body), protocol))
    burst = data.draw(st.integers(1, 2**bits - 1)) << data.draw(st.integers(0, 8 * len(body) - bits))
    # a burst is one of neighbouring bits of what the CRC runs over: the first bit of a byte is its highest in CRC-16
    # and its lowest in CRC-32
    order = "big" if protocol == 1 else "little"
    end = len(body) - CRC[protocol].size
    flipped = bytes(a ^ b for a, b in zip(body[:end], burst.to_bytes(len(body), order)[:end], strict=True))
    damaged = stuff(flipped + bytes(body[end:]))
    assert flipped == body[:end] or decode(damaged, protocol) is None


@given(frames, st.data())
def test_a_damaged_byte_on_the_wire_is_never_another_frame(frame, data):
    stream = bytearray(sent(frame))
    stream[data.draw(st.integers(0, len(stream) - 1))] ^= data.draw(st.integers(1, 255))
    assert all(decoded == frame for decoded in heard([bytes(stream) + b"\0"]))


@given(st.binary(max_size=300), st.lists(frames, min_size=1, max_size=4))
def test_it_finds_its_way_after_garbage(garbage, sent_frames):
    heard_frames = heard([garbage + b"\0" + b"".join(map(sent, sent_frames))])
    assert heard_frames[-len(sent_frames) :] == sent_frames


@given(st.lists(st.binary(max_size=400), max_size=10))
def test_no_bytes_make_it_raise(chunks):
    heard(chunks)


def test_its_memory_is_bounded():
    decoder = Decoder()
    for _ in range(100):
        decoder.feed(b"x" * 1000)
        assert len(decoder.rest) <= MAX_STUFFED
    frame = Frame(2, 7, b"abc")
    assert [decoded.frame for decoded in decoder.feed(b"\0" + sent(frame))] == [frame]
    assert decoder.bad == 1


def test_the_longest_payload_passes_and_a_longer_one_is_refused():
    frame = Frame(1, 0, b"\1" * MAX_PAYLOAD)
    assert heard([sent(frame)]) == [frame]
    with pytest.raises(ValueError, match="longer"):
        encode(1, 0, b"\1" * (MAX_PAYLOAD + 1))


def test_a_hello_says_what_its_device_takes_of_a_program_from_version_2_on():
    limits = Limits(
        legs=8, turns=(0.0, 20.0), turns_per_s=5.0, turns_per_s2=50.0, seconds=600.0, silence_s=2.0, at_turns=0.0
    )
    for protocol, kept in ((1, None), (2, limits)):
        assert Hello.unpack(replace(HELLO, protocol=protocol, program=limits).pack()).program == kept
