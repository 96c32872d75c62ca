"""A folder of recordings of one logger: which of its files are recordings, and the runs that they become."""

import re
from dataclasses import dataclass
from fnmatch import fnmatch
from pathlib import Path

from ..formats import formats
from ..ground.errors import BadInput
from ..ground.names import slug

SHOWN = 8  # files that a sentence names
OPTION = "--files"


@dataclass(frozen=True)
class FolderFiles:
    """The recordings of a folder by the runs' names, in order, and the files that are passed over."""

    file_by_run: dict[str, Path]
    passed_over: list[str]  # from the folder on

    @property
    def sentence(self) -> str:
        """Which files are passed over; nothing where none is."""
        count = len(self.passed_over)
        if not count:
            return ""
        first = ", ".join(map(ascii, self.passed_over[:SHOWN])) + (
            f" and {count - SHOWN} more" if count > SHOWN else ""
        )
        return f"passed over {count} file{'s' * (count > 1)}: {first}"


def files_in(folder: Path, prefix: str, pattern: str | None) -> FolderFiles:
    """The files below a folder that are to be imported as `prefix`-<name of the file, and of its folders>.

    They match a pattern such as `*.TXT`, by name or from the folder on; without one their names end as recordings do.
    Raises BadInput where there is none, or where two would become the same run.
    """
    files = sorted(path for path in folder.rglob("*") if path.is_file() and not path.name.startswith("."))
    endings = tuple(sorted({ending for format_ in formats() for ending in format_.suffixes}))

    def is_recording(file: Path) -> bool:
        if pattern is not None:
            return fnmatch(file.name, pattern) or fnmatch(file.relative_to(folder).as_posix(), pattern)
        return _plain(file.name).lower().endswith(endings)

    taken = [file for file in files if is_recording(file)]
    passed_over = [str(file.relative_to(folder)) for file in files if file not in set(taken)]
    if not taken:
        nothing = f"that matches {pattern}" if pattern is not None else f"whose name ends in {', '.join(endings)}"
        problem = f"holds no file {nothing}; {FolderFiles({}, passed_over).sentence or 'it is empty'}"
        raise BadInput(folder, "file", problem, f"give a folder of recordings, or say which by {OPTION} '*.EXT'")
    file_by_run: dict[str, Path] = {}
    for file in taken:
        name = f"{prefix}-{slug(_plain(str(file.relative_to(folder))).rpartition('.')[0] or file.name)}"
        if name in file_by_run:
            problem = f"would be the run {name}, as {file_by_run[name]} would"
            raise BadInput(file, "file", problem, f"rename one of the two, or leave one out by {OPTION}")
        file_by_run[name] = file
    return FolderFiles(file_by_run, passed_over)


def _plain(name: str) -> str:
    """The name of a file that may be compressed, without the ending that says so."""
    return re.sub(r"\.gz$", "", name, flags=re.I)
