"""Faults of the line and of the device: what is sent is not what should be."""

import time

from bench import Bench, Row, check, complete, refused, row
from scripted_device import SAMPLES, frames, hello, received

from pipeline.wire import Kind, encode, read_recording


def bit_flips(bench: Bench) -> Row:
    """Bits flip in three samples and in the first END."""
    true_frames = frames()
    sent = list(true_frames)
    for number, at, bits in ((10, 3, 0x01), (20, 6, 0x80), (21, 9, 0x10)):
        damaged = bytearray(true_frames[number])
        damaged[at] ^= bits if damaged[at] != bits else bits ^ 0x03
        sent[number] = bytes(damaged)
    broken_end = bytearray(true_frames[-1])
    broken_end[2] ^= 0x04
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    assert complete(bench, rig, host, true_frames, [*sent[1:-1], bytes(broken_end), true_frames[-1]]) == 0
    info = check(bench, true_frames)
    assert bench.recorded() == b"".join([*sent[:-1], bytes(broken_end), true_frames[-1]])
    assert (info["exit_status"], info["frames"]["lost"], info["frames"]["bad"]) == ("complete", 3, 4)
    return row(bench, host)


def dropped(bench: Bench) -> Row:
    """Frames are dropped: two samples in a stroke, and a stroke's start with its neighbours."""
    true_frames = frames()
    sent = [frame for number, frame in enumerate(true_frames) if number not in (12, 13, 34, 35, 36)]
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    assert complete(bench, rig, host, true_frames, sent[1:]) == 0
    info = check(bench, true_frames)
    assert bench.recorded() == b"".join(sent) and info["frames"]["lost"] == 5
    assert [gap["strokes"] for gap in info["gaps"]] == [[1], [2]]
    return row(bench, host)


def duplicated(bench: Bench) -> Row:
    """Frames come twice."""
    true_frames = frames()
    sent = [frame for number, frame in enumerate(true_frames) for _ in range(2 if 7 <= number < 12 else 1)]
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    assert complete(bench, rig, host, true_frames, sent[1:]) == 0
    info = check(bench, true_frames)
    assert bench.recorded() == b"".join(sent) and info["frames"]["repeated"] == 5
    assert info["frames"]["lost"] == 0 and info["samples"]["received"] == SAMPLES
    return row(bench, host)


def swapped(bench: Bench) -> Row:
    """Two frames come in the wrong order."""
    true_frames = frames()
    sent = list(true_frames)
    sent[10], sent[11] = sent[11], sent[10]
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    assert complete(bench, rig, host, true_frames, sent[1:]) == 0
    info = check(bench, true_frames)
    assert bench.recorded() == b"".join(sent) and info["frames"]["lost"] == 0
    assert info["samples"]["out_of_order"] == 1
    return row(bench, host)


def swapped_and_dropped(bench: Bench) -> Row:
    """Two frames come in the wrong order, others not at all."""
    true_frames = frames()
    sent = list(true_frames)
    sent[10], sent[11] = sent[11], sent[10]
    del sent[40:42]
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    assert complete(bench, rig, host, true_frames, sent[1:]) == 0
    info = check(bench, true_frames)
    (gap,) = info["gaps"]
    assert (gap["frames"], gap["after_s"], gap["strokes"]) == (2, 0.7, [2])
    assert info["samples"]["out_of_order"] == 1
    return row(bench, host)


def reset(bench: Bench) -> Row:
    """The device is reset in the middle of the run and says HELLO with another nonce."""
    true_frames = frames()
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.begin(true_frames)
    rig.say(*true_frames[1:31])
    time.sleep(0.3)
    rig.say(frames(nonce="00000002")[0])
    assert host.wait() == 1
    info = check(bench, true_frames)
    assert info["exit_status"] == "fault" and info["frames"]["resets"] == 1 and info["frames"]["received"] == 31
    return row(bench, host, lost="nothing up to the reset")


def clock_wrap(bench: Bench) -> Row:
    """The device's 32-bit clock of microseconds wraps in the middle of a stroke."""
    true_frames = frames(first_us=2**32 - 300_000)
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    assert complete(bench, rig, host, true_frames, true_frames[1:]) == 0
    check(bench, true_frames)
    time_s = read_recording(bench.recorded()).time_s
    assert abs(time_s[-1] - (SAMPLES - 1) * 0.02) < 1e-6 and (time_s[1:] > time_s[:-1]).all()
    return row(bench, host)


def hello_lost(bench: Bench) -> Row:
    """The first HELLO is lost on the line."""
    true_frames = frames()
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.hear(Kind.GREET)
    rig.say(true_frames[0][:20] + b"\0")
    assert complete(bench, rig, host, true_frames, true_frames[1:]) == 0
    info = check(bench, true_frames)
    assert bench.recorded() == b"".join(true_frames) and info["frames"]["bad"] == 0
    return row(bench, host)


