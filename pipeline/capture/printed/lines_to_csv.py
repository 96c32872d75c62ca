"""recording.lines → recording.csv and capture.json, line by line, of any length; it can be repeated."""

import hashlib
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

from ...ground.command import recover_command
from ...ground.errors import BadInput
from ...ground.stored.files import sha256, whole
from ...run.capture_json import CaptureJson
from ..commit import PIECE, check_own, committed, opening, seal, unwritten
from ..log import LINES, in_use
from ..stream import Outcome
from ..uncommitted_note import noted, noted_columns, propose, withdraw
from . import holes
from .clock_words import clock_in
from .fields import clock_at, names
from .lines import Lines, Splitter
from .naming import after_screen, command_below, naming_in

CSV = "recording.csv"


class Finished(BadInput):
    """Raised if a recording is already read with the columns that were asked for."""


class Printed:
    """A text recording, read once from its beginning: `rows` gives its samples, and completes the other numbers."""

    def __init__(self, path: Path, columns: tuple[str, ...]) -> None:
        self.path, self.lines, self.steps = path, Lines(columns, clock_in(path.parent)), holes.Steps()
        self.size, self.tail_bytes = 0, 0
        self._digest = hashlib.sha256()

    def rows(self) -> Iterator[list[str]]:
        """The samples, each with one text per column."""
        splitter = Splitter()
        time_at: int | None = None
        with open(self.path, "rb") as file:
            while piece := file.read(PIECE):
                self._digest.update(piece)
                self.size += len(piece)
                for line in splitter.feed(piece):
                    row = self.lines.take(line)
                    if row is not None:
                        time_at = self.lines.time_at if time_at is None else time_at
                        if time_at >= 0:
                            self.steps.take(float(row[time_at]))
                        yield row
        self.tail_bytes = splitter.tail_bytes

    @property
    def sha256(self) -> str:
        """Of the bytes that were read."""
        return self._digest.hexdigest()


def _times(path: Path, time_at: int) -> Iterator[float]:
    with open(path, encoding="ascii") as file:
        next(file)
        for row in file:
            yield float(row.split(",")[time_at])


def _write(printed: Printed, path: Path) -> str:
    """Write the table; its SHA-256."""
    digest = hashlib.sha256()
    with open(path, "wb") as file:
        for row in printed.rows():
            head = ",".join(printed.lines.columns) + "\n" if printed.lines.good == 1 else ""
            text = f"{head}{','.join(row)}\n".encode("ascii")
            digest.update(text)
            file.write(text)
    return digest.hexdigest()


def commit_lines(
    folder: Path, columns: tuple[str, ...], began: datetime, ended: datetime, outcome: Outcome, anew: bool = False
) -> CaptureJson:
    """Account for `recording.lines`, write the good ones as recording.csv, and commit; returns capture.json's content.

    Only `anew` replaces a table. Raises BadInput when no line is a sample, or the files cannot be written or are
    another recording's; what was printed is kept in any case.
    """
    printed = Printed(folder / LINES, columns)
    lines = printed.lines
    try:
        with whole(folder / CSV, new=not anew) as temporary:
            csv_sha256 = _write(printed, temporary)
            if not lines.good:
                problem, mend = lines.problem(
                    (ended - began).total_seconds(), recover_command(folder), naming_in(folder)
                )
                if lines.unnamed.count:
                    problem, mend = after_screen(problem, mend, outcome.screen_mend)
                propose(folder, mend.partition(" --columns ")[2].partition(";")[0])
                raise BadInput(folder / LINES, "samples", f"{problem}; what was printed is kept", command_below(mend))
            check_own(folder, LINES, printed.sha256)
            times = _times(temporary, lines.time_at) if lines.time_at >= 0 else iter(())
            hole_count, hole_list = holes.find(times, printed.steps.usual)
    except FileExistsError:
        mend = f"move it away, then run {recover_command(folder)}"
        raise BadInput(folder, CSV, f"is there already; {LINES} is whole and kept", mend) from None
    except OSError as error:
        raise unwritten(folder, CSV, error) from None
    info: CaptureJson = {
        **opening(printed.size, printed.sha256, began, ended, outcome),
        "csv_sha256": csv_sha256,
        "columns": list(lines.columns),
        "columns_given": lines.given,
        "samples": {"sent": None, "received": lines.good},
        "lines": {
            "bad": lines.bad,
            "bad_at": lines.bad_lines,
            "unnamed": lines.unnamed.count,
            "text": lines.text,
            "text_first": lines.greetings,
            "tail_bytes": printed.tail_bytes,
            "device_time": lines.time_at >= 0,
            "time_backward": printed.steps.backward,
            "holes": hole_count,
            "decimal_commas": lines.decimal_commas,
            "swapped_headers": lines.swapped,
            "other_headers": lines.others,
        },
        "holes": hole_list,
    }
    sealed = seal(folder, LINES, info)
    withdraw(folder)
    return sealed


