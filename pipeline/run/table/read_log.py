"""A log of another program as samples: a few damaged lines are left out and named; all others are read."""

import gzip
import io
import shlex
import shutil
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pandas as pd

from ...formats.text import FORMAT as TEXT
from ...formats.text import Uneven, even_lines
from ...formats.unpacked import GZIP
from ...ground.command import command
from ...ground.errors import BadInput
from ...ground.input.complaint import short
from ...ground.words.counts import counted
from ..description import Run
from ..folder import RECORDINGS
from .file_lines import NAMED, FileLines, lines_of
from .no_number import are_few, without_damaged
from .recorded_table import to_samples


@dataclass(frozen=True)
class Log:
    """A log's raw table, and its samples; their index has the numbers of their rows in the table, from 0.

    `rows` of the table are damaged, from 0, and `lines` of the file, from 1, have fields too many: both were left out.
    """

    path: Path
    table: pd.DataFrame
    samples: pd.DataFrame
    where: FileLines  # of the samples
    rows: list[int]
    lines: list[int]

    @property
    def gone(self) -> set[int]:
        """Numbers in the file, from 1, of the lines that were left out; none if the file is no text."""
        return {*self.lines, *(number for number, _ in lines_of(self.path, self.where.layout, self.rows).values())}


def too_long(lines: list[tuple[int, str]]) -> str:
    """Lines that have fields too many, by number from 1 and text, in words."""
    which = "; ".join(f"line {number}, {short(text)}" for number, text in lines[:NAMED])
    more = f"; and {counted(len(lines) - NAMED, 'more line')}" if len(lines) > NAMED else ""
    return f"{which}{more}"


def read_log(run: Run, path: Path, mapping: Path, read: Callable[[], pd.DataFrame]) -> Log:
    """The samples of a log whose raw table `read` gives, by the channels of file `mapping`; raises BadInput.

    Damaged lines are left out and said on standard error where they are at most 1 % of all.
    """
    lines: list[tuple[int, str]] = []
    try:
        table = read()
    except Uneven as error:
        table, lines = even_lines(path, run.file), error.lines
        if not are_few(len(lines), len(table)):
            raise
        count = f"{counted(len(lines), 'line')} with fields too many"
        print(f"warning: {path}: {count} left out: {too_long(lines)}", file=sys.stderr)
    read_all = to_samples(run, table, path, mapping, bear=True)
    samples, rows, damaged = without_damaged(read_all, path, run.file)
    if damaged:
        print(f"warning: {damaged}", file=sys.stderr)
    where = FileLines.of(path, run.file, samples)
    return Log(path, table, samples, where, rows, [number for number, _ in lines])


def recording_name(recording: Path) -> str:
    """The name of a recording in its run folder, where any text is .csv; raises BadInput for a format without one."""
    if not recording.is_file():
        raise BadInput(recording, "--recording", "is not there", "check the path")
    packed = ".gz" if recording.suffix.lower() == ".gz" else ""
    ending = recording.with_suffix("").suffix if packed else recording.suffix
    name = f"recording{'.csv' if ending.lower() in TEXT.suffixes else ending.lower()}{packed}"
    if name not in RECORDINGS[1:]:
        endings = f"{', '.join(TEXT.suffixes)}, one of these with .gz, or .parquet"
        mend = f"import it: {command('import_run')} --guess {shlex.quote(str(recording))} --out map.yaml drafts how"
        raise BadInput(recording, "--recording", f"does not end in {endings}", mend)
    return name


def copy_log(log: Log, temporary: Path) -> str:
    """Copy a log without its damaged lines; returns a remark on them for its run.yaml, empty if there are none."""
    if not log.rows and not log.lines:
        shutil.copyfile(log.path, temporary)
        return ""
    if temporary.suffix == ".parquet":
        log.table.drop(index=log.rows).to_parquet(temporary, index=False)
        return _remark(log, f"{counted(len(log.rows), 'damaged row')}: {', '.join(map(str, log.rows))}")
    packed, encoding, gone = log.path.read_bytes(), log.where.layout.encoding, log.gone
    text = (gzip.decompress(packed) if packed.startswith(GZIP) else packed).decode(encoding)
    lines = enumerate(io.StringIO(text, newline=""), 1)
    whole = "".join(line for number, line in lines if number not in gone).encode(encoding)
    temporary.write_bytes(gzip.compress(whole, mtime=0) if packed.startswith(GZIP) else whole)
    return _remark(log, f"{counted(len(gone), 'damaged line')}: {', '.join(map(str, sorted(gone)))}")


def _remark(log: Log, without: str) -> str:
    return f"# the recording is {short(log.path.name)} without {without}\n"


def rows_left(log: Log) -> list[int] | None:
    """The value of `file.rows` for a log's copy without the damaged rows; None if it asks for all rows."""
    rows = log.where.layout.rows
    return None if rows is None else [rows[0], rows[1] - len(log.rows)]
