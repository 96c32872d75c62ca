"""A mapping that was drafted for a file, on the screen or as a file of its own that replaces none."""

import shlex
import sys
from pathlib import Path

from ..ground.command import command
from ..ground.errors import BadInput
from ..ground.stored.files import write_text
from .draft import draft


def guess(file: Path, actuator: str | None, out: Path | None) -> None:
    """Print a mapping drafted for a file, or write it to `out`, and show the file's first rows as it reads them."""
    text, preview = draft(file, actuator)
    print(preview, file=sys.stderr)
    if out is None:
        print(text, end="")
        return
    try:
        write_text(out, text, new=True)
    except FileExistsError:
        raise BadInput(out, "--out", "is there already", "choose another name; no mapping is overwritten") from None
    then = f"{command('import_run')} {shlex.quote(str(file))} --map {shlex.quote(str(out))} --run NAME"
    print(f"{out}: fill in what is empty, check what is a guess, then: {then}")
