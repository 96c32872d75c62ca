"""What the person at a printing rig sees while it records: the channel of each column, and faults."""

import time
from pathlib import Path

from ...ground.command import recover_command
from ...ground.words.counts import counted
from ..screen import Screen, clock
from .lines import Lines
from .live_faults import LiveFaults
from .naming import command_below, naming_in
from .read_channels import ReadChannels

GREETING_S = 5.0  # so long nothing but text is no reason to warn
SOON_S = 1.0  # after so long it says what is read as what, or why nothing is


class Telling:
    """What the person sees while it records."""

    def __init__(self, lines: Lines, folder: Path, began_s: float) -> None:
        self.lines, self.folder, self.screen = lines, folder, Screen()
        self.recover, self.naming = recover_command(folder), naming_in(folder)
        self._began_s, self._looked_s = began_s, time.monotonic()
        self._told = ""
        self.mend = ""  # what it has said that mends a recording of which no line is read
        self._faults: LiveFaults | None = None
        self._read = self._not_read = 0

    def sample(self, row: list[str] | None) -> None:
        """Look at the next line, and tell a fault of its sample as soon as it is seen."""
        if row is None:
            return
        if self._faults is None:
            self._faults = LiveFaults(self.folder, self.lines.columns, not self.lines.given)
        self._warn(self._faults.look(row))

    def _warn(self, fault: str) -> None:
        if fault:
            self.screen.say(f"warning: {fault}")

    def show(self) -> None:
        """Say how the columns are read as soon as that is known, or why none is, and renew the line."""
        lines, now_s = self.lines, time.monotonic()
        if now_s - self._looked_s >= SOON_S:
            self._looked_s = now_s
            read, not_read = lines.good, lines.not_read
            if lines.good and self._told != "reads":
                self._say("reads", self._reading())
            elif not lines.good and not_read and not self._greets(now_s):
                problem, mend = lines.problem(now_s - self._began_s, self.recover, self.naming)
                kept = f"warning: no line is read yet, but all are kept: {problem}"
                now = "let the rig print its header again, or when the run has ended " if lines.unnamed.size > 1 else ""
                if self._say("nothing", f"{kept}. Mend: {now}{command_below(mend)}"):
                    self.mend = mend
            elif read - self._read < not_read - self._not_read and lines.bad:
                problem, mend = lines.problem(0.0, self.recover, self.naming)
                most_lost = f"warning: most lines are not read now; {lines.counts()}; {problem}"
                self._say("most", f"{most_lost}. Mend: {command_below(mend)}")
            self._read, self._not_read = read, not_read
            if self._faults:
                self._warn(self._faults.clock())
                self._warn(self._faults.exchange())
        if self.screen.due:
            self.screen.show(self._parts())

    def close(self) -> None:
        """The last line."""
        if self.lines.good and self._told != "reads":
            self.screen.say(self._reading())
        self._warn(self._faults.exchange(last=True) if self._faults else "")
        self.screen.close(self._parts())

    def _greets(self, now_s: float) -> bool:
        """Whether only readable text came, for no longer than a rig may take to boot, home and tare."""
        lines = self.lines
        only_text = not (lines.noise or lines.unnamed.count or lines.wrong[0])
        return only_text and now_s - self._began_s < GREETING_S

    def _reading(self) -> str:
        """How the columns are read, and in a second line why nothing can use the recording so."""
        channels = ReadChannels(self.folder, self.lines.columns)
        return "\n".join(filter(None, (self.lines.reading(channels.values(self.lines.last)), channels.warning())))

    def _parts(self) -> list[str]:
        passed, lines = f"{clock(time.monotonic() - self._began_s)} recorded", self.lines
        pairs = zip(lines.columns, lines.last, strict=False)  # of a narrow line the end is cut off
        values = [f"{name} = {value}" for at, (name, value) in enumerate(pairs) if at != lines.time_at]
        return [passed, *([counted(lines.good, "line"), *values] if lines.good else []), lines.counts()]

    def _say(self, what: str, sentence: str) -> bool:
        """Say a sentence of another kind than the last one; whether it was said."""
        is_new = what != self._told
        if is_new:
            self.screen.say(sentence)
        self._told = what
        return is_new
