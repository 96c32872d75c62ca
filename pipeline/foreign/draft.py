"""A mapping drafted from a foreign file: the facts in its header and numbers, and gaps for a person to fill in."""

from pathlib import Path

import numpy as np
import pandas as pd

from ..formats import format_of
from ..ground.errors import BadInput
from ..ground.input.complaint import key_name
from ..ground.input.strict_yaml import write_yaml
from ..ground.input.text_file import TextFile
from ..ground.kinematics import Array
from ..ground.units import conversion
from ..ground.words.counts import counted
from ..run.description import String
from ..systems import System, systems
from .damaged import damaged_rows
from .recognised_columns import layout_yaml, recognise
from .roles import Role

USUAL = "separator"  # the kind of rig where nobody tells it
SHOWN_ROWS, SHOWN_COLUMNS = 5, 24
UNITS = {"turns": "turns, rad, deg or count", "deg": "deg, rad, turns or count", "mm": "mm, um, cm, m or in"}
UNITS |= {"s": "s, ms or us", "m": "m, cm, mm or in", "n": "N, kN, kgf, g or lbf", "nm": "Nm or Nmm", "c": "degC or K"}
NO_LOAD = (
    "the load in N that hung all the time, 0 for none; if a column has it, name it under channels and take this out"
)
MORE = [  # of a string, commented out: it may be left so
    "  # id: NAME  # of this very string, the same in all of its runs; without it each run counts as a new string",
    "  # stiffness_n_per_mm: K  # of the string, in N/mm; leave it out where nobody measured it",
    "  # strokes_before: 0  # that the string had done before its first recording",
]


def _filled(key: str, what: str, indent: int = 2) -> str:
    return f"{' ' * indent}{key}:  # fill in: {what}"


def _actuator(name: str, is_told: bool) -> str:
    """The kind of rig: no file tells it, so it is a guess unless a person gives it."""
    mend = "without a separator write twisted_pair, and take both lengths out of rig (if nothing is left: rig: {})"
    check = f"  # check: a guess; {mend}"
    return f"actuator: {name}{'' if is_told else check}"


def _rig(system: System, has_load: bool) -> list[str]:
    """The sections that no file tells: the string, the rig's dimensions, and a string's load if no column has it."""
    lines = []
    if system.needs_string:
        keys = ("material", "radius_mm", "length_mm")
        meanings = {key: String.model_fields[key].description or key for key in keys}
        lines += ["string:", *(_filled(key, what) for key, what in meanings.items()), *MORE]
    rig = [_filled(key, f"{key.rpartition('_')[0].replace('_', ' ')}, {what}") for key, what in system.rig.items()]
    if system.load == "load_n" and not has_load:
        rig.append(_filled("load_n", NO_LOAD))
    return [*lines, "rig:", *rig] if rig else lines


def _layout(layout: TextFile) -> list[str]:
    own = "  # rows: of this file alone, below which stands no recording" if layout.rows else ""
    settings = layout_yaml(layout)
    return [f"file: {settings}{own}"] if settings else []


def _span(values: Array) -> str:
    return f"{np.nanmin(values):.6g} to {np.nanmax(values):.6g}"


def _channel(channel: str, role: Role | None, free: list[str | int]) -> list[str]:
    """Lines of a channel, with what a person must fill in or check."""
    unit = UNITS.get(channel.rpartition("_")[2], "its unit")
    if role is None:
        names = ", ".join(key_name(column) for column in free[:SHOWN_COLUMNS]) or "its columns: no other has numbers"
        return [f"  {channel}:", _filled("column", f"one of {names}", 4), _filled("unit", unit, 4)]
    settings: dict[str, object] = {"column": role.column, "unit": role.unit, "scale": role.scale}
    settings = {key: value for key, value in settings.items() if value is not None and (key, value) != ("scale", 1.0)}
    check = f"  # check: {'; '.join(role.why)}" if role.why else ""
    if role.unit is not None and role.unit != "count":
        return [f"  {channel}: {write_yaml(settings, flow=True)}{check}"]
    body = write_yaml(settings).rstrip("\n").replace("\n", "\n    ")
    missing = ("counts_per_turn", "how many counts a turn has") if role.unit else ("unit", unit)
    return [f"  {channel}:{check}", f"    {body}", _filled(*missing, 4)]


def _in_our_units(channel: str, role: Role) -> Array | None:
    try:
        factor, shift = conversion(channel, role.unit, None)
    except ValueError:
        return None
    return np.asarray(factor * role.scale * role.values + shift)


def _preview(
    path: Path, kind: str, roles: dict[str, Role], columns: dict[str | int, Array], words: dict[str, str]
) -> str:
    """The first rows as they would be read, and the columns that are not used."""
    read = {channel: values for channel, role in roles.items() if (values := _in_our_units(channel, role)) is not None}
    count = max((len(values) for values in columns.values()), default=0)
    lines = [f"{path}: {kind} with {counted(count, 'row')} of {counted(len(columns), 'column')} of numbers"]
    if read:
        shown = pd.DataFrame({channel: values[:SHOWN_ROWS] for channel, values in read.items()})
        lines += ["its first rows, as they are read:", shown.to_string(index=False)]
    used = {role.column for role in roles.values()}
    free = [f"  {key_name(column)}: {_span(values)}" for column, values in columns.items() if column not in used]
    free += [f"  {name}: {what}" for name, what in words.items()]
    more = [f"  and {len(free) - SHOWN_COLUMNS} more"] if len(free) > SHOWN_COLUMNS else []
    return "\n".join([*lines, *(["not read:"] if free else []), *free[:SHOWN_COLUMNS], *more])


def draft(path: Path, told_actuator: str | None) -> tuple[str, str]:
    """Text of a mapping for a file, and a preview of its first rows; raises BadInput for a file that is not read."""
    actuators, actuator = systems(), told_actuator or USUAL
    if actuator not in actuators:
        raise BadInput("--actuator", "actuator", f"{actuator!r} is not known", f"use one of {', '.join(actuators)}")
    system = actuators[actuator]
    seen = recognise(path, system)
    layout, columns, roles = seen.layout, seen.columns, seen.roles
    kind = format_of(path).name
    damaged = "".join(f"\n{sentence}" for sentence in damaged_rows(path, layout, columns))
    free = [column for column in columns if column not in [role.column for role in roles.values()]]
    wanted = [channel for channel in system.columns if channel in roles or channel in system.columns[:3]]
    lines = [f"# A mapping for {key_name(path.name)} and files like it, drafted from {kind}."]
    lines += ["# Fill in what is empty, check what is a guess, then import it through this mapping."]
    lines += [_actuator(actuator, told_actuator is not None), *_rig(system, "load_n" in roles)]
    lines += [*_layout(layout), "channels:"]
    if all(channel in roles and roles[channel].alike for channel in (system.driver, system.channel)):
        lines += ["  # two axes in one file: write their channels under axes (docs/import.md); each makes a run"]
    for channel in wanted:
        lines += _channel(channel, roles.get(channel), free)
    return "\n".join(lines) + "\n", _preview(path, kind, roles, columns, seen.words) + damaged + seen.uneven + seen.foot
