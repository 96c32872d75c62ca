"""Which printed column is read as which channel, and in which unit: it shows a person a swapped column."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from ...ground.units import unit_of
from ...run.description import Channel, Run
from ...run.folder import described
from ...run.table.named_units import in_its_unit
from .naming import NEEDED
from .near_names import mend_of

MOST = 6  # columns that are shown


class Place(NamedTuple):
    """The channel that a column is read as, and how."""

    channel: str
    unit: str
    scale: float = 1.0


class ReadChannels:
    """The channels of a folder's run for columns of these names; none are known for a run without a description.

    It is what `run/table/channels.py` does with a table, without pandas, for which no rig should wait.
    """

    def __init__(self, folder: Path, columns: Sequence[str]) -> None:
        self.folder, self.columns = folder, columns
        self.places: dict[str, Place] = {}
        self.lacking: list[str] = []
        self.run = described(folder)
        if self.run is None:
            return
        for name in self.run.system.columns:
            self._place(name, self.run)

    def _place(self, name: str, run: Run) -> None:
        columns, own_columns = self.columns, run.system.columns
        named = [channel.column for channel in run.channels.values()]
        channel = run.channels.get(name, Channel.model_validate({}))
        column: str | int = name if channel.column is None else channel.column
        unit = channel.unit or unit_of(name)
        if channel.step_s is not None:
            return
        if name not in run.channels and name not in columns:
            free = [each for each in columns if each not in own_columns and each not in named]
            if in_unit := in_its_unit(name, free):
                column, unit = in_unit
            elif name not in own_columns[:NEEDED]:
                return
        if isinstance(column, int) and 0 <= column < len(columns):
            column = columns[column]
        if column in columns:
            self.places[str(column)] = Place(name, unit, channel.scale)
        else:
            self.lacking.append(str(column))

    def values(self, last: Sequence[str]) -> list[str]:
        """Each column's last value, with the channel and the unit that it is read as."""
        parts = [self._value(column, value) for column, value in zip(self.columns, last, strict=False)]
        return [*parts[:MOST], *([f"{len(parts) - MOST} more"] if len(parts) > MOST else [])]

    def _value(self, column: str, value: str) -> str:
        if self.run is None:
            return f"{column} = {value}"
        if column not in self.places:
            return f"{column} = {value} (no channel)"
        channel, unit, scale = self.places[column]
        own = [f"from {column}"] if column != channel else []
        own += [f"times {scale:g}"] if scale != 1.0 else []
        shown = f" {unit}" if unit != unit_of(channel) or column != channel else ""
        whence = f" ({', '.join(own)})" if own else ""
        return f"{channel} = {value}{shown}{whence}"

    @property
    def all_fit(self) -> bool:
        """Whether the run is described, and each column is read as one of its channels."""
        return self.run is not None and not self.lacking and {*self.columns} == {*self.places}

    def warning(self) -> str:
        """Why nothing can use the run with columns of these names, and the mend; empty where it can be used."""
        if self.run is None or not self.lacking:
            return ""
        lacking = " and ".join(map(repr, self.lacking))
        are = "is no column" if len(self.lacking) == 1 else "are no columns"
        mend = mend_of("name them under channels in run.yaml", self.columns, self.run, self.folder)
        return (
            f"warning: nothing can use this run as it stands: there {are} {lacking}, only {', '.join(self.columns)}. "
            f"All is kept. Mend, when the recording has ended: {mend}"
        )
