"""The workflow's jobs: done, running and failed, from its newest log; each look reads only new lines."""

import os
import re
from datetime import UTC, datetime
from pathlib import Path

from .page_content import JobsJson

LARGEST = 4 << 20  # bytes that are read at once
LISTED = 30
TOTAL = re.compile(r"total\s+(\d+)")
STEPS = re.compile(r"(\d+) of (\d+) steps \(.*\) done")
DESCRIBED = re.compile(r"Job (\d+): (.+)")
RULE = re.compile(r"(?:local)?(?:rule|checkpoint) (\w+):")
ERROR = re.compile(r"Error in rule (\w+):")
JOB = re.compile(r"\s+jobid: (\d+)")
FINISHED = re.compile(r"Finished jobid: (\d+)\b.*")
ENDED = "Complete log(s):"


class Jobs:
    """The jobs of the newest log with jobs below a folder's `.snakemake/`; memory goes by the number of jobs."""

    def __init__(self, folder: Path) -> None:
        self.logs = folder / ".snakemake" / "log"
        self._forget(None)

    def _forget(self, path: Path | None) -> None:
        self._path, self._at, self._rest = path, 0, b""
        self.total, self.done, self.ended = 0, 0, False
        self._written_s = 0.0  # when the log last changed
        self.running: dict[int, str] = {}
        self.failed: dict[int, str] = {}
        self._rule, self._error = "", False

    def poll(self) -> None:
        """Read what was appended; a newer log begins anew."""
        try:
            newest = max((name for name in os.listdir(self.logs) if name.endswith(".snakemake.log")), default=None)
        except OSError:
            newest = None
        if newest is None:
            return
        if self._path != self.logs / newest:
            self._forget(self.logs / newest)
        assert self._path is not None
        try:
            with open(self._path, "rb") as file:
                file.seek(self._at)
                chunk = file.read(LARGEST)
                self._written_s = os.fstat(file.fileno()).st_mtime
        except OSError:
            return
        self._at += len(chunk)
        *lines, self._rest = (self._rest + chunk).split(b"\n")
        self._rest = self._rest[-10_000:]
        for line in lines:
            self._take(line.decode("utf-8", "replace"))

    def _take(self, line: str) -> None:
        if match := FINISHED.fullmatch(line):
            self.running.pop(int(match[1]), None)
            self.failed.pop(int(match[1]), None)  # it was tried again
        elif match := STEPS.fullmatch(line):
            self.done, self.total = int(match[1]), int(match[2])
        elif match := TOTAL.fullmatch(line):
            self.total = int(match[1])
        elif match := DESCRIBED.fullmatch(line):
            self.running[int(match[1])] = match[2][:200]
        elif match := RULE.fullmatch(line) or ERROR.fullmatch(line):
            self._rule, self._error = match[1], line.startswith("Error")
        elif self._rule and (match := JOB.fullmatch(line)):
            number = int(match[1])
            if self._error:
                self.failed[number] = self.running.pop(number, self._rule)
            else:
                self.running[number] = self._rule
            self._rule = ""
        elif line.startswith(ENDED):
            self.ended = True

    def told(self) -> JobsJson | None:
        """The jobs for the page; None where none was planned."""
        if not self.total:
            return None
        running = [] if self.ended else [*self.running.values()]
        return {
            "total": self.total,
            "done": self.done,
            "ended": self.ended,
            "ended_utc": datetime.fromtimestamp(self._written_s, UTC).isoformat() if self.ended else None,
            "running": running[:LISTED],
            "failed": [*self.failed.values()][:LISTED],
            "failures": len(self.failed),
        }
