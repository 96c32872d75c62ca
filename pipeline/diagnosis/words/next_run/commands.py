"""The ready command lines for a proposed run: its folder, its recording, and its diagnosis with the old run."""

import shlex
from pathlib import Path

from ....ground.command import command
from ....ground.errors import BadInput
from ....ground.input.complaint import key_name
from ....run.folder import read_run
from ....run.table.recording_source import mapping_of, own_log
from ..language.quantity import listing
from ..language.vocabulary import Vocabulary

DIAGNOSE = command("diagnose")
CAPTURE = (
    "PORT is the rig's; --text where it prints lines of numbers. With a file of your own logger give new_run "
    "--recording FILE instead, and leave the capture line out."
)
OWN_LOG = "{file} is the new file of your logger, with the columns {columns}."
ONE_LOAD = "It names no load: new_run takes {load_n:g} N. For each other load record a run of its own, with --load-n N."
IMPORTED = "{file} is the new file of your logger. The mapping says the load too: where it changes, copy and change it."


def lines(folders: list[Path], out: Path | None, loads: list[str]) -> list[str]:
    """The commands for one new run beside the last of `folders` for each of `loads`, then that of the diagnosis.

    A load is that of `--load-n`, empty where it stays. `out` is the folder of the diagnosis that proposes the run.
    A run that came from a file, or through a mapping, is made in that way again.
    """
    old = folders[-1]
    endings = [f"-{number}" for number in range(1, len(loads) + 1)] if len(loads) > 1 else [""]
    new = [old.with_name(f"{old.name}-next{ending}") for ending in endings]
    record_lines = []
    for folder, load, ending in zip(new, loads, endings, strict=True):
        record_lines += _recorded(old, folder, load, _file(old, ending))
    where = shlex.quote(str(out.with_name(f"{out.name}-next"))) if out else "DIR"
    named = " ".join(shlex.quote(str(folder)) for folder in (*folders, *new))
    return [*record_lines, f"{DIAGNOSE} {named} --together --out {where}"]


def _recorded(old: Path, new: Path, load: str, file: str) -> list[str]:
    """The commands that make the run `new` with its recording, like the run `old`; `file` is a logger's."""
    name, mapping = shlex.quote(new.name), mapping_of(old)
    if mapping:
        out = shlex.quote(str(new.parent))
        again = f"{command('import_run')} {file} --map {shlex.quote(mapping)} --run {name}{_of_string(old)} --out {out}"
        return [again]
    like = f"{command('new_run')} {name} --like {shlex.quote(str(old))}{f' --load-n {load}' if load else ''}"
    if own_log(old):
        return [f"{like} --recording {file}"]
    return [like, f"{command('capture')} PORT {shlex.quote(str(new))}"]


def _of_string(old: Path) -> str:
    """The option that says that a new run is of the string of an old one; empty where that has none."""
    try:
        run = read_run(old)
    except BadInput:
        return ""
    return f" --string-id {shlex.quote(run.string_id)}" if run.string else ""


def _file(old: Path, ending: str = "") -> str:
    """The placeholder for a logger's new file; an imported file may have any ending."""
    return f"FILE{ending}{'.csv' * (bool(own_log(old)) and not mapping_of(old))}"


def remark(old: Path, words: Vocabulary) -> str:
    """What to fill into the commands that make a run as `old` was made."""
    if mapping_of(old):
        return IMPORTED.format(file=_file(old))
    if not own_log(old):
        return CAPTURE
    sentence = OWN_LOG.format(file=_file(old), columns=listing(_columns(old, words)))
    load_n = _constant_load(old, words)
    return sentence if load_n is None else f"{sentence} {ONE_LOAD.format(load_n=load_n)}"


def _constant_load(old: Path, words: Vocabulary) -> float | None:
    """The load in N that run.yaml gives for the whole recording; None where the recording tells it, or has none."""
    try:
        run = read_run(old)
    except BadInput:
        return None
    return run.rig[words.load] if words.load in run.rig and words.load not in run.channels else None


def _columns(old: Path, words: Vocabulary) -> list[str]:
    """The columns of a recording as run.yaml of `old` names them, with the load's unless the load is constant."""
    channels = ["time_s", words.driver, words.channel, *([words.load] if words.load else [])]
    try:
        run = read_run(old)
    except BadInput:
        return channels
    columns = {name: channel.column for name, channel in run.channels.items() if channel.column is not None}
    return [_called(columns.get(name, name)) for name in channels if name in run.channels or name not in run.rig]


def _called(column: str | int) -> str:
    """A column by its name, or by its index from 0."""
    return f"column {column}" if isinstance(column, int) else key_name(column)


def block(commands: list[str], old: Path, words: Vocabulary) -> list[str]:
    """The commands as a verdict shows them, with what they take over from the run `old` and what to fill in."""
    taken = f"--like takes the dimensions{' and the string id' if words.twisted else ''} from {old.name}"
    if mapping_of(old):
        taken = f"the mapping {'and the string id are those' if words.twisted else 'is that'} of {old.name}"
    return [f"The commands, in this order; {taken}:", *(f"  {line}" for line in commands), remark(old, words)]
