"""The lines of a text recording's table, read one by one and never endless, as a file that pandas reads."""

import gzip
import io
import os
import sys
import zlib
from collections import deque
from collections.abc import Generator, Iterator
from pathlib import Path
from typing import Any

from ..ground.command import command
from ..ground.errors import BadInput
from ..ground.input.complaint import short
from ..ground.input.text_file import TextFile
from ..ground.stored.regular_file import open_regular
from .text_layout import LOOK, is_half
from .unpacked import BOMB_BYTES, GZIP, IS_IT, NO_READINGS, is_bomb

IMPORT = f"make a run of it with {command('import_run')}, which reads it"
OTHERS = {  # what else a file that is no text begins with, and what to do about it
    b"PK\x03\x04": ("an Excel workbook or another zip file", IMPORT),
    b"\xd0\xcf\x11\xe0": ("an old Excel workbook, or one with a password", "save it as .xlsx without a password"),
    b"\x89HDF": ("an HDF5 file", IMPORT),
    b"PAR1": ("a Parquet file", "name it .parquet"),
    b"MATLAB": ("a MATLAB file", IMPORT),
}
LONGEST_LINE = 100_000  # characters
LARGEST_TEXT = 4_000_000_000  # bytes: a day at 1 kHz


def _lines(path: Path, encoding: str) -> Iterator[str]:
    """Lines of a text file, ends taken off; raises BadInput for what is packed without bound."""
    with open_regular(path) as file:
        start = file.read(8)
        for sign, (kind, mend) in OTHERS.items():
            if start.startswith(sign):
                raise BadInput(path, "file", f"is {kind}, no text", mend)
        file.seek(0)
        zipped = start[:2] == GZIP
        content = gzip.GzipFile(fileobj=file) if zipped else file
        packed, read, look = os.fstat(file.fileno()).st_size, 0, BOMB_BYTES
        with io.TextIOWrapper(content, encoding=encoding, newline=None) as text:  # breaks: \n, \r\n and \r alone
            while line := text.readline(LONGEST_LINE + 1):
                if len(line) > LONGEST_LINE:
                    problem = f"has a line of more than {LONGEST_LINE} characters"
                    raise BadInput(path, "file", problem, "check that it is a recording, one sample a line")
                read += len(line)
                if read > look:
                    look = read + BOMB_BYTES
                    if zipped and is_bomb(read, packed):
                        raise BadInput(path, "file", NO_READINGS, IS_IT)
                    if read > LARGEST_TEXT:
                        problem = f"has more than {LARGEST_TEXT / 1e9:g} GB of text"
                        raise BadInput(path, "file", problem, "save it as Parquet, or cut it into runs")
                yield line


def table_lines(path: Path, layout: TextFile) -> Generator[tuple[int, str]]:
    """Lines of the table without blank ones and remarks, each after how many lines of the file.

    Raises BadInput for a file that cannot be read or is in another encoding.
    """
    count = named = 0
    try:
        for number, line in enumerate(_lines(path, layout.encoding)):
            line = line.removeprefix("\ufeff") if count == 0 else line
            shown = line.strip()
            if number < layout.skip or not shown or (layout.comment and shown.startswith(layout.comment)):
                continue
            named += 1
            if layout.header and 1 < named <= 1 + layout.skip_below:
                continue
            yield number, line
            count += 1
    except (OSError, EOFError, zlib.error) as error:
        raise BadInput(path, "file", f"cannot be read ({error})", "copy it again from the logger") from None
    except (UnicodeError, LookupError):
        mend = "set file.encoding, latin1 for instance"
        raise BadInput(path, "file.encoding", f"is not {layout.encoding}", mend) from None


class TableFile(io.RawIOBase):
    """The table's lines as UTF-8; `first` are its first ones, each after how many, and `count` tells how many came.

    A last line that was cut off is left out, which is said. What is wrong with a line further down ends the file, and
    is then in `error`: pandas would tell it in its own words. Raises BadInput for what is wrong with the first lines.
    """

    def __init__(self, path: Path, layout: TextFile) -> None:
        self._path, self._delimiter = path, layout.delimiter
        self._lines = table_lines(path, layout)
        self._waiting: deque[str] = deque()  # the last two at least: what comes last is judged by the one before
        self._bytes, self.count, self._ended = b"", 0, False
        self.error: BadInput | None = None
        self.first: list[tuple[int, str]] = []
        while len(self.first) < LOOK and not self._ended:
            self._next()
        if self.error is not None:
            raise self.error

    def _next(self) -> None:
        """Take one line more, or see that there is none."""
        try:
            number, line = next(self._lines)
        except StopIteration:
            self._ended = True
            self._leave_half()
            return
        except BadInput as error:
            self._ended, self.error = True, error
            return
        if len(self.first) < LOOK:
            self.first.append((number, line.rstrip("\n")))
        self._waiting.append(line)
        self.count += 1

    def _leave_half(self) -> None:
        """Drop the last line where it was cut off, and say so."""
        if len(self._waiting) > 1 and is_half(self._waiting[-2], self._waiting[-1], self._delimiter):
            line = self._waiting.pop()
            self.count -= 1
            warning = f"its last line, {short(line.strip())}, is cut off and was left out"
            print(f"{self._path}: {warning}", file=sys.stderr)

    def readable(self) -> bool:
        """It is."""
        return True

    def readinto(self, buffer: Any, /) -> int:
        """Fill a buffer; 0 at the end."""
        room = memoryview(buffer).cast("B")
        if not self._bytes:
            self._bytes = b"".join(self._ready(len(room)))
        part, self._bytes = self._bytes[: len(room)], self._bytes[len(room) :]
        room[: len(part)] = part
        return len(part)

    def _ready(self, size: int) -> Iterator[bytes]:
        """So many bytes of whole lines or some more, fewer at the end."""
        while size > 0:
            while len(self._waiting) <= 2 and not self._ended:
                self._next()
            if not self._waiting:
                return
            line = self._waiting.popleft()
            text = (line if line.endswith("\n") else line + "\n").encode("utf-8", "replace")
            size -= len(text)
            yield text

    def close(self) -> None:
        """Close the file that is read."""
        self._lines.close()
        super().close()
