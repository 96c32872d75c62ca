"""The channel of each column of a foreign table, by its name, its unit and its numbers; unclear ones stay open."""

import re
from dataclasses import dataclass, field

import numpy as np
import pandas as pd

from ..formats.text_layout import with_point
from ..formats.time_stamps import holds_stamps, stamps_s
from ..ground.input.cell_numbers import cell_numbers
from ..ground.input.complaint import key_name
from ..ground.input.header_units import header_unit, unit_word
from ..ground.kinematics import Array
from ..ground.units import conversion, is_load_in_kg
from ..run.doubts.wrapping import unit_of_turn, unwrapping, wraps
from ..systems import System

WORDS = {  # by the first word of a channel: what people call it
    "time": r"time|zeit|^t$|t_|stamp|millis|micros|temps",
    "motor": r"motor|theta|angle|winkel|enc|turn|rev|rot|twist|phi|dreh|count|inkr",
    "displacement": r"disp|weg|contraction|stroke|travel|slide|lvdt|laser|pos|verschieb|hub|^x|_x$|length|carriage",
    "load": r"load|force|kraft|last|tension|weight|gewicht|zug|^f$",
    "torque": r"torque|moment|tau",
    "temperature": r"temp",
    "jaw": r"jaw|output|joint|front|gripper",
    "position": r"pos|^q|weg|^x",
    "force": r"force|kraft|vir|^u$|^f$",
}
WORDS["motor_current"] = r"curr|strom|amp|^i$|^i_"
NOT_MEASURED = re.compile(r"speed|vel|rate|cmd|command|target|desired|ref|soll|error|acc|filter|status|index", re.I)
RISING = 0.98  # share of steps: single wrong stamps are mended later
SIZES = {"turns": (2.0, 60.0), "rad": (60.0, 720.0), "deg": (720.0, 40_000.0)}  # a motor's range that is usual in each
STEP_S = (0.5e-4, 0.21)
SECONDS = {"s": 1.0, "ms": 1e-3, "us": 1e-6}
MOST_ALIKE = 8
SPARSE = 0.05  # of its cells are filled: a column with fewer is marks and remarks, no slow sensor


@dataclass
class Role:
    """The place of a channel: a column's name or index, its reading, and which of that is a guess."""

    column: str | int
    values: Array  # (rows,), in `unit`, the column's own unit
    unit: str | None
    scale: float = 1.0
    why: list[str] = field(default_factory=list)
    alike: bool = False  # whether other columns may be meant as well


def numbers(table: pd.DataFrame, comma: bool) -> dict[str | int, Array]:
    """Columns of a table that hold numbers, by name, or by index where the name is none or stands twice.

    Each of shape (rows,), in the file's own unit.
    """
    columns: dict[str | int, Array] = {}
    for place, name in enumerate(table.columns):
        column = table.iloc[:, place]
        if column.dtype.kind not in "fiu":
            read = stamps_s(column) if holds_stamps(column) else column.map(with_point) if comma else column
            column = cell_numbers(read)
        values = column.to_numpy(np.float64)
        full = int(column.notna().sum())
        if full > SPARSE * len(column) and np.isfinite(values).sum() > 0.5 * full:
            own = isinstance(name, str) and name and list(table.columns).count(name) == 1
            columns[name if own else place] = values
    return columns


def _unit(column: str | int, units: dict[str | int, str]) -> str | None:
    unit = (header_unit(column) or _named_by_unit(column)) if isinstance(column, str) else None
    return unit or unit_word(units.get(column, ""))


def _named_by_unit(name: str) -> str | None:
    """The unit of a column that is named by a unit alone, such as newton; None if it may be a count or an input."""
    unit = unit_word(name) if len(name.strip()) > 1 else None
    return None if unit == "count" or name.strip().lower() == "in" else unit


def _score(channel: str, column: str | int, values: Array, unit: str | None) -> int:
    """How well a column can be a channel: its name 2, its unit 2; below 0 where it cannot be."""
    stem = channel.rpartition("_")[0]
    score = 0
    if unit and not is_load_in_kg(channel, unit):  # kg alone tells no force: the name must
        try:
            conversion(channel, unit, 1.0)
        except ValueError:
            return -1
        score += 2 if unit != "V" else 0
    name = str(column).lower().rpartition(".")[2]
    if isinstance(column, str) and re.search(WORDS.get(stem, re.escape(stem)), name):
        score += 2
    if isinstance(column, str) and name.startswith(stem):
        score += 1
    if NOT_MEASURED.search(str(column)):
        score -= 3
    finite = values[np.isfinite(values)]
    if channel == "time_s":
        rises = len(finite) > 1 and (np.diff(finite) > 0).mean() >= RISING
        return score + 1 if rises else -1
    return score if np.ptp(finite) > 0 or stem in ("load", "temperature") else -1


