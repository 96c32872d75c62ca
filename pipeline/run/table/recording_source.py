"""The source of a run folder's recording: a port, another logger's file, or an import by a mapping."""

import ast
import re
from pathlib import Path

from ..folder import CAPTURED, RECORDINGS

MAPPING = re.compile(r"^# through the mapping (.+), sha256 [0-9a-f]{64}$", re.MULTILINE)  # as import_run writes it
HEAD = 4_000  # characters of a run.yaml in which its first comments stand


def own_log(folder: Path) -> str:
    """The ending of a recording file that a person put into a run folder; empty if there is none."""
    if any((folder / name).exists() for name in CAPTURED):
        return ""
    names = [name for name in RECORDINGS if name not in CAPTURED and (folder / name).is_file()]
    return names[0].removeprefix("recording") if names else ""


def mapping_of(folder: Path) -> str:
    """The mapping through which a run was imported, as its run.yaml names it; empty if it was not imported."""
    try:
        with (folder / "run.yaml").open(encoding="utf-8") as file:
            written = MAPPING.search(file.read(HEAD))
        return str(ast.literal_eval(written[1])) if written else ""
    except (OSError, ValueError, SyntaxError):
        return ""
