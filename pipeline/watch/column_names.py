"""The names of a text recording's columns: those that capture stored, and those in run.yaml."""

from pathlib import Path

from ..capture.uncommitted_note import noted_columns
from ..ground.errors import BadInput
from ..ground.units import conversion
from ..run.description import Channel, Run
from ..run.folder import capture_info
from ..run.table.named_units import in_its_unit

Scaled = tuple[str, float, float]  # a channel's name, and what makes a printed number one in its unit: factor, shift


def stored_columns(folder: Path) -> tuple[str, ...]:
    """The names that --columns gave, also for a recording under way; none where the rig prints them itself."""
    try:
        info = capture_info(folder)
    except (BadInput, OSError):
        return ()
    columns = info.get("columns")
    if info and isinstance(columns, list) and info.get("columns_given"):
        return tuple(map(str, columns))
    return () if info else noted_columns(folder)


def channel_of(run: Run | None, printed: tuple[str, ...], at: int) -> Scaled:
    """The channel of a printed column in this run: in our unit, or under its printed name."""
    for name in run.system.columns if run else ():
        channel = run.channels.get(name) if run else None
        if channel is None and name not in printed and (in_unit := in_its_unit(name, printed)):
            channel = Channel.model_validate({"column": in_unit[0], "unit": in_unit[1]})
        if channel is None or (name if channel.column is None else channel.column) not in (at, printed[at]):
            continue
        try:
            factor, shift = conversion(name, channel.unit, channel.counts_per_turn)
        except ValueError:
            break
        return name, factor * channel.scale, factor * channel.offset + shift
    return printed[at], 1.0, 0.0