def _is_rate(values: Array, unit: str) -> bool:
    """Whether time stamps in this unit have a rig's rate, 10 Hz to 10 kHz."""
    return STEP_S[0] <= float(np.median(np.diff(values))) * SECONDS[unit] <= STEP_S[1]


def _by_size(channel: str, values: Array) -> str | None:
    """The unit that a column's range makes likely, None where none does."""
    span = float(np.nanmax(values) - np.nanmin(values))
    if channel == "time_s":
        return next((unit for unit in SECONDS if _is_rate(values, unit)), None)
    if channel == "motor_turns":
        return next((unit for unit, (least, most) in SIZES.items() if least <= span < most), None)
    if channel == "displacement_mm":
        return "mm" if 1 <= span < 300 else "m" if 1e-3 <= span < 0.3 else None
    return None


def _sign(role: Role, other: Role | None) -> None:
    """Set the scale to -1 where winding lowers the motor's angle, or lowers what follows it."""
    values = role.values * role.scale
    if other is None:
        if np.nanmin(values) < 0 and abs(np.nanmin(values)) > 2 * abs(np.nanmax(values)):
            role.scale = -1.0
            role.why.append("winding counts down in the file")
        return
    good = np.isfinite(values) & np.isfinite(other.values)
    if np.ptp(values[good]) > 0 and np.corrcoef(values[good], other.scale * other.values[good])[0, 1] < 0:
        role.scale = -1.0
        role.why.append("it falls in the file while the motor winds")


def _wrapped(role: Role, unit: str | None) -> None:
    """Mark an angle that wraps; its unit is then not guessed from its size, and nor is the reading's sign."""
    role.unit = unit or unit_of_turn(role.values)
    role.why = [f"it jumps by its range again and again and goes on: it wraps; {unwrapping(role.unit)}"]


def _role(channel: str, column: str | int, values: Array, unit: str | None) -> Role:
    """The reading of a column as a channel: in its stated unit, else in the one that its numbers make likely."""
    likely = _by_size(channel, values)
    span = f"{np.nanmin(values):.6g} to {np.nanmax(values):.6g}"
    if channel == "time_s" and unit and likely and not _is_rate(values, unit):
        return Role(column, values, likely, why=[f"in {unit}, as its name says, it would have no rate of a rig"])
    if is_load_in_kg(channel, unit):
        return Role(column, values, "kgf", why=["kg is taken as kilograms of force, as a load cell shows them"])
    why = [f"the unit is a guess from its numbers, {span}"] if unit is None and likely else []
    return Role(column, values, unit or likely, why=why)


def find_roles(system: System, columns: dict[str | int, Array], units: dict[str | int, str]) -> dict[str, Role]:
    """The channels that were found, in the system's order; what no name or unit tells is not among them.

    `columns` have the shape (rows,) in the file's units; `units` says those that a header tells.
    """
    unit_by_column = {column: _unit(column, units) for column in columns}
    scores = [
        (_score(channel, column, values, unit_by_column[column]), -order, -place, channel, column)
        for order, channel in enumerate(system.columns)
        for place, (column, values) in enumerate(columns.items())
    ]
    roles: dict[str, Role] = {}
    won: dict[str, int] = {}
    for score, _, _, channel, column in sorted(scores, key=lambda scored: scored[:3], reverse=True):
        least = 1 if channel == "time_s" else 2
        free = column not in [role.column for role in roles.values()]
        if score >= least and free and channel not in roles:
            roles[channel], won[channel] = _role(channel, column, columns[column], unit_by_column[column]), score
    used = {role.column for role in roles.values()}
    for channel, role in roles.items():
        same = [scored[4] for scored in scores if scored[3] == channel and scored[0] == won[channel]]
        alike = [key_name(column) for column in same if column not in used]
        if alike:
            role.why.append(f"{', '.join(alike[:MOST_ALIKE])} may be meant as well")
            role.alike = True
    driver, follower = roles.get(system.driver), roles.get(system.channel)
    if driver and system.driver == "motor_turns" and wraps(driver.values):
        _wrapped(driver, unit_by_column[driver.column])
    elif driver and system.turn is not None:
        _sign(driver, None)
        if follower:
            _sign(follower, driver)
    return {channel: roles[channel] for channel in system.columns if channel in roles}
