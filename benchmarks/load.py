"""How the capture program bears 5 kHz of 6 channels: a device in a process of its own, over a pseudo-terminal.

The device keeps real time and waits for nobody: what the host leaves unread stands in a buffer of 64 kB, half a
second's worth, and a frame that finds no room there is dropped and keeps its number.

Measured for 600 s on a shared machine, both processes on one core that others used too (taskset -c 1 nice -n 10):
3 000 002 frames sent, 3 000 002 received, none lost or damaged; at most 18 300 bytes waited for the host; its memory
44.5 MB after a minute and at the end, 63.0 MB at most, the commit included; it took 5 % of the core.
"""

import argparse
import json
import multiprocessing
import os
import pty
import select
import struct
import subprocess
import sys
import tempfile
import time
import tty
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from pipeline.wire import Channel, Decoder, Hello, Kind, Reason, encode
from pipeline.wire.frames import END

ROOT = Path(__file__).resolve().parents[1]
RATE_HZ = 5000
BAUD = 2_000_000
BUFFER = 64_000
TICK_S = 0.004
SAMPLE = struct.Struct("<I6h")
CHANNELS = tuple(Channel(f"channel_{number}", "counts", "i16", 1.0) for number in range(6))
HELLO = encode(Kind.HELLO, 0, Hello("a fast rig", "1", "00000001", float(RATE_HZ), 0, CHANNELS).pack())


class Device:
    """Sends so many samples once it is started; `most` is the fullest that its buffer was, in bytes."""

    def __init__(self, end: int, samples: int) -> None:
        self.end, self.samples = end, samples
        self.waiting = bytearray()
        self.most = self.dropped = 0

    def say(self, frame: bytes) -> None:
        """Put a frame into the buffer, or drop it."""
        if len(self.waiting) + len(frame) > BUFFER:
            self.dropped += 1
            return
        self.waiting += frame
        self.most = max(self.most, len(self.waiting))

    def turn(self, wait_s: float) -> bytes:
        """Hand out what the line takes, and take what it brings."""
        readable, writable, _ = select.select([self.end], [self.end] if self.waiting else [], [], wait_s)
        if writable:
            del self.waiting[: os.write(self.end, self.waiting[:4096])]
        return os.read(self.end, 4096) if readable else b""

    def until(self, kind: Kind, again: bytes = b"") -> None:
        """Wait for the host's frame of a kind, saying something again every 0.2 s."""
        decoder, said_s = Decoder(), time.monotonic()
        while not any(heard.frame.kind == kind for heard in decoder.feed(self.turn(0.05))):
            if again and time.monotonic() - said_s > 0.2:
                said_s = time.monotonic()
                self.say(again)

    def record(self) -> None:
        """One recording from GREET to ACK."""
        self.until(Kind.GREET)
        self.say(HELLO)
        self.until(Kind.START)
        began_s, sample = time.monotonic(), 0
        while sample < self.samples:
            due = min(self.samples, int((time.monotonic() - began_s) * RATE_HZ))
            for number in range(sample, due):
                values = [(number * (at + 3)) % 30_011 for at in range(6)]
                self.say(encode(Kind.SAMPLE, number + 1, SAMPLE.pack(number * 200 % 2**32, *values)))
            sample = due
            next_s = time.monotonic() + TICK_S
            while self.waiting and time.monotonic() < next_s:
                self.turn(next_s - time.monotonic())
            time.sleep(max(0.0, next_s - time.monotonic()))
        end = encode(Kind.END, self.samples + 1, END.pack(self.samples, Reason.COMPLETE))
        self.say(end)
        self.until(Kind.ACK, end)


def _device(end: int, samples: int, told: multiprocessing.Queue) -> None:
    device = Device(end, samples)
    device.record()
    told.put((device.most, device.dropped))


@dataclass(frozen=True)
class Load:
    """What was measured; memory is the capture program's, in MB: after a tenth of the run, at its end, at most ever."""

    seconds: float
    sent: int
    received: int
    lost: int
    bad: int
    samples: int
    most_waiting_bytes: int
    host_cpu_share: float
    early_mb: float
    late_mb: float
    peak_mb: float

    def __str__(self) -> str:
        rows = [
            ("seconds at 5 kHz, 6 channels", f"{self.seconds:g}"),
            ("frames sent", self.sent),
            ("frames received", self.received),
            ("frames lost", self.lost),
            ("damaged", self.bad),
            ("most that waited for the host, bytes", self.most_waiting_bytes),
            ("host's share of one core", f"{100 * self.host_cpu_share:.1f} %"),
            ("host's memory after a tenth of it", f"{self.early_mb:.1f} MB"),
            ("at its end", f"{self.late_mb:.1f} MB"),
            ("at most, the commit included", f"{self.peak_mb:.1f} MB"),
        ]
        return "\n".join(f"| {name} | {value} |" for name, value in rows)


def _memory_mb(process: int, which: str = "VmRSS") -> float:
    lines = Path(f"/proc/{process}/status").read_text().splitlines()
    return next((int(line.split()[1]) for line in lines if line.startswith(which)), 0) / 1024


def _end(process: int) -> tuple[int, float, float]:
    """Exit status of a process that is about to end, its processor time in s and the most memory that it had, in MB."""
    peak_mb = 0.0
    while True:
        peak_mb = max(peak_mb, _memory_mb(process, "VmHWM"))
        done, status, usage = os.wait4(process, os.WNOHANG)
        if done:
            return os.waitstatus_to_exitcode(status), usage.ru_utime + usage.ru_stime, peak_mb
        time.sleep(0.01)


def measure(seconds: float, folder: Path) -> Load:
    """Record so many seconds into a run folder, which must not be there."""
    ours, theirs = pty.openpty()
    tty.setraw(theirs)
    os.set_blocking(ours, False)
    told: multiprocessing.Queue = multiprocessing.Queue()
    device = multiprocessing.Process(target=_device, args=(ours, int(seconds * RATE_HZ), told))
    device.start()
    command = [sys.executable, "-m", "pipeline.capture", os.ttyname(theirs), str(folder), "--baud", str(BAUD)]
    with folder.with_suffix(".said").open("w") as said:
        host = subprocess.Popen(command, cwd=ROOT, stdout=said, stderr=said)
    try:
        path = folder / "recording.frames"
        while not path.exists():
            if host.poll() is not None:
                raise RuntimeError(folder.with_suffix(".said").read_text())
            time.sleep(0.01)
        began_s = time.monotonic()
        time.sleep(seconds / 10)
        early_mb = _memory_mb(host.pid)
        time.sleep(max(0.0, began_s + seconds - 0.5 - time.monotonic()))
        late_mb = _memory_mb(host.pid)
        host.returncode, busy_s, peak_mb = _end(host.pid)
        if host.returncode != 0:
            raise RuntimeError(folder.with_suffix(".said").read_text())
        most, dropped = told.get(timeout=30)
        device.join()
    finally:
        for process in (host, device):
            process.kill()
        os.close(ours)
        os.close(theirs)
    info = json.loads((folder / "capture.json").read_text())
    frames = info["frames"]
    assert frames["lost"] == dropped, "what the device dropped is what the host says is lost"
    return Load(
        seconds,
        frames["sent"],
        frames["received"],
        frames["lost"],
        frames["bad"],
        info["samples"]["received"],
        most,
        busy_s / seconds,
        early_mb,
        late_mb,
        peak_mb,
    )


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=600.0)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as place:
        print(measure(arguments.seconds, Path(place) / "load-1"))


if __name__ == "__main__":
    main()