def recover_lines(folder: Path, columns: tuple[str, ...]) -> CaptureJson:
    """Commit a text recording that has no capture.json yet, or one whose columns had other names.

    Its start and end, and what ended it, are those that the capture program noted beside it; of one that was killed,
    which is `recovered`, the file's last change is the end. Raises BadInput, and Finished where nothing would change.
    """
    path, info = folder / LINES, committed(folder)
    if in_use(path):
        raise BadInput(path, LINES, "is still being captured", "wait for that program, or end it")
    if not info:
        began, ended, outcome = noted(folder, datetime.fromtimestamp(path.stat().st_mtime, UTC))
        return commit_lines(folder, columns or noted_columns(folder), began, ended, outcome, anew=True)
    digests = [_sha256(folder / name) for name in (LINES, CSV)]
    if digests[0] != info.get("sha256"):
        mend = "restore it from a copy; a recording is never edited"
        raise BadInput(path, "sha256", "its bytes are not those that capture.json was written for", mend)
    before, began, ended, outcome = _said(info, folder)
    timed = bool(info.get("lines", {}).get("device_time")) or clock_at(before, clock_in(folder)) < 0
    more = bool(columns) and not info.get("columns_given") and info.get("lines", {}).get("unnamed", 0) != 0
    if digests[1] == info.get("csv_sha256") and columns in ((), before) and timed and not more:
        mend = "there is nothing to recover; columns that were read wrongly are named with --columns"
        if columns:
            mend = "there is nothing to recover: it is read by these columns already"
        raise Finished(folder, "capture.json", "is there, so the run is finished", mend)
    columns = columns or (before if info.get("columns_given") else ())
    return commit_lines(folder, columns, began, ended, outcome, anew=True)


def _said(info: CaptureJson, folder: Path) -> tuple[tuple[str, ...], datetime, datetime, Outcome]:
    """The part of capture.json on a text recording's columns, beginning, end and outcome; raises BadInput."""
    columns, status, fault, ended_by = (info.get(key) for key in ("columns", "exit_status", "fault", "ended_by"))
    mend = "restore it from a copy, or move it away and run --recover again"
    field = "columns"
    try:
        if not isinstance(columns, list) or tuple(columns) != names(",".join(columns).encode()):
            raise ValueError
        field = "started_utc"
        began = datetime.fromisoformat(info["started_utc"]).astimezone(UTC)
        field = "ended_utc"
        ended = datetime.fromisoformat(info["ended_utc"]).astimezone(UTC)
        field = "exit_status"
        if status not in ("ended", "fault", "recovered"):
            raise ValueError
        field = "ended_by"
        if not (ended_by is None or isinstance(ended_by, str)):
            raise ValueError
        field = "fault"
        if not (fault is None or isinstance(fault, str)):
            raise ValueError
    except (KeyError, TypeError, ValueError, OverflowError):
        problem = "is not what the capture program writes"
        raise BadInput(folder / "capture.json", field, problem, mend) from None
    return tuple(columns), began, ended, Outcome(status, fault, ended_by)


def _sha256(path: Path) -> str | None:
    return sha256(path) if path.is_file() else None
