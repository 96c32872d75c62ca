"""A rig that prints lines of numbers: PORT → recording.lines as it came; what is read as what is said while it runs."""

import math
import time
from collections.abc import Callable
from pathlib import Path

from ..ground.errors import BadInput
from ..run.capture_json import CaptureJson, Lost
from .fields import MAX_LINE, TIME, is_known
from .lines import Lines, Splitter
from .log import Log
from .port import Port, Unplugged
from .screen import Screen, clock
from .stream import PERSON, Outcome

HEADER_S = 5.0  # a board that was reset by opening its port needs some of them
SILENCE_S = 3.0
SIZES_TOLD = 5  # of holes
SOON_S = 1.0  # after so long it says what is read as what, or why nothing is


def await_header(port: Port, name: str, columns: tuple[str, ...]) -> bytes:
    """First bytes of the recording: with `columns` none, else up to the first sample or a header.

    Lines of numbers that nothing names are recorded too: they can be named when the run has ended. Raises BadInput for
    a port that is silent, or that prints neither names nor numbers.
    """
    heard, until_s = b"", time.monotonic() + HEADER_S
    lines, splitter = Lines(), Splitter()
    while not columns and time.monotonic() < until_s and len(heard) <= 64 * MAX_LINE:
        try:
            chunk = port.read()
        except Unplugged as error:
            raise BadInput(name, "port", f"went away ({error})", "plug the rig in again") from None
        heard += chunk
        for line in splitter.feed(chunk):
            lines.take(line)
        if lines.good or any(between != " " and is_known(header) for header, between in lines.headers):
            return heard
    if columns:
        return b""
    if not heard:
        mend = "check the cable, the power and that this is the rig's port"
        raise BadInput(name, "device", f"said nothing for {HEADER_S:g} s", mend)
    if lines.headers and not lines.bad:
        return heard  # it waits for something: a person, a button
    if lines.wrong[0] > 1:
        return heard
    problem, mend = lines.problem()
    raise BadInput(name, "device", f"sent {len(heard)} bytes and no sample: {problem}", mend)


class Telling:
    """What the person sees while it records."""

    def __init__(self, lines: Lines) -> None:
        self.lines, self.screen = lines, Screen()
        self._began_s = self._looked_s = time.monotonic()
        self._told = ""
        self._read = self._not_read = 0

    def show(self) -> None:
        """Say what is read as what as soon as it is known, why nothing is, and renew the line."""
        lines, now_s = self.lines, time.monotonic()
        if now_s - self._looked_s >= SOON_S:
            self._looked_s = now_s
            read, not_read = lines.good, lines.text + lines.bad
            if lines.good and self._told != "reads":
                self._say("reads", lines.reading())
            elif not lines.good and not_read:
                problem, mend = lines.problem()
                self._say("nothing", f"warning: no line is read, but all are kept: {problem}. Mend: {mend}")
            elif read - self._read < not_read - self._not_read and lines.bad:
                _, problem, mend = "", *lines.problem()
                self._say("most", f"warning: most lines are not read now; {lines.counts()}; {problem}. Mend: {mend}")
            self._read, self._not_read = read, not_read
        if self.screen.due:
            self.screen.show(self._parts())

    def close(self) -> None:
        """The last line."""
        if self.lines.good and self._told != "reads":
            self.screen.say(self.lines.reading())
        self.screen.close(self._parts())

    def _parts(self) -> list[str]:
        values = [f"{name} = {value}" for name, value in zip(self.lines.columns, self.lines.last, strict=False)]
        return [f"{clock(time.monotonic() - self._began_s)} recorded", self.lines.counts(), *values]

    def _say(self, what: str, sentence: str) -> None:
        if what != self._told:
            self.screen.say(sentence)
        self._told = what


def follow(
    port: Port,
    log: Log,
    stops: Callable[[], int],
    columns: tuple[str, ...] = (),
    beginning: bytes = b"",
    longest_s: float = math.inf,
) -> Outcome:
    """Record until the person ends it, time is over or nothing more comes; what came is on the disk afterwards."""
    began_s = heard_s = time.monotonic()
    lines, splitter = Lines(columns), Splitter()
    telling = Telling(lines)
    outcome: Outcome | None = None
    chunk = beginning
    log.append(beginning)
    while outcome is None:
        for line in splitter.feed(chunk):
            lines.take(line)
        telling.show()
        now_s = time.monotonic()
        heard_s = now_s if chunk else heard_s
        if stops():
            outcome = Outcome("ended", None, PERSON)
        elif now_s - began_s > longest_s:
            outcome = Outcome("ended", None, f"--longest after {longest_s:g} s")
        elif now_s - heard_s > SILENCE_S:
            silence = f"{SILENCE_S:g} s of silence; whether the rig was done, text cannot say"
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
    return outcome


def missing(holes: list[Lost]) -> str:
    """Where samples seem to be missing: holes of the same size are told together, by the first of them."""
    sizes: dict[int, list[float]] = {}
    for hole in holes:
        sizes.setdefault(hole["samples_about"], []).append(hole["after_time"])
    parts, smaller = [], sorted(sizes, reverse=True)[SIZES_TOLD:]
    for size in sorted(sizes, reverse=True)[:SIZES_TOLD]:
        times = sizes[size]
        often, first = (f"{len(times)} times ", "first ") if len(times) > 1 else ("", "")
        words = f"{often}about {size} sample{'s' * (size != 1)} missing"
        parts.append(f"{words}, {first}after the device's time {times[0]:g}")
    if smaller:
        parts.append(f"and {sum(len(sizes[size]) for size in smaller)} smaller holes, see capture.json")
    return "; ".join(parts)


def clock_of(info: CaptureJson) -> str:
    """Name of the column that is read as the device's time, of what capture.json says."""
    return next((name for name in info["columns"] if TIME.fullmatch(name)), "time")


def tell_lines(info: CaptureJson, folder: Path) -> None:
    """Say what was recorded, what was no line of numbers and where samples seem to be missing."""
    lines = info["lines"]
    text = f", {lines['text']} lines of text passed over" if lines["text"] else ""
    print(f"{folder}: {info['exit_status']}, {info['samples']['received']} samples, {lines['bad']} bad lines{text}")
    print(f"{folder}: the columns are {', '.join(info['columns'])}; if not, --recover {folder} --columns names them")
    if lines["swapped_headers"]:
        again = f"named the columns in another order {lines['swapped_headers']} times"
        print(f"{folder}: the rig {again}; the fields are put back into the first one's")
    if lines["other_headers"]:
        print(f"{folder}: the rig named other columns {lines['other_headers']} times; lines after that are bad ones")
    if not lines["device_time"]:
        print(f"{folder}: the rig prints no time, so lost lines cannot be seen; print millis() first in every line")
    if info["holes"]:
        print(f"{folder}: {missing(info['holes'])}")
    if lines["time_backward"]:
        sentence = f"the device's time stands or falls back {lines['time_backward']} times"
        print(f"{folder}: {sentence}: was it reset, or is the time another column than {clock_of(info)}?")
