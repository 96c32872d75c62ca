"""Names of printed columns that are close to those of channels: the names that were likely meant."""

import difflib
from collections.abc import Container, Sequence
from contextlib import suppress
from pathlib import Path

from ...ground.command import recover_command
from ...ground.errors import BadInput
from ...ground.input.header_units import header_unit
from ...run.description import Run
from ...run.folder import read_run
from ...run.table.named_units import TIMES, in_its_unit
from .fields import TIME
from .likely_names import likely
from .naming import USUAL, naming_of

NEAR = 0.75  # likeness, from 0 to 1


def corrected(columns: Sequence[str], channels: Sequence[str], own: Container[object] = ()) -> tuple[str, ...]:
    """The columns, with names close to a channel's corrected; `own` are names that run.yaml gives."""
    free = [name for name in (*channels, *TIMES) if name not in columns]
    names = []
    for name in columns:
        is_channel = name in channels or name in own or any(in_its_unit(channel, [name]) for channel in channels)
        near = [] if is_channel or TIME.fullmatch(name) else difflib.get_close_matches(name.lower(), free, cutoff=NEAR)
        names.append(next((each for each in near if each not in names and _same_unit(name, each)), name))
    return tuple(names)


def _same_unit(name: str, channel: str) -> bool:
    """Whether a name carries no other unit than a channel: load_kg is no misspelt load_n."""
    unit = header_unit(name)
    return unit is None or unit == header_unit(channel)


def mend_of(mend: str, columns: Sequence[str], run: Run, folder: Path) -> str:
    """The mend for columns that are not those of a run's channels: the names that were likely meant come first."""
    meant, names = _meant(columns, run)
    again = f"{recover_command(folder)} --columns"
    if names and names != ",".join(columns):
        if names == ",".join(meant):
            return f"did you mean {names}? Then: {again} {names}; or {mend}"
        first = "call the columns as the channels that they likely are, in the order in which they are printed"
        return f"{first}: {again} {names}; or {mend}"
    return f"{mend}; or {naming_of(run, folder).mend(len(columns), recover_command(folder))}"


def _meant(columns: Sequence[str], run: Run | None) -> tuple[tuple[str, ...], str]:
    """The columns without spelling mistakes, and one complete list of their likely channels, empty where unsure."""
    channels = run.system.columns if run else USUAL
    own = [(channel.column, name) for name, channel in run.channels.items()] if run else []
    name_by_column: dict[object, str] = {column: name for column, name in own if column is not None}
    meant = corrected(columns, channels, name_by_column)
    return meant, likely(meant, channels, name_by_column)


def doubt(columns: Sequence[str], folder: Path) -> str:
    """The question about the columns' names that a person gave for a run; empty where there is nothing to ask."""
    run: Run | None = None
    with suppress(BadInput):  # it is said when the recording is there
        run = read_run(folder)
    meant, names = _meant(columns, run)
    if meant == tuple(columns):
        return ""
    names = names or ",".join(meant)
    strange = [name for name, near in zip(columns, names.split(","), strict=True) if name != near.partition(" ")[0]]
    are = f"{' and '.join(strange)} {'is no channel' if len(strange) == 1 else 'are no channels'}"
    again = f"{recover_command(folder)} --columns {names}"
    return f"--columns: {are}; did you mean {names}? What is recorded is kept; this calls it so: {again}"
