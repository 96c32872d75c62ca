"""A foreign file and a mapping → run folders, an axis each, checked before anything is written."""

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pandas as pd

from ..formats import read_foreign
from ..ground.errors import BadInput
from ..ground.input.strict_yaml import read_yaml, write_yaml
from ..ground.names import checked, own_material, run_name
from ..ground.stored import schemas
from ..ground.stored.whole_folder import whole_folder
from ..ground.words.counts import counted, mends
from ..run.description import parse_run
from ..run.doubts.plausible_dimensions import dimension_questions
from ..run.doubts.tolerances_given import read_back
from ..run.run_yaml import RunYaml
from ..run.samples import check, check_finite, questions
from ..run.table.columns_read import read_as
from ..run.table.named_units import in_its_unit
from ..run.table.read_log import read_log
from ..run.table.recorded_table import asked_columns
from .axes import each_axis
from .empty_fields import refuse_empty
from .mended_clock import check_mended, mend_time
from .origin import origin
from .told_units import check_told_units

TAKEN = "choose another --run, or remove that folder yourself if nobody needs it: runs are never overwritten"


def read_mapping(path: Path) -> dict[str, object]:
    """Content of a mapping; raises BadInput when it is not there, not YAML, or names a run."""
    content = read_yaml(path)
    if not isinstance(content, dict) or {"run", "mended"} & content.keys():
        raise BadInput(path, "mapping", "is not a mapping", "write it as a run.yaml, without run and mended")
    refuse_empty(content, path)
    return content


def write_run(content: RunYaml, samples: pd.DataFrame, folder: Path, came_from: str) -> None:
    """Make a run folder, whole or not at all; raises BadInput when it is there already."""
    with whole_folder(folder, "run", TAKEN) as temporary:
        schemas.write(samples, schemas.samples(list(samples.columns)), temporary / "recording.parquet")
        (temporary / "run.yaml").write_text(came_from + write_yaml(content), encoding="utf-8")


@dataclass(frozen=True)
class ImportedRun:
    """A run that is ready to be written, and a sentence on it."""

    content: RunYaml
    samples: pd.DataFrame
    folder: Path
    said: str


def _checked(file: Path, mapping: Path, own: dict[str, object], name: str, out: Path) -> ImportedRun:
    """The run that a file makes by the content of a mapping; raises BadInput."""
    folder = out / name
    content = {"run": name, **own}
    try:
        checked(run_name, name, folder / "run.yaml", "run")
        run = parse_run(content, folder / "run.yaml")
        if run.string:
            checked(own_material, run.string.material, mapping, "string.material")
    except BadInput as error:  # the mapping is what a person can mend, but for the name
        where = "--run" if error.field == "run" else str(mapping)
        raise BadInput(where, error.field, error.problem, error.mend) from None
    log = read_log(run, file, mapping, lambda: read_foreign(file, run.file, asked_columns(run)))
    check_told_units(run, mapping, file, list(log.table.columns))
    check_finite(log.samples, file, log.where)
    time_s, mended = mend_time(log.samples["time_s"].to_numpy())
    check_mended(log.samples["time_s"].to_numpy(), time_s, file, log.where)
    samples = log.samples.assign(time_s=time_s).reset_index(drop=True)
    checked_samples, _ = check(run, samples, file, log.where)  # a run folder keeps all: ingest leaves out what this did
    for question in [*dimension_questions(run, mapping), *questions(run, checked_samples, file)]:
        print(f"warning: {question}", file=sys.stderr)
    loads = "load_n" in run.channels or "load_n" in log.table.columns or in_its_unit("load_n", log.table.columns)
    if not loads:  # rig.load_n stays the one place that says it
        samples, checked_samples = (each.drop(columns="load_n", errors="ignore") for each in (samples, checked_samples))
    kept = {key: value for key, value in content.items() if key not in ("file", "channels")}
    rules = ", ".join(mends(mended))
    sentence = f"{folder}: {counted(len(samples), 'sample')}" + (f"; mended {rules}" if rules else "")
    sentence = "\n".join(
        filter(
            None, (sentence, read_as(run, checked_samples, file, len(samples), list(log.table.columns)), read_back(run))
        )
    )
    described: Any = {**kept, **({"mended": mended} if mended else {})}
    return ImportedRun(described, samples, folder, sentence)


def import_run(file: Path, mapping: Path, name: str, out: Path, string_id: str | None = None) -> str:
    """Import one file as run `name` under `out`, or one run an axis; a sentence on each that was made.

    `string_id` goes before the mapping's. No other run is looked at. Raises BadInput, before anything is written.
    """
    return "\n".join(run.said for run in imported(file, mapping, name, out, string_id))


def imported(file: Path, mapping: Path, name: str, out: Path, string_id: str | None) -> list[ImportedRun]:
    """As `import_run`: the runs that were made."""
    axes = each_axis(read_mapping(mapping), mapping, string_id)
    names = {axis: f"{name}-{axis}" if axis else name for axis in axes}
    runs = [_checked(file, mapping, own, names[axis], out) for axis, own in axes.items()]
    for run in runs:
        if run.folder.exists():
            raise BadInput(run.folder, "run", "is there already", TAKEN)
    for run in runs:
        write_run(run.content, run.samples, run.folder, origin(file, mapping))
    return runs
