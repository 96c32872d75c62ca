"""Guided by coverage, looks for bytes from a device that the host cannot bear: a crash, a hang or unbounded memory.

The first minute found that a HELLO with a rate of 1e308 Hz ended the program with an OverflowError; since then rates,
strokes and texts that cannot be are refused. After that 49 675 inputs in 20 minutes, on a shared machine, found
nothing: no crash, no input over 10 s, no invariant broken, memory between 71 and 84 MB.
Since then the target draws its choices from the bytes by itself, so that the tests run it without atheris too; the 20
minutes were not repeated.
"""

import argparse
import contextlib
import io
import json
import sys
import tempfile
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

try:
    import atheris
except ImportError:  # the target alone can be used without it
    atheris = None

# atheris loses a reference whenever arrays are compared in code that it watches: memory would grow by 10 kB an input
ARRAYS = ["pipeline.wire.batch", "pipeline.wire.growing_account"]
with atheris.instrument_imports(include=["pipeline"], exclude=ARRAYS) if atheris else contextlib.nullcontext():
    from pipeline.capture.commit import Read, account
    from pipeline.capture.guess import guess
    from pipeline.capture.printed.holes import Steps, find
    from pipeline.capture.printed.lines import Lines, Splitter
    from pipeline.capture.recording_progress import Progress
    from pipeline.capture.stream import Outcome
    from pipeline.wire import Channel, Decoder, Hello, Kind, encode, read_account, read_recording
    from pipeline.wire.frames import MAX_PAYLOAD, MAX_STUFFED

TIMEOUT_S = 10
MEMORY_MB = 400
LONGEST = 3000
NOW = datetime(2026, 1, 1, tzinfo=UTC)
CHANNELS = (Channel("motor_turns", "turns", "i32", 0.25), Channel("displacement_mm", "mm", "i16", 0.02))
HELLO = Hello("a rig", "1", "1", 50.0, 2, CHANNELS).pack()
JSON = [
    json.loads(HELLO),
    "strokes",
    "rate_hz",
    "scale",
    "offset",
    "\ud800",
    10**400,
    -1,
    1e308,
    1e-308,
    None,
    [],
    True,
]


class Choices:
    """Choices that bytes decide, until there are none left."""

    def __init__(self, data: bytes) -> None:
        self.rest = data

    def take(self, size: int) -> bytes:
        """The next bytes; fewer at the end."""
        taken, self.rest = self.rest[:size], self.rest[size:]
        return taken

    def number(self, low: int, high: int) -> int:
        """A whole number of a range, both ends included."""
        return low + int.from_bytes(self.take(2)) % (high - low + 1)

    def pick(self, some: list[Any]) -> Any:
        """One of some."""
        return some[self.number(0, len(some) - 1)]


def said(data: bytes) -> tuple[list[bytes], bytes]:
    """What a device says, as `data` has it: good frames of any kind, damaged ones and noise; in chunks, and as text."""
    choose = Choices(data)
    chunks, number = [], 0
    while choose.rest and len(chunks) < 300:
        which = choose.number(0, 9)
        if which == 0:
            chunk = choose.take(choose.number(0, 300))
        elif which == 1:
            hello = json.loads(HELLO)
            where = choose.pick([hello, *hello["channels"]])
            where[choose.pick(list(where))] = choose.pick(JSON)
            chunk = encode(Kind.HELLO, 0, json.dumps(hello).encode()[:MAX_PAYLOAD])
        elif which == 2:
            chunk = encode(Kind.HELLO, 0, HELLO)
        else:
            number = (number + (choose.number(0, 2**16 - 1) ** 2 if which == 3 else 1)) % 2**32
            kind = choose.pick([*Kind, 99]) if which < 6 else Kind.SAMPLE
            size = choose.number(0, 600) if which == 4 else {Kind.EVENT: 9, Kind.END: 5}.get(kind, 10)
            chunk = encode(kind, number, choose.take(size).ljust(size, b"\1"))
            if which == 5:
                chunk = chunk[: choose.number(0, len(chunk))]
        chunks.append(chunk)
    return chunks, data


def bear(data: bytes) -> None:
    """All that the host does with what a device says, but for writing it down."""
    chunks, text = said(data)
    log = b"".join(chunks)
    decoder, hello, frames = Decoder(), None, 0
    progress: Progress | None = None
    for chunk in chunks:
        for heard in decoder.feed(chunk):
            frames += 1
            if hello is None and heard.frame.kind == Kind.HELLO:
                with contextlib.suppress(ValueError):
                    hello = Hello.unpack(heard.frame.payload)
                    progress = Progress(hello)
            elif progress is not None:
                progress.count(heard.frame)
        assert len(decoder.rest) <= MAX_STUFFED
    if progress is not None:
        progress.show(1, last=True)
        progress.show(1)

    recording = read_recording(log)
    found = recording.account
    assert (recording.hello is None) == (hello is None) and found.bad == decoder.bad and found.received <= frames
    assert found.sent == found.received + found.lost and found.lost == sum(gap.frames for gap in found.gaps)
    assert found.samples == len(recording.time_s) and min(found.lost, found.repeated, found.out_of_order) >= 0
    assert (recording.hello, found) == read_account(chunks)
    info = account(Read(recording.hello, found, len(log), ""), NOW, NOW, Outcome("complete"))
    json.dumps(info, indent=1, ensure_ascii=False).encode()
    if log:
        guess(log, 115_200)
    for columns in ((), ("time_ms", "motor_turns")):
        lines, steps = Lines(columns), Steps()
        rows = [row for row in map(lines.take, Splitter().feed(text)) if row is not None]
        assert all(len(row) == len(lines.columns) for row in rows) and lines.good == len(rows)
        lines.problem()
        if lines.time_at >= 0:
            times = [float(row[lines.time_at]) for row in rows]
            for time in times:
                steps.take(time)
            find(times, steps.usual)


def one(data: bytes) -> None:
    """One input of the fuzzer's."""
    with contextlib.redirect_stdout(io.StringIO()):
        bear(data)


def main() -> None:
    """Look for so many seconds; the exit status is 0 when nothing was found."""
    if atheris is None:
        sys.exit("this needs atheris: pip install atheris")
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=int, default=60)
    parser.add_argument("corpus", type=Path, nargs="?", help="a folder that keeps what opens new ways")
    arguments = parser.parse_args()
    limits = [f"-max_total_time={arguments.seconds}", f"-timeout={TIMEOUT_S}", f"-rss_limit_mb={MEMORY_MB}"]
    corpus = [str(arguments.corpus)] if arguments.corpus else []
    atheris.Setup(
        [
            "fuzz",
            *limits,
            f"-max_len={LONGEST}",
            "-len_control=0",
            f"-artifact_prefix={tempfile.gettempdir()}/",
            *corpus,
        ],
        one,
    )
    atheris.Fuzz()


if __name__ == "__main__":
    main()
