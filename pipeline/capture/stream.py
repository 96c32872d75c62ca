"""The recording itself: bytes from the port to the log until the device says END, or nothing more."""

import time
from collections.abc import Callable
from dataclasses import dataclass

from pipeline.capture.log import Log
from pipeline.capture.port import Port, Unplugged
from pipeline.capture.progress import Progress
from pipeline.wire import Decoder, Hello, Kind, Reason, encode
from pipeline.wire.frames import END

SILENCE_S = 3.0


@dataclass(frozen=True)
class Outcome:
    """How it ended: complete, aborted or fault, and for a fault a sentence."""

    status: str
    fault: str | None = None


def record(port: Port, log: Log, hello: Hello, stops: Callable[[], int]) -> Outcome:
    """Record from START to END; what is in the log afterwards is on the disk, and then the END is acknowledged.

    `stops` says how often the person has asked to stop: once sends STOP and waits for the END, twice ends it.
    """
    decoder, progress = Decoder(), Progress(hello)
    silence_s = max(SILENCE_S, 5.0 / hello.rate_hz)
    heard_s, sequence, stopped = time.monotonic(), 0, False
    outcome: Outcome | None = None
    try:
        port.write(encode(Kind.START, sequence))
        while outcome is None:
            chunk = port.read()
            outcome, used, end_seq = _look(decoder, progress, hello, chunk, stopped)
            log.append(chunk[:used])
            progress.bad = decoder.bad
            progress.show(log.free_bytes)
            now_s = time.monotonic()
            heard_s = now_s if chunk else heard_s
            if outcome is not None:
                log.sync()
                if end_seq is not None:
                    port.write(encode(Kind.ACK, end_seq))
            elif stops() > 1:
                outcome = Outcome("aborted")
            elif stops() and not stopped:
                stopped, sequence = True, sequence + 1
                port.write(encode(Kind.STOP, sequence))
            elif now_s - heard_s > silence_s:
                fault = f"the device said nothing for {silence_s:g} s"
                outcome = Outcome("aborted" if stopped else "fault", fault)
    except Unplugged as error:
        # a device that goes away as soon as it has read the ACK takes nothing from the outcome
        outcome = outcome or Outcome("aborted" if stopped else "fault", f"the port went away ({error})")
    log.sync()
    progress.show(last=True)
    return outcome


def _look(
    decoder: Decoder, progress: Progress, hello: Hello, chunk: bytes, stopped: bool
) -> tuple[Outcome | None, int, int | None]:
    """What a chunk means: an outcome if it ends the recording, its bytes that belong to it, and the END's number."""
    for heard in decoder.feed(chunk):
        frame = heard.frame
        progress.count(frame)
        if frame.kind == Kind.END and len(frame.payload) == END.size:
            _, reason = END.unpack(frame.payload)
            if reason == Reason.FAULT:
                return Outcome("fault", "the device reported a fault"), heard.end, frame.seq
            complete = reason == Reason.COMPLETE and not stopped
            return Outcome("complete" if complete else "aborted"), heard.end, frame.seq
        if frame.kind == Kind.HELLO and not _same(frame.payload, hello):
            return Outcome("fault", "the device was reset"), len(chunk), None
    return None, len(chunk), None


def _same(payload: bytes, hello: Hello) -> bool:
    try:
        return Hello.unpack(payload).nonce == hello.nonce
    except ValueError:
        return True  # not readable: nothing that tells of a reset
