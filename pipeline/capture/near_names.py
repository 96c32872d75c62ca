"""Names of printed columns that are nearly those of channels: what was likely meant."""

import difflib
from collections.abc import Container, Sequence
from pathlib import Path

from ..ground.command import recover_command
from ..ground.errors import BadInput
from ..ground.header_units import header_unit
from ..run.description import Run
from ..run.folder import read_run
from ..run.named_units import TIMES, in_its_unit
from .fields import TIME
from .likely_names import likely
from .unnamed import LIKELY

USUAL: tuple[str, ...] = ("time_s", *LIKELY)  # of a run that nobody described yet
NEAR = 0.75  # likeness, from 0 to 1


def corrected(columns: Sequence[str], channels: Sequence[str], own: Container[object] = ()) -> tuple[str, ...]:
    """The columns, with those that are near a channel's name called as it is; `own` are names that run.yaml gives."""
    free = [name for name in (*channels, *TIMES) if name not in columns]
    names = []
    for name in columns:
        known = name in channels or name in own or any(in_its_unit(channel, [name]) for channel in channels)
        near = [] if known or TIME.fullmatch(name) else difflib.get_close_matches(name.lower(), free, cutoff=NEAR)
        names.append(next((each for each in near if each not in names and _same_unit(name, each)), name))
    return tuple(names)


def _same_unit(name: str, channel: str) -> bool:
    """Whether a name carries no other unit than a channel: load_kg is no misspelt load_n."""
    unit = header_unit(name)
    return unit is None or unit == header_unit(channel)


def mend_of(mend: str, columns: Sequence[str], run: Run, folder: Path) -> str:
    """The mend of columns that are not those of a run's channels: the names that were likely meant come first."""
    meant = corrected(columns, run.system.columns, [channel.column for channel in run.channels.values()])
    again = f"{recover_command(folder)} --columns"
    if meant == tuple(columns):
        own = [(channel.column, name) for name, channel in run.channels.items()]
        given: dict[object, str] = {column: name for column, name in own if column is not None}
        names = likely(columns, run.system.columns, given)
        if names and names != ",".join(columns):
            first = "call the columns as the channels that they likely are, in the order in which they are printed"
            return f"{first}: {again} {names}; or {mend}"
        return f"{mend}; or, with the names in the order in which they are printed: {again} ..."
    return f"did you mean {','.join(meant)}? Then: {again} {','.join(meant)}; or {mend}"


def doubt(columns: Sequence[str], folder: Path) -> str:
    """What is asked of names that a person gave for the columns of a run; empty where there is nothing to ask."""
    channels, own = USUAL, list[object]()
    try:
        run = read_run(folder)
        channels, own = run.system.columns, [channel.column for channel in run.channels.values()]
    except BadInput:
        pass  # it is said when the recording is there
    meant = corrected(columns, channels, own)
    strange = [name for name, near in zip(columns, meant, strict=True) if name != near]
    if not strange:
        return ""
    are = f"{' and '.join(strange)} {'is no channel' if len(strange) == 1 else 'are no channels'}"
    again = f"{recover_command(folder)} --columns {','.join(meant)}"
    return f"--columns: {are}; did you mean {','.join(meant)}? What is recorded is kept; this calls it so: {again}"
