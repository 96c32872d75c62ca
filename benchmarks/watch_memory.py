"""A day of 1 kHz through the reader of `pipeline.watch`, as fast as it goes: memory, time and what is sent.

Frames are appended to a file of a temporary folder: a day takes 2.8 GB of it.
Run as `python benchmarks/watch_memory.py [HOURS]`; it prints a line an hour.
"""

import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import psutil

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from pipeline.watch.followed_recording import Followed
from pipeline.watch.snapshot import snapshot
from pipeline.wire import Channel, Event, Hello, Kind, encode
from pipeline.wire.frames import EVENT

RATE_HZ, LOOK_S, STROKE_S = 1000, 5.0, 30
NAMES = ("motor_turns", "displacement_mm", "load_n")
HELLO = Hello("a rig", "1", "1", RATE_HZ, 0, tuple(Channel(name, "", "i32", 0.001) for name in NAMES))
SAMPLE = np.dtype(HELLO.sample_type)


def main() -> None:
    """Feed the hours, five seconds of samples at each look."""
    hours = float(sys.argv[1]) if len(sys.argv) > 1 else 24.0
    each = int(RATE_HZ * LOOK_S)
    process, began_s, read_s, longest_s = psutil.Process(), time.monotonic(), 0.0, 0.0
    with tempfile.TemporaryDirectory() as place:
        path = Path(place) / "run-1" / "recording.frames"
        path.parent.mkdir()
        with open(path, "wb") as file:
            file.write(encode(Kind.HELLO, 0, HELLO.pack()))
            followed, number = Followed(path.parent), 1
            for look in range(int(hours * 3600 / LOOK_S)):
                if look % int(STROKE_S / LOOK_S) == 0:
                    stroke = EVENT.pack(0, Event.STROKE_START, look + 1)
                    file.write(encode(Kind.EVENT, number, stroke))
                    number += 1
                rows = np.zeros(each, SAMPLE)
                time_s = (look * each + np.arange(each)) / RATE_HZ
                rows["t_us"] = (time_s * 1e6).astype(np.int64) % 2**32
                rows["motor_turns"] = 10_000 * (1 - np.cos(2 * np.pi * time_s / STROKE_S))
                rows["displacement_mm"] = rows["motor_turns"] // 2
                file.write(b"".join(encode(Kind.SAMPLE, number + k, row.tobytes()) for k, row in enumerate(rows)))
                file.flush()
                number += each
                at_s = time.monotonic()
                followed.poll()
                sent = len(snapshot(followed, path.parent))
                took_s = time.monotonic() - at_s
                read_s, longest_s = read_s + took_s, max(longest_s, took_s)
                if (look + 1) % int(3600 / LOOK_S) == 0 or look == 60:
                    held = process.memory_info().rss / 1e6
                    look_ms = f"{1e3 * read_s / (look + 1):.1f} ms a look (longest {1e3 * longest_s:.0f})"
                    passed_s = time.monotonic() - began_s
                    print(
                        f"{(look + 1) * LOOK_S / 3600:5.2f} h: {followed.samples} samples, {held:.1f} MB held, "
                        f"{sent} bytes sent, {look_ms}, {passed_s:.0f} s",
                        flush=True,
                    )


if __name__ == "__main__":
    main()
