"""A rig that prints lines of numbers: PORT → recording.lines as it came."""

import math
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from ...ground.errors import BadInput
from ...run.ended_words import PERSON
from ..log import Log
from ..port import Port, Unplugged
from ..screen import Screen
from ..stream import Outcome
from .clock_words import clock_in
from .fields import MAX_LINE, is_known
from .lines import Lines, Splitter
from .telling import Telling

WAIT_S = 30.0  # a board that was reset by opening its port boots, homes its motor and tares before it prints
HEADER_S = 5.0  # from the first line on, within which a header or samples are to come
SAID_AFTER_S = 2.0  # of waiting, what is waited for
NAMELESS = 5  # so many lines of as many numbers are a rig, though no header has come
SILENCE_S = 3.0


class Beginning(NamedTuple):
    """The first bytes of a recording, since when they came and until when numbers are to, by the monotonic clock."""

    heard: bytes
    since_s: float
    until_s: float


def await_header(port: Port, name: str, columns: tuple[str, ...], wait_s: float = WAIT_S) -> Beginning:
    """The first bytes of a recording: with `columns` none, else up to the first sample, a header or a few numbers.

    Lines of numbers that nothing names are recorded too: a header may come yet, and they can be named when the run has
    ended. `wait_s` is how long the rig may print none, which is said. Raises BadInput for a port that is silent for so
    long, or that prints neither names nor numbers.
    """
    heard, since_s = b"", time.monotonic()
    until_s = judged_s = since_s + wait_s
    lines, splitter, waiting = Lines(), Splitter(), Waiting(until_s, SAID_AFTER_S)
    if columns:
        return Beginning(b"", since_s, until_s)
    while time.monotonic() < judged_s and len(heard) <= 64 * MAX_LINE:
        try:
            chunk = port.read()
        except Unplugged as error:
            raise BadInput(name, "port", f"went away ({error})", "plug the rig in again") from None
        since_s = since_s if heard else time.monotonic()
        heard += chunk
        for line in splitter.feed(chunk):
            lines.take(line)
        if lines.headers or lines.unnamed.count or lines.bad or splitter.tail_bytes > MAX_LINE:
            judged_s = min(judged_s, time.monotonic() + HEADER_S)  # what came is no sign of a rig that still begins
        else:
            waiting.say()
        named = lines.good or any(between != " " and is_known(header) for header, between in lines.headers)
        if named or (lines.unnamed.size > 1 and lines.unnamed.times() >= NAMELESS):
            return Beginning(heard, since_s, until_s)
    if not heard:
        mend = "check the cable, the power and that this is the rig's port; of a rig that begins later raise --wait"
        raise BadInput(name, "device", f"said nothing for {wait_s:g} s", mend)
    if lines.headers and not lines.bad and not lines.unnamed.count:
        return Beginning(heard, since_s, until_s)  # it waits for something: a person, a button
    if lines.wrong[0] > 1:
        return Beginning(heard, since_s, until_s)
    problem, mend = lines.problem()
    raise BadInput(name, "device", f"sent {len(heard)} bytes and no sample: {problem}", mend)


class Waiting:
    """Says once that the rig is waited for, until when, and how that is ended."""

    def __init__(self, until_s: float, after_s: float) -> None:
        self._until_s, self._from_s, self._told = until_s, time.monotonic() + after_s, False

    def say(self) -> None:
        """Say it, when it is time."""
        now_s = time.monotonic()
        if self._told or not self._from_s < now_s < self._until_s:
            return
        self._told = True
        delay = f"for {self._until_s - now_s:.0f} s more (--wait)"
        Screen().say(f"waiting for the rig's first line of numbers, {delay}: it may boot, home or tare; Ctrl-C ends it")


def follow(
    port: Port,
    log: Log,
    stops: Callable[[], int],
    folder: Path,
    columns: tuple[str, ...],
    beginning: Beginning,
    longest_s: float = math.inf,
) -> Outcome:
    """Record until the person ends it, time is over or nothing more comes; the bytes are on the disk afterwards.

    Before the first line of numbers silence ends it only when the beginning's time for that is over.
    """
    heard_s = time.monotonic()
    lines, splitter, waiting = Lines(columns, clock_in(folder)), Splitter(), Waiting(beginning.until_s, SILENCE_S)
    telling = Telling(lines, folder, beginning.since_s)
    outcome: Outcome | None = None
    chunk = beginning.heard
    log.append(chunk)
    while outcome is None:
        for line in splitter.feed(chunk):
            telling.sample(lines.take(line))
        telling.show()
        numbers = lines.good or lines.unnamed.count or lines.bad
        if not numbers:
            waiting.say()
        now_s = time.monotonic()
        heard_s = now_s if chunk else heard_s
        if stops():
            outcome = Outcome("ended", None, PERSON)
        elif now_s - beginning.since_s > longest_s:
            outcome = Outcome("ended", None, f"--longest after {longest_s:g} s")
        elif now_s - heard_s > SILENCE_S and (numbers or now_s > beginning.until_s):
            silence = f"{SILENCE_S:g} s of silence; whether the rig was done, text cannot say"
            if not numbers:
                silence = "the wait for a first line of numbers, which --wait makes longer"
                telling.screen.say(f"ended by {silence}")
            outcome = Outcome("ended", None, silence)
        else:
            try:
                chunk = port.read()
            except Unplugged as error:
                outcome = Outcome("fault", f"the port went away ({error})")
            else:
                log.append(chunk)
    log.sync()
    telling.close()
    return replace(outcome, screen_mend=telling.mend)