def end_unacknowledged(bench: Bench) -> Row:
    """No ACK reaches the device, which says END on and on, into the next run."""
    true_frames, again = frames(), frames(nonce="00000002")
    rig = bench.rig()
    first = bench.capture(rig.name, bench.run(1))
    rig.begin(true_frames)
    rig.say(*true_frames[1:])
    assert first.wait() == 0
    second = bench.capture(rig.name, bench.run(2))
    rig.hear(Kind.GREET)
    rig.say(true_frames[-1], true_frames[-1], again[0])
    rig.hear(Kind.START)
    rig.say(*again[1:])
    rig.hear(Kind.ACK)  # the first run's
    assert second.wait() == 0
    check(bench, true_frames, 1)
    check(bench, again, 2)
    assert bench.recorded(1) == b"".join(true_frames) and bench.recorded(2) == b"".join(again)
    return row(bench, first, second, arrived="66 of 66 frames, in both runs")


def end_missing(bench: Bench) -> Row:
    """The device falls silent without an END."""
    true_frames = frames()
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.begin(true_frames)
    rig.say(*true_frames[1:-1])
    assert host.wait() == 1
    info = check(bench, true_frames)
    assert bench.recorded() == b"".join(true_frames[:-1]) and info["exit_status"] == "fault"
    return row(bench, host, lost="not known: nobody said how many were sent")


def garbage(bench: Bench) -> Row:
    """The port sends noise."""
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.hear(Kind.GREET)
    rig.say(bytes(range(7, 256)) * 20)
    assert host.wait() == 2
    return refused(bench, host, arrived="4980 bytes, no frame")


def wrong_baud(bench: Bench) -> Row:
    """The device sends at half the host's baud rate: every bit is read twice."""
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.hear(Kind.GREET)
    slow = received(b"".join(frames()), faster=2)
    rig.say(slow)
    assert host.wait() == 2 and "lower baud rate" in host.said
    return refused(bench, host, arrived=f"{len(slow)} bytes, no frame")


def prints_text(bench: Bench) -> Row:
    """The rig prints lines and speaks no protocol."""
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.hear(Kind.GREET)
    rig.say(b"12.5,0.25,1.75\r\n" * 50)
    assert host.wait() == 2 and "--text" in host.said
    return refused(bench, host, arrived="50 lines of text")


def frozen(bench: Bench) -> Row:
    """The displacement sensor never changes while the motor turns."""
    return _warned(bench, frames(rise=0), "has not changed")


def wrong_way(bench: Bench) -> Row:
    """The displacement falls while the motor winds."""
    return _warned(bench, frames(rise=-7), "falls while the motor winds")


def _warned(bench: Bench, true_frames: list[bytes], sentence: str) -> Row:
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.begin(true_frames)
    rig.say(*true_frames[1:-1])
    until_s = time.monotonic() + 3.0
    while sentence not in host.said:  # before the END: while it records
        assert time.monotonic() < until_s
        time.sleep(0.02)
    rig.say(true_frames[-1])
    rig.hear(Kind.ACK)
    assert host.wait() == 0
    check(bench, true_frames)
    assert bench.recorded() == b"".join(true_frames) and host.said.count(sentence) == 1
    return row(bench, host)


def silent(bench: Bench) -> Row:
    """The port is silent."""
    host = bench.capture(bench.rig().name, bench.run())
    assert host.wait() == 2
    return refused(bench, host, arrived="nothing")


def wrong_version(bench: Bench) -> Row:
    """The device speaks another version of the protocol."""
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.hear(Kind.GREET)
    rig.say(encode(Kind.HELLO, 0, hello().pack().replace(b'"protocol":2', b'"protocol":3')))
    assert host.wait() == 2
    return refused(bench, host, arrived="a HELLO of version 3")


FAULTS = {
    "bit flips in three samples and in END": bit_flips,
    "frames dropped": dropped,
    "frames duplicated": duplicated,
    "frames swapped": swapped,
    "frames swapped, others dropped": swapped_and_dropped,
    "device reset in the run": reset,
    "device clock wraps": clock_wrap,
    "first HELLO lost": hello_lost,
    "END never acknowledged": end_unacknowledged,
    "END never sent": end_missing,
    "garbage on the port": garbage,
    "wrong baud rate": wrong_baud,
    "text instead of frames": prints_text,
    "frozen displacement": frozen,
    "displacement the wrong way": wrong_way,
    "silent port": silent,
    "another protocol version": wrong_version,
}
