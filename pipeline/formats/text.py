"""A text recording, plain or gzipped, as a table of numbers: read line by line, never endless and never guessed."""

import gzip
import io
import os
import re
import warnings
import zlib
from collections.abc import Iterator
from pathlib import Path

import pandas as pd

from ..ground.command import command
from ..ground.errors import BadInput
from ..ground.regular_file import open_regular
from ..ground.text_file import TextFile
from .interface import Format
from .text_layout import DELIMITERS, LOOK, cells, check_start, other_delimiter, uneven, without_half
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
MOST_COLUMNS = 2_000
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


def _kept(path: Path, layout: TextFile) -> tuple[io.BytesIO, list[tuple[int, str]], int]:
    """Lines of the table as UTF-8, without blank ones and remarks; the first, each after how many; how many there are.

    A last line that was cut off is left out, which is said.

    Raises BadInput for a file that cannot be read or is in another encoding.
    """
    kept, first, count, named, ended = io.BytesIO(), [], 0, 0, True
    try:
        for number, line in enumerate(_lines(path, layout.encoding)):
            shown = line.removeprefix("\ufeff").strip() if count == 0 else line.strip()
            if number < layout.skip or not shown or (layout.comment and shown.startswith(layout.comment)):
                continue
            named += 1
            if layout.header and 1 < named <= 1 + layout.skip_below:
                continue
            line = line.removeprefix("\ufeff") if count == 0 else line
            ended = line.endswith("\n")
            if count < LOOK:
                first.append((number, line.rstrip("\n")))
            kept.write((line if line.endswith("\n") else line + "\n").encode("utf-8", "replace"))
            count += 1
    except (OSError, EOFError, zlib.error) as error:
        raise BadInput(path, "file", f"cannot be read ({error})", "copy it again from the logger") from None
    except (UnicodeError, LookupError):
        mend = "set file.encoding, latin1 for instance"
        raise BadInput(path, "file.encoding", f"is not {layout.encoding}", mend) from None
    return kept, first, count - without_half(path, kept, ended, layout.delimiter)


def read_text(path: Path, layout: TextFile) -> pd.DataFrame:
    """Text table of numbers as it stands in the file; columns have their header's names or indices from 0.

    Raises BadInput for a file that is empty, is not text, or holds something else than numbers.
    """
    kept, first, count = _kept(path, layout)
    begin = first[0][1].lstrip() if first else ""
    if begin.startswith(("{", "[", "<")):
        if begin[0] == "<":
            raise BadInput(path, "file", "is a page of the web, not a table", "save its table as CSV")
        raise BadInput(path, "file", "is JSON, not a table", f"name it .json and {IMPORT}")
    if count <= layout.header:
        raise BadInput(path, "file", "holds no samples", "record again; nothing was written by the logger")
    other = other_delimiter([line for _, line in first], layout.delimiter)
    if other:
        problem, mend = f"is {layout.delimiter!r}, which parts no line", f"set file.delimiter to {DELIMITERS[other]}"
        raise BadInput(path, "file.delimiter", problem, mend)
    names = cells(first[0][1], layout.delimiter)
    if len(names) > MOST_COLUMNS:
        problem = f"has {len(names)} columns in its first line"
        raise BadInput(path, "file", problem, "check file.delimiter; a recording has one column a channel")
    check_start(path, first, layout)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", pd.errors.DtypeWarning)  # a word among numbers is found below
            warnings.simplefilter("error", pd.errors.ParserWarning)  # a row with a field too many is cut otherwise
            table = pd.read_csv(
                kept,
                sep=r"\s+" if layout.delimiter == " " else layout.delimiter,
                header=0 if layout.header else None,
                skipinitialspace=True,
                index_col=False,
                decimal=layout.decimal,
                engine="c",
            )
    except (ValueError, OverflowError, pd.errors.ParserWarning) as error:
        mend = "check file.delimiter, file.skip and file.comment, and the line that it names"
        reason = uneven(kept.getvalue(), layout.delimiter) or re.sub(r"\s+", " ", str(error)).strip()[:200]
        raise BadInput(path, "file", f"is not a table ({reason})", mend) from None
    if len(table) != count - layout.header:  # a quote that is left open takes the lines up to the next one with it
        problem = f"has {count - layout.header} lines of samples, of which {len(table)} can be told apart"
        raise BadInput(path, "file", problem, "remove the quotation mark that is left open in one of its lines")
    if layout.header:  # as they stand: pandas would number those that stand twice
        own = [str(name).strip() for name in table.columns]
        table.columns = [name or own[i] for i, name in enumerate(names)] if len(names) == len(own) else own
    return table


FORMAT = Format("text", (".csv", ".txt", ".tsv", ".dat", ".log", ".asc"), (), frozenset(), read_text)
