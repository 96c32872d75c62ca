"""Faults of the device: its clock, its numbers, its END; and a device that never comes to one."""

import struct
import time
from threading import Event as Flag
from threading import Thread

import numpy as np
from bench import Bench, Row, check, complete, row
from scripted_device import CHANNELS, RATE_HZ, SAMPLES, STEP_US, Rig, frames, hello

from pipeline.run.table.captured import read_frames
from pipeline.wire import Channel, Kind, Reason, encode
from pipeline.wire.frames import END

LONGEST_S = 2


def version_1(bench: Bench) -> Row:
    """The device speaks version 1 of the protocol, as those of last year do."""
    true_frames = frames(protocol=1)
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    assert complete(bench, rig, host, true_frames, true_frames[1:]) == 0
    info = check(bench, true_frames)
    assert bench.recorded() == b"".join(true_frames) and info["hello"]["protocol"] == 1
    return row(bench, host)


def stamp_falls_back(bench: Bench) -> Row:
    """One time stamp is 65,536 us before what it should be."""
    return _mended(bench, {30: 30 * STEP_US - 65_536}, "backward_time_stamps")


def stamps_equal(bench: Bench) -> Row:
    """Two samples have one time stamp."""
    return _mended(bench, {30: 29 * STEP_US}, "repeated_time_stamps")


def _mended(bench: Bench, stamps: dict[int, int], word: str) -> Row:
    true_frames, sent = frames(), frames(stamps=stamps)
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    assert complete(bench, rig, host, sent, sent[1:]) == 0
    info = check(bench, true_frames)  # the times are those that a right clock would have said
    assert bench.recorded() == b"".join(sent) and info["samples"][word] == 1
    table, _ = read_frames(bench.run() / "recording.frames")
    np.testing.assert_allclose(table["time_s"], np.arange(SAMPLES) / RATE_HZ, atol=1e-9)
    return row(bench, host)


def clock_stands(bench: Bench) -> Row:
    """The device's clock stands from the first sample to the last."""
    return _no_clock(bench, 0, "stands")


def clock_backwards(bench: Bench) -> Row:
    """The device's clock runs backwards."""
    return _no_clock(bench, -STEP_US, "runs backwards")


def _no_clock(bench: Bench, step_us: int, how: str) -> Row:
    true_frames = frames(first_us=10_000_000, step_us=step_us)
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    assert complete(bench, rig, host, true_frames, true_frames[1:]) == 1
    info = check(bench, true_frames)
    assert info["exit_status"] == "fault" and f"the device's clock (t_us) {how}" in host.said
    return row(bench, host, lost="when the samples were taken")


def false_frame(bench: Bench) -> Row:
    """Under version 1 a damaged frame passes as one with the number 2,000,000,000, and no END comes."""
    true_frames = frames(protocol=1)
    false = encode(Kind.SAMPLE, 2_000_000_000, struct.pack("<Iih", 700_000, 30, 210), 1)
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.begin(true_frames)
    rig.say(*true_frames[1:40], false, *true_frames[40:-1])
    assert host.wait() == 1
    info = check(bench, true_frames)
    assert (info["frames"]["lost"], info["frames"]["repeated"]) == (0, 1)
    return row(bench, host, lost="nothing that is known")


def end_impossible(bench: Bench) -> Row:
    """END bears a number that cannot be; it comes again and again and is never acknowledged."""
    true_frames = frames()
    return _no_end(bench, encode(Kind.END, 4_000_000_000, END.pack(SAMPLES, Reason.COMPLETE)), true_frames)


def end_malformed(bench: Bench) -> Row:
    """END has two bytes instead of five."""
    true_frames = frames()
    return _no_end(bench, encode(Kind.END, len(true_frames) - 1, b"\1\2"), true_frames)


