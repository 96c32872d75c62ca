"""The units that a file tells in its columns' names, or in a row below them: none is passed over without a word."""

from collections.abc import Sequence
from pathlib import Path

from ..ground.errors import BadInput
from ..ground.input.complaint import key_name
from ..ground.input.header_units import header_unit, unit_word
from ..ground.units import conversion, is_load_in_kg, unit_of
from ..run.description import Channel, Run
from .layout_guess import guess_layout


def check_told_units(run: Run, mapping: Path, path: Path | None = None, columns: Sequence[object] = ()) -> None:
    """Raise BadInput where a channel without a unit of its own is read from a column that tells another unit.

    `columns` are those of the recording at `path`, if there is one. A channel with a scale other than 1 or -1 is left
    alone: that may be the conversion.
    """
    row = guess_layout(path).units if path is not None and run.file.skip_below else []
    for name in run.system.columns:
        channel = run.channels.get(name, Channel.model_validate({}))
        if channel.unit is not None or channel.step_s is not None or abs(channel.scale) != 1.0:
            continue
        column: object = name if channel.column is None else channel.column
        if isinstance(column, int):
            column = columns[column] if 0 <= column < len(columns) else ""
        below = row[columns.index(column)] if column in columns and columns.index(column) < len(row) else ""
        by_name, by_row = header_unit(str(column)), unit_word(below)
        meant = by_row if by_row and _is_another(name, by_row) else by_name
        if meant and _is_another(name, meant):
            where = (
                f"the row of units below {key_name(column)}" if meant == by_row else f"the column {key_name(column)}"
            )
            problem = f"is missing: {where} says {meant}, and {name} would be read in {unit_of(name)}"
            right, own = ("kgf", " (kilograms of force)") if meant == "kg" else (meant, "")
            mend = f"set channels.{name}.unit to '{right}'{own}, or to {unit_of(name)} if it is in that all the same"
            raise BadInput(mapping, f"channels.{name}.unit", problem, mend)


def _is_another(channel: str, unit: str) -> bool:
    """Whether a unit is another one than a channel's own, and of its quantity, or kg of a force."""
    if unit in (unit_of(channel), "V", "count"):
        return False
    try:
        conversion(channel, unit)
    except ValueError:
        return is_load_in_kg(channel, unit)
    return True
