"""The recording itself: bytes from the port to the log until the device says END, or nothing more."""

import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from ..run.ended_words import ABORTED, PERSON
from ..wire import Decoder, Frame, Hello, Kind, Reason, encode
from ..wire.frames import END
from .log import Log
from .port import Port, Unplugged
from .recording_progress import Progress

SILENCE_S = 3.0
STOP_S = 5.0  # so long may a device go on that was told to stop
IDLE_S = 60.0  # so long may bytes come and no new frame
BEAT_S = 0.25  # the host is heard so often by a device that follows a program
WRONG_ENDS = 3  # an END that cannot be true is a fault when it comes again and again


@dataclass(frozen=True)
class Outcome:
    """How it ended: complete, aborted, recovered or fault.

    `fault` is a sentence where something went wrong, `ended_by` says what ended it where that is no fault.
    `screen_mend` is the mend that the screen has shown while no line could be read.
    """

    status: str
    fault: str | None = None
    ended_by: str | None = None
    screen_mend: str = ""


class Listener:
    """Looks at the bytes that come: whether they end the recording, and how many of them belong to it."""

    def __init__(self, hello: Hello, motion_s: float | None = None, folder: Path | None = None) -> None:
        self.hello, self.decoder, self.progress = hello, Decoder(hello.protocol), Progress(hello, motion_s, folder)
        self.end_seq: int | None = None  # of an END that is to be acknowledged
        self._wrong_ends = 0

    def look(self, chunk: bytes) -> tuple[Outcome | None, int]:
        """An outcome if a chunk ends the recording, and the chunk's bytes that belong to it."""
        for heard in self.decoder.feed(chunk):
            outcome = self._take(heard.frame)
            if outcome is not None:
                return outcome, heard.end
        self.progress.bad = self.decoder.bad
        return None, len(chunk)

    def _take(self, frame: Frame) -> Outcome | None:
        believed = self.progress.count(frame)
        if frame.kind == Kind.HELLO and not _same(frame.payload, self.hello):
            return Outcome("fault", "the device was reset")
        if frame.kind != Kind.END:
            return None
        if len(frame.payload) != END.size or not believed:
            wrong = f"its number {frame.seq} cannot be: the last frame was {self.progress.numbers.high}"
            if len(frame.payload) != END.size:
                wrong = f"it has {len(frame.payload)} bytes and not {END.size}"
            self._wrong_ends += 1
            return Outcome("fault", f"the device's END is none: {wrong}") if self._wrong_ends == WRONG_ENDS else None
        self.end_seq = frame.seq
        _, reason = END.unpack(frame.payload)
        if reason == Reason.FAULT:
            return Outcome("fault", "the device reported a fault")
        if reason == Reason.SILENCE:
            return Outcome("fault", "the device stopped: it did not hear this program any more")
        return Outcome("complete" if reason == Reason.COMPLETE else ABORTED)


def record(
    port: Port,
    log: Log,
    hello: Hello,
    stops: Callable[[], int],
    longest_s: float = math.inf,
    motion_s: float | None = None,
    folder: Path | None = None,
) -> Outcome:
    """Record from START to END; what is in the log afterwards is on the disk, and then the END is acknowledged.

    `stops` says how often the person has asked to stop: once, or `longest_s` over, sends STOP and waits for the END;
    twice ends it. `motion_s` is what a program takes that the device follows: it is told again and again that somebody
    is there. `folder` is that of the run, whose run.yaml says how its channels are read.
    """
    listener = Listener(hello, motion_s, folder)
    progress = listener.progress
    silence_s, idle_s = max(SILENCE_S, 5.0 / hello.rate_hz), max(IDLE_S, 5.0 / hello.rate_hz)
    began_s = heard_s = new_s = time.monotonic()
    stopped_s, newest, beat_s = math.inf, 0, math.inf if motion_s is None else began_s
    over: str | None = None  # what stopped it
    outcome: Outcome | None = None
    try:
        port.write(encode(Kind.START, 0, protocol=hello.protocol))
        while outcome is None:
            chunk = port.read()
            outcome, used = listener.look(chunk)
            log.append(chunk[:used])
            progress.show(log.free_bytes if progress.screen.due else 0)
            now_s = time.monotonic()
            if now_s >= beat_s:
                port.write(encode(Kind.BEAT, 2, protocol=hello.protocol))
                beat_s = now_s + BEAT_S
            heard_s = now_s if chunk else heard_s
            new_s, newest = (now_s, progress.numbers.high) if progress.numbers.high > newest else (new_s, newest)
            if outcome is not None:
                log.sync()
                if listener.end_seq is not None:
                    port.write(encode(Kind.ACK, listener.end_seq, protocol=hello.protocol))
            elif stops() > 1:
                outcome, over = Outcome(ABORTED), PERSON
            elif math.isinf(stopped_s) and (stops() or now_s - began_s > longest_s):
                over = PERSON if stops() else f"--longest after {longest_s:g} s"
                stopped_s = now_s
                port.write(encode(Kind.STOP, 1, protocol=hello.protocol))
            elif now_s - heard_s > silence_s:
                fault = f"the device said nothing for {silence_s:g} s"
                outcome = Outcome("fault" if math.isinf(stopped_s) else ABORTED, fault)
            elif now_s - stopped_s > STOP_S:
                outcome = Outcome("fault", "the device went on though it was told to stop")
            elif now_s - new_s > idle_s:
                outcome = Outcome("fault", f"bytes came, but no new frame for {idle_s:g} s")
    except Unplugged as error:
        # a device that goes away as soon as it has read the ACK takes nothing from the outcome
        gone = Outcome("fault" if math.isinf(stopped_s) else ABORTED, f"the port went away ({error})")
        outcome = outcome or gone
    log.sync()
    progress.show(last=True, cut=outcome.status != "complete")
    return _told(outcome, not math.isinf(stopped_s), over)


def _told(outcome: Outcome, stopped: bool, over: str | None) -> Outcome:
    """The outcome of a recording that may have been stopped, with the cause of the stop."""
    status = ABORTED if stopped and outcome.status == "complete" else outcome.status
    return Outcome(status, outcome.fault, over)


def _same(payload: bytes, hello: Hello) -> bool:
    try:
        return Hello.unpack(payload).nonce == hello.nonce
    except ValueError:
        return True  # not readable: nothing that tells of a reset
