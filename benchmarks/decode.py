"""How fast a recorded stream is read, all frames at once and one by one, in the same run; prints both and the ratio."""

import argparse
import statistics
import struct
import sys
import time
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from pipeline.wire import Channel, Decoder, Hello, Kind, encode, read_recording
from pipeline.wire.frames import END

CHANNELS = tuple(Channel(f"channel_{number}", "counts", "i16", 1.0) for number in range(6))
CHUNK = 4096


def stream(count: int) -> bytes:
    """A recording of `count` samples of 6 channels at 5 kHz."""
    frames = [encode(Kind.HELLO, 0, Hello("a rig", "1", "1", 5000.0, 0, CHANNELS).pack())]
    for number in range(count):
        payload = struct.pack("<I6h", number * 200 % 2**32, *((number * k) % 30_000 for k in range(6)))
        frames.append(encode(Kind.SAMPLE, number + 1, payload))
    return b"".join([*frames, encode(Kind.END, count + 1, END.pack(count, 0))])


def one_by_one(data: bytes) -> int:
    """Frames that the decoder of the live display finds."""
    decoder = Decoder()
    return sum(len(decoder.feed(data[at : at + CHUNK])) for at in range(0, len(data), CHUNK))


def at_once(data: bytes) -> int:
    """Frames that the reader of recordings finds, samples and account included."""
    return read_recording(data).account.received


def frames_per_s(read: Callable[[bytes], int], data: bytes, count: int, times: int) -> float:
    """Median rate of so many readings, in processor time, which other programs do not take part in."""
    rates = []
    for _ in range(times):
        began_s = time.process_time()
        assert read(data) == count + 2
        rates.append((count + 2) / (time.process_time() - began_s))
    return statistics.median(rates)


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--frames", type=int, default=300_000)
    parser.add_argument("--times", type=int, default=3)
    arguments = parser.parse_args()
    data = stream(arguments.frames)
    single = frames_per_s(one_by_one, data, arguments.frames, arguments.times)
    whole = frames_per_s(at_once, data, arguments.frames, arguments.times)
    print(f"{len(data) / arguments.frames:.1f} bytes a frame")
    print(f"one by one {single / 1e6:.2f} M frames/s, at once {whole / 1e6:.2f} M frames/s: {whole / single:.1f} times")


if __name__ == "__main__":
    main()
