"""The mend of a message as the command that makes it in the run.yaml that is there."""

import re
import shlex
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..ground.command import command
from ..ground.errors import BadInput
from .description import Tare
from .option_mend import DOUBT, EXCHANGE, GAP, values_told

CLAUSE = re.compile(r"(; |, or (?=it |set |check |record ))")  # between what is done and what is done instead
MEND = command("mend")


def mend_command(mend: str, folder: Path) -> str:
    """The command that does what a mend asks of the run.yaml in a folder; empty where no command can."""
    values = values_told(mend)
    if values and not any(str(value) == GAP for _, value in values):
        return _command(folder, " ".join(shlex.quote(f"{key}={value}") for key, value in values))
    pair = EXCHANGE.search(mend)
    return _command(folder, f"--exchange {pair[1]} {pair[2]}") if pair and not values else ""


def tare_command(folder: Path, tare: Tare) -> str:
    """The command that writes what the run in a folder says of its zero."""
    return _command(folder, f"tare={tare}")


def _command(folder: Path, words: str) -> str:
    return f"{MEND} {shlex.quote(str(folder))} {words}"


def with_command(error: BadInput, folder: Path) -> BadInput:
    """The error with the command beside each part of its mend that asks something of the folder's run.yaml."""
    parts = CLAUSE.split(error.mend)
    commands = [mend_command(part.removeprefix(DOUBT), folder) for part in parts]
    if not any(commands) or not (folder / "run.yaml").is_file():
        return error
    new_parts = [f"{part} ({to_type})" if to_type else part for part, to_type in zip(parts, commands, strict=True)]
    return BadInput(error.file, error.field, error.problem, "".join(new_parts))


def without_command(error: BadInput) -> BadInput:
    """The error without such commands."""
    return BadInput(error.file, error.field, error.problem, re.sub(rf" \({re.escape(MEND)} [^()]*\)", "", error.mend))


@contextmanager
def commanded(folder: Path) -> Iterator[None]:
    """Errors of what reads a run in it have the commands beside their mends."""
    try:
        yield
    except BadInput as error:
        new_error = with_command(error, folder)
        if new_error is error:
            raise
        raise new_error from None
