"""The options of `new_run` for reading a log, as far as the log tells them: they replace a mapping."""

from pathlib import Path
from typing import Any

from ..ground.command import quoted
from ..ground.errors import BadInput
from ..ground.input.bare_columns import written_out
from ..ground.input.header_units import header_unit
from ..ground.input.strict_yaml import write_yaml
from ..ground.units import unit_of
from ..run.description import Channel, Run
from ..run.table.column_places import NoColumn
from .recognised_columns import Recognised, layout_yaml, recognise
from .roles import Role

GAP = "…"


def _channel(channel: str, role: Role | None) -> Any:
    """A channel as a column's name if that is enough, else with its keys, and a gap for what the log does not tell."""
    if role is None:
        return GAP
    whole: dict[str, object] = {"column": role.column, "unit": role.unit or GAP}
    if role.unit == "count":
        whole["counts_per_turn"] = GAP
    whole |= {"scale": int(role.scale)} if role.scale != 1.0 else {}
    if whole["unit"] == unit_of(channel) and header_unit(str(role.column)) in (None, unit_of(channel)):
        del whole["unit"]
    return role.column if whole == written_out(channel, role.column) else whole


def options(path: Path, run: Run) -> str:
    """`--file` and `--channels` for a log, each where the run's description does not fit; raises BadInput."""
    seen, system, option_words = recognise(path, run.system), run.system, []
    if seen.layout != run.file:
        option_words.append(f"--file {quoted(layout_yaml(seen.layout) or '{}')}")
    if not _has_columns(seen, run):
        names = [name for name in system.columns if name in seen.roles or name in system.columns[:3]]
        channels = {name: _channel(name, seen.roles.get(name)) for name in names}
        option_words.append(f"--channels {quoted(write_yaml(channels, flow=True))}")
    return " ".join(option_words)


def _has_columns(seen: Recognised, run: Run) -> bool:
    """Whether a log has the columns that a run's channels name, and the channels with a column of their own name."""
    channels = dict.fromkeys(run.system.columns[:3], Channel.model_validate({})) | run.channels
    columns = [name if each.column is None else each.column for name, each in channels.items() if each.step_s is None]
    return all(column in seen.columns for column in columns if isinstance(column, str))


def by_look(error: BadInput, path: Path, run: Run) -> BadInput | None:
    """The error on a log with another form or other columns, with the fitting options as its mend.

    None where it says something else, or the log does not tell them.
    """
    if not isinstance(error, NoColumn) and not error.field.startswith("file."):
        return None
    try:
        option_text = options(path, run)
    except BadInput:
        return None
    if not option_text:
        return None
    then = f"fill in each {GAP} and check it" if GAP in option_text else "check it"
    return BadInput(error.file, error.field, error.problem, f"add what the file looks like, and {then}: {option_text}")
