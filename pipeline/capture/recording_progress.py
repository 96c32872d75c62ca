"""The progress of a recording of frames: what came, what is lost, the sensors' values, and the remaining time."""

import time
from pathlib import Path

from ..ground.numbers.unwound import Unwound
from ..ground.words.counts import counted
from ..wire import Event, Frame, Hello, Kind
from ..wire.frames import EVENT
from ..wire.possible_numbers import LATE, Numbers
from .remaining_time import Left
from .sample_faults import Watch
from .screen import Screen, clock

PACE_AFTER_S, PACE_DIFFERS = 5.0, 0.1  # from when, and by which share, a device's clock goes at another pace
LEAST_APART_S = 1.0  # of the two clocks, to be said
SHOWN = {"motor_turns": "turns", "displacement_mm": "mm", "load_n": "N"}


class Progress:
    """Counts what comes and shows it; what is wrong it says at once.

    `motion_s`: what a program takes. `folder`: that of the run.
    """

    def __init__(self, hello: Hello, motion_s: float | None = None, folder: Path | None = None) -> None:
        self.hello = hello
        self.samples = self.lost = self.bad = 0
        self.screen, self.watch, self.left = Screen(), Watch(hello, folder), Left(hello.strokes, motion_s)
        self.numbers = Numbers(hello.rate_hz)
        self._stroke, self._unwound = 0, Unwound()  # the one under way
        self._missing: set[int] = set()
        self._began_s = self._looked_s = time.monotonic()
        self._looked_samples = self._looked_bad = 0

    def count(self, frame: Frame) -> bool:
        """Take note of one frame, and say whether its number can be true."""
        high, number = self.numbers.high, self.numbers.of(frame.seq)
        if not self.numbers.believe(frame.kind, number, frame.payload):
            return False
        if number > high:
            self.lost += number - high - 1
            if number - high <= LATE and len(self._missing) < LATE:
                self._missing.update(range(high + 1, number))
        elif number in self._missing:
            self._missing.remove(number)
            self.lost -= 1
        if frame.kind == Kind.SAMPLE:
            self.samples += 1
            wrong = self.watch.look(frame)
            if wrong:
                self.screen.say(f"warning: {wrong}")
            if "motor_turns" in self.watch.now:
                self._unwound.look(self.watch.now["motor_turns"])
        elif frame.kind == Kind.EVENT and len(frame.payload) == EVENT.size:
            _, code, value = EVENT.unpack(frame.payload)
            passed_s = time.monotonic() - self._began_s
            if code == Event.STROKE_START:
                self._stroke = value
                self._unwound.starts()
                self.left.starts(passed_s)
            elif code == Event.STROKE_END:
                self._stroke = 0
                self.left.ends(passed_s)
        return True

    def parts(self, free_bytes: int = 0, last: bool = False, cut: bool = False) -> list[str]:
        """The parts of the progress line, the most important first; the `last` line counts unwound strokes.

        `cut`: the recording ended before the rig was done.
        """
        passed_s = time.monotonic() - self._began_s
        recorded_s = self.samples / self.hello.rate_hz  # by the device's clock; all other times are the person's
        rigs_own = f"{clock(recorded_s)} by the rig's clock"
        differs = abs(recorded_s - passed_s) > max(PACE_DIFFERS * passed_s, LEAST_APART_S)
        other_pace = differs and (last or passed_s > PACE_AFTER_S)
        of = f" of {self.hello.strokes}" if self.hello.strokes else ""
        # as they come, which for a rig at another pace is not its own rate
        rate_hz = self.samples / max(passed_s, 1e-3)
        own = f" ({rate_hz / self.hello.rate_hz:.2g} times the {self.hello.rate_hz:g} of the rig's own clock)"
        left_s, lost = self.left.at(passed_s, recorded_s), f"{counted(self.lost, 'frame')} lost"
        readings = [f"{self.watch.now[name]:.2f} {unit}" for name, unit in SHOWN.items() if name in self.watch.now]
        is_whole = last and self._stroke > 0 and self._unwound.is_whole  # it ended without a rest: nobody told of it
        is_cut = cut and is_whole and not self._unwound.is_home
        whole = self.left.done + (is_whole and not is_cut)
        done = "stroke done" if whole == 1 and not of else "strokes done"
        at_turns = self.watch.now.get("motor_turns", 0.0)
        cut_off = f"stroke {self._stroke} was cut off at {at_turns:.1f} turns while it unwound"
        return [
            f"{clock(passed_s)} passed",  # one clock from start to end, whatever is learnt of the rig's pace
            f"stroke {self._stroke}{of}" if self._stroke and not is_whole else f"{whole}{of} {done}",
            *([cut_off] if is_cut else []),
            *([f"about {clock(left_s)} left"] if left_s is not None and not last else []),
            *([lost, *readings] if self.lost else [*readings, lost]),  # of a narrow line the end is cut off
            *([rigs_own] if other_pace else []),
            counted(self.samples, "sample"),
            f"{rate_hz:.0f} samples/s{own if other_pace else ''}",
            *([f"{free_bytes / 1e9:.1f} GB free"] if free_bytes else []),
        ]

    def show(self, free_bytes: int = 0, last: bool = False, cut: bool = False) -> None:
        """Renew the line, if it is time for it; the last one stays."""
        if last:
            self.screen.close(self.parts(last=True, cut=cut))
        elif self.screen.due:
            self.screen.show(self.parts(free_bytes))
        now_s = time.monotonic()
        if last or now_s - self._looked_s >= 1.0:
            if self.bad - self._looked_bad > self.samples - self._looked_samples:
                self.screen.say("warning: most of what comes is damaged: check the cable, the ground and the baud rate")
            self._looked_s, self._looked_samples, self._looked_bad = now_s, self.samples, self.bad
