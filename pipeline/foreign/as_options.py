"""The options of `new_run` for reading a log, as far as the log tells them: they replace a mapping."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ..ground.command import command, quoted
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


def options(path: Path, run: Run) -> dict[str, str]:
    """Values of `--file` and `--channels` for a log, each where the run's description does not fit; raises BadInput."""
    seen, system, values = recognise(path, run.system), run.system, {}
    if seen.layout != run.file:
        values["--file"] = layout_yaml(seen.layout) or "{}"
    if not _has_columns(seen, run):
        names = [name for name in system.columns if name in seen.roles or name in system.columns[:3]]
        channels = {name: _channel(name, seen.roles.get(name)) for name in names}
        values["--channels"] = write_yaml(channels, flow=True)
    return values


def _has_columns(seen: Recognised, run: Run) -> bool:
    """Whether a log has the columns that a run's channels name, and the channels with a column of their own name."""
    channels = dict.fromkeys(run.system.columns[:3], Channel.model_validate({})) | run.channels
    columns = [name if each.column is None else each.column for name, each in channels.items() if each.step_s is None]
    return all(column in seen.columns for column in columns if isinstance(column, str))


class OtherForm(BadInput):
    """A log of another form or with other columns than was said; `values` are those of the options that read it."""

    def __init__(self, error: BadInput, values: dict[str, str]) -> None:
        self.values = values
        text = " ".join(f"{option} {quoted(value)}" for option, value in values.items())
        self.then = f"fill in each {GAP} and check it" if GAP in text else "check it"
        mend = f"add what the file looks like, and {self.then}: {text}"
        super().__init__(error.file, error.field, error.problem, mend)

    def by_command(self, typed: Sequence[str]) -> BadInput:
        """The same with the whole command of `new_run` as its mend, on a line of its own.

        `typed` are the words that were typed, without the options that are given anew.
        """
        end = typed.index("--") if "--" in typed else len(typed)
        words = [*typed[:end], *(word for pair in self.values.items() for word in pair), *typed[end:]]
        mend = f"say what the file looks like by the command below, and {self.then}"
        line = " ".join([command("new_run"), *map(quoted, words)])
        return BadInput(self.file, self.field, self.problem, f"{mend}\n  {line}")


def by_look(error: BadInput, path: Path, run: Run) -> OtherForm | None:
    """The error on a log with another form or other columns, with the fitting options as its mend.

    None where it says something else, or the log does not tell them.
    """
    if not isinstance(error, NoColumn) and not error.field.startswith("file."):
        return None
    try:
        values = options(path, run)
    except BadInput:
        return None
    return OtherForm(error, values) if values else None