def _no_end(bench: Bench, end: bytes, true_frames: list[bytes]) -> Row:
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.begin(true_frames)
    rig.say(*true_frames[1:-1], end, end, end)
    assert host.wait() == 1
    assert not [frame for frame in rig.unheard() if frame.kind == Kind.ACK]
    info = check(bench, true_frames)
    assert info["exit_status"] == "fault" and info["frames"]["lost"] == 0
    return row(bench, host, lost="not known: nobody said how many were sent")


class _Again(Thread):
    """Says something again and again until it is told to be silent."""

    def __init__(self, rig: Rig, message: bytes) -> None:
        super().__init__()
        self.rig, self.said, self.silent = rig, message, Flag()

    def run(self) -> None:
        while not self.silent.wait(0.1):
            self.rig.say(self.said)


def only_hello(bench: Bench) -> Row:
    """After START the device says nothing but HELLO."""
    return _endless(bench, frames()[0], "a HELLO, again and again")


def trickle(bench: Bench) -> Row:
    """After START the device sends a byte now and then."""
    return _endless(bench, b"\7", "a HELLO and bytes that are no frame")


def _endless(bench: Bench, again: bytes, arrived: str) -> Row:
    true_frames = frames()
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run(), "--longest", LONGEST_S)
    rig.begin(true_frames)
    device = _Again(rig, again)
    device.start()
    assert host.wait() == 1
    device.silent.set()
    device.join()
    info = bench.info()
    assert info["exit_status"] == "fault" and info["ended_by"] == "--longest after 2 s"
    assert bench.recorded().startswith(true_frames[0]) and info["samples"]["received"] == 0
    return row(bench, host, arrived=arrived, lost="nothing")


def ended_by_longest(bench: Bench) -> Row:
    """The device goes on and on, and ends when it is told to."""
    true_frames = frames()
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run(), "--longest", LONGEST_S)
    rig.begin(true_frames)
    for frame in true_frames[1:41]:
        rig.say(frame)
        time.sleep(0.02)
    rig.hear(Kind.STOP)
    end = encode(Kind.END, 41, END.pack(37, Reason.STOPPED))
    rig.say(end)
    rig.hear(Kind.ACK)
    assert host.wait() == 0
    info = check(bench, true_frames)
    assert bench.recorded() == b"".join([*true_frames[:41], end]) and info["exit_status"] == "aborted"
    return row(bench, host)


def clock_channel(bench: Bench) -> Row:
    """A channel of the device is called as the clock is."""
    channels = (*CHANNELS, Channel("time_s", "ms", "u16", 1.0))
    true_frames = [encode(Kind.HELLO, 0, hello(channels=channels).pack())]
    payloads = [struct.pack("<IihH", number * STEP_US, number, number * 7, 7) for number in range(SAMPLES)]
    true_frames += [encode(Kind.SAMPLE, number, payload) for number, payload in enumerate(payloads, 1)]
    true_frames.append(encode(Kind.END, len(true_frames), END.pack(SAMPLES, Reason.COMPLETE)))
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    assert complete(bench, rig, host, true_frames, true_frames[1:]) == 0
    check(bench, true_frames)
    table, units = read_frames(bench.run() / "recording.frames")
    np.testing.assert_allclose(table["time_s"], np.arange(SAMPLES) / RATE_HZ, atol=1e-9)
    assert (table["device_time_s"] == 7).all() and "time_s" not in units
    return row(bench, host)


FAULTS = {
    "a device of version 1 of the protocol": version_1,
    "a time stamp falls back by 65,536 us": stamp_falls_back,
    "two time stamps are equal": stamps_equal,
    "the device's clock stands": clock_stands,
    "the device's clock runs backwards": clock_backwards,
    "a damaged frame passes as number 2,000,000,000 (version 1), no END": false_frame,
    "END with a number that cannot be": end_impossible,
    "END of another size": end_malformed,
    "nothing but HELLO, again and again (--longest 2)": only_hello,
    "a byte now and then (--longest 2)": trickle,
    "a device that does not end by itself (--longest 2)": ended_by_longest,
    "a channel called time_s": clock_channel,
}
