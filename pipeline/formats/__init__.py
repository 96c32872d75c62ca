"""The one door for a foreign recording: its format is found from its content or its name, and its reader is called."""

import importlib
import pkgutil
from collections.abc import Sequence
from functools import cache
from pathlib import Path

import pandas as pd

from ..ground.errors import BadInput
from ..ground.input.complaint import short
from ..ground.input.text_file import TextFile
from ..ground.stored.regular_file import open_regular
from .interface import Format
from .nested import table_of

__all__ = ["format_of", "formats", "read_foreign"]
HELPERS = ("interface", "matlab_child", "nested", "own_table", "text_layout", "text_lines", "time_stamps", "unpacked")
SPACE = b"\xef\xbb\xbf \t\r\n"  # may stand before the first sign of a text


@cache
def formats() -> tuple[Format, ...]:
    """All formats: every module of this folder but the helpers holds one, found by listing it."""
    names = sorted(module.name for module in pkgutil.iter_modules(__path__) if module.name not in HELPERS)
    all_formats: list[Format] = [importlib.import_module(f"{__name__}.{name}").FORMAT for name in names]
    return tuple(all_formats)


def format_of(path: Path) -> Format:
    """The format of a file, by its first bytes, else by its name, else text; raises BadInput for what is no file."""
    with open_regular(path) as file:
        start = file.read(64)
    by_sign = [
        (sign, format_) for format_ in formats() for sign in format_.signs if start.lstrip(SPACE).startswith(sign)
    ]
    if by_sign:
        return max(by_sign, key=lambda pair: len(pair[0]))[1]
    name = path.name.lower().removesuffix(".gz")
    by_name = (format_ for format_ in formats() if name.endswith(format_.suffixes))
    return next(by_name, next(format_ for format_ in formats() if ".csv" in format_.suffixes))


def _check_keys(path: Path, kind: Format, layout: TextFile) -> None:
    """Raise BadInput where `file:` says something that only another format has."""
    for key in ("sheet",):
        if getattr(layout, key) is not None and key not in kind.keys:
            problem = f"is {short(getattr(layout, key))}, but the file is {kind.name}, which has none"
            raise BadInput(path, f"file.{key}", problem, "leave it out")


def read_foreign(path: Path, layout: TextFile, wanted: Sequence[str] = ()) -> pd.DataFrame:
    """Raw table of a recording as it stands in the file, in whatever format; raises BadInput.

    `wanted` are the columns that somebody wants: of a file that holds columns of several lengths, as MATLAB's and JSON
    do, they say which belong together. Without them it is the longest.
    """
    kind = format_of(path)
    _check_keys(path, kind, layout)
    table = kind.read(path, layout)
    return table if isinstance(table, pd.DataFrame) else table_of(table, wanted, path)
