"""One recording from its port to its commit, and the requests to end it."""

import math
import os
import signal
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from types import FrameType

from ..ground.command import recover_command
from ..ground.errors import BadInput
from ..run.capture_json import CaptureJson
from ..wire.motion import Leg
from .commit import commit
from .handshake import check_rate, greet
from .log import LINES, NAME, Log, check_folder
from .motion_program import load, strokes_of
from .port import Port
from .printed.lines_to_csv import commit_lines
from .printed.printed_lines import WAIT_S, await_header, follow
from .screen import Screen
from .stream import record
from .uncommitted_note import note

CLOCK = "time_s"


class Asked:
    """How often the person has asked to stop, by Ctrl-C or SIGTERM."""

    def __init__(self) -> None:
        self.times = 0

    def __call__(self) -> int:
        """So many times."""
        return self.times

    @contextmanager
    def listening(self) -> Iterator[None]:
        """Within it signals are counted; after it they do what they did before."""
        before = {number: signal.signal(number, self._ask) for number in (signal.SIGINT, signal.SIGTERM)}
        try:
            yield
        finally:
            for number, done in before.items():
                signal.signal(number, done)

    def _ask(self, number: int, frame: FrameType | None) -> None:
        self.times += 1


def how_to_end() -> str:
    """How a person ends a recording; one that was started in the background gets no Ctrl-C."""
    return f"recording; Ctrl-C or kill {os.getpid()} ends it, and what came is kept"


def plain(text: str) -> str:
    """A device's text without the characters that a terminal would obey."""
    return "".join(character if character.isprintable() else "?" for character in text)


def capture_lines(
    name: str,
    folder: Path,
    baud: int,
    columns: tuple[str, ...],
    longest_s: float = math.inf,
    wait_s: float = WAIT_S,
) -> CaptureJson:
    """Record what a rig prints and commit it; returns what capture.json says; raises BadInput.

    `wait_s` is how long the rig may print no line of numbers at its beginning.
    """
    end_request = Asked()
    check_folder(folder)
    with ExitStack() as until_committed:
        with Port(name, baud) as port:
            beginning = await_header(port, name, columns, wait_s)
            began = datetime.now(UTC) - timedelta(seconds=time.monotonic() - beginning.since_s)
            until_committed.enter_context(end_request.listening())
            log = Log(folder, LINES)
            note(folder, began, columns)
            Screen().say(how_to_end())
            try:
                outcome = follow(port, log, end_request, folder, columns, beginning, longest_s)
            except OSError as error:
                mend = f"make room, then run {recover_command(folder)}"
                raise BadInput(folder, LINES, f"could not be written ({error}); what it has is kept", mend) from None
            finally:
                log.close()
        ended = datetime.now(UTC)
        note(folder, began, columns, ended, outcome)  # for --recover, where no line can be read now
        return commit_lines(folder, columns, began, ended, outcome)


def capture(
    name: str,
    folder: Path,
    baud: int,
    longest_s: float = math.inf,
    legs: Sequence[Leg] = (),
    stopped: Callable[[], bool] = lambda: False,
) -> CaptureJson:
    """Record one run and commit it; returns what capture.json says. Raises BadInput before anything is written.

    With `legs` the rig follows them: it takes them as a whole before START, or the run is not begun. `stopped` says
    whether somebody has asked to stop in another way than by Ctrl-C; before START that is a KeyboardInterrupt too.
    """
    end_request = Asked()
    check_folder(folder)
    with ExitStack() as until_committed:
        with Port(name, baud) as port:
            hello, beginning = greet(port, name, baud)
            check_rate(hello, baud, name)
            channels = ", ".join(f"{channel.name} [{channel.unit}]" for channel in hello.channels)
            print(plain(f"{hello.device}, firmware {hello.firmware}: {hello.rate_hz:g} Hz, {channels}"), flush=True)
            if any(channel.name == CLOCK for channel in hello.channels):
                print(
                    f"{CLOCK} is the device's clock, t_us; its channel of that name is kept as device_{CLOCK}",
                    flush=True,
                )
            if legs:
                load(port, hello, legs, name)
                assert hello.program is not None, "load has refused a device without limits"
                hello = replace(hello, strokes=strokes_of(legs, hello.program.at_turns))  # not its own motion's
            if stopped():
                raise KeyboardInterrupt
            until_committed.enter_context(end_request.listening())
            log = Log(folder)
            Screen().say(how_to_end())
            try:
                log.append(beginning)
                began = datetime.now(UTC)
                motion_s = sum(leg.seconds for leg in legs) if legs else None
                outcome = record(port, log, hello, lambda: end_request() + stopped(), longest_s, motion_s, folder)
            except OSError as error:
                mend = f"make room, then run {recover_command(folder)}"
                raise BadInput(folder, NAME, f"could not be written ({error}); what it has is kept", mend) from None
            finally:
                log.close()
        return commit(folder, began, datetime.now(UTC), outcome)
