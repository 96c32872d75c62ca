"""Measured dimensions, and a recording if there is one → a run folder, checked before anything is written."""

import sys
from pathlib import Path

import pandas as pd

from ..formats.own_table import read_table
from ..ground.errors import BadInput
from ..ground.input.strict_yaml import write_yaml
from ..ground.names import checked, own_material, run_name
from ..ground.stored.files import write_text
from ..ground.stored.whole_folder import whole_folder
from ..run.checked_clock import WrongClock
from ..run.description import Run, parse_run
from ..run.doubts.plausible_dimensions import dimension_questions
from ..run.folder import is_recorded, recording_path
from ..run.option_mend import by_option
from ..run.run_yaml import RunYaml
from ..run.samples import check, questions
from ..run.table.columns_read import read_as
from ..run.table.file_lines import FileLines, Where
from ..run.table.read_log import copy_log, read_log, recording_name, rows_left
from ..run.table.recorded_table import read_recording
from .as_options import by_look
from .same_recording import warn_of_copies
from .told_units import check_told_units


def check_samples(run: Run, samples: pd.DataFrame, path: Path, sure: bool, where: Where) -> pd.DataFrame:
    """The samples that count; raises BadInput as ingest does, and, unless `sure`, for a likely mistake."""
    checked_samples, _ = check(run, samples, path, where)
    _question(questions(run, checked_samples, path), sure)
    return checked_samples


def _question(doubts: list[BadInput], sure: bool) -> None:
    """Refuse a likely mistake, or tell it where a person is `sure`; raises BadInput."""
    for question in doubts:
        if not sure:
            mend = f"{question.mend}; if it is right as it is, add --sure"
            raise BadInput(question.file, question.field, question.problem, mend)
        print(f"warning: {question}", file=sys.stderr)


def make_run(
    content: RunYaml, recording: Path | None, out: Path, sure: bool = False, material_known: bool = False
) -> Path:
    """Write `out/<run>/run.yaml`, checked, with a copy of the recording; whole or not at all. Raises BadInput.

    `material_known`: the material is that of a run that is there already: a reserved name is right until something is
    recorded.
    """
    name = checked(run_name, str(content["run"]), out / "run.yaml", "run")
    folder, path = out / name, out / name / "run.yaml"
    run = parse_run(content, path)
    if run.string and not (material_known and recording is None):
        checked(own_material, run.string.material, path, "string.material")
    taken = "choose another name, or remove that folder yourself if nobody needs it: runs are never overwritten"
    try:
        check_told_units(run, path)
        _question(dimension_questions(run, path), sure)
    except BadInput as error:
        raise by_option(error, content) from None
    if path.exists() or (folder.exists() and recording is not None):
        raise BadInput(folder, "run", "is there already", taken)
    if recording is not None:
        kept = recording_name(recording)
        try:
            log = read_log(run, recording, path, lambda: read_table(recording, run.file))
            check_told_units(run, path, recording, list(log.table.columns))
            counting = check_samples(run, log.samples, recording, sure, log.where)
            reads = read_as(run, counting, recording, len(log.samples), list(log.table.columns))
        except WrongClock as error:
            raise error.by_import(content, recording, name, out) from None
        except BadInput as error:
            raise by_look(error, recording, run) or by_option(error, content) from None
    if folder.exists():  # recorded before it was described
        if is_recorded(folder):
            recorded = recording_path(folder)
            check_samples(run, read_recording(run, folder), recorded, sure, FileLines(recorded, run.file))
        write_text(path, write_yaml(content))
        return folder
    with whole_folder(folder, "run", taken) as temporary:
        text = write_yaml(content)
        if recording is not None:
            rows = rows_left(log)
            file = {"file": {**content["file"], "rows": rows}} if rows else {}
            text = copy_log(log, temporary / kept) + write_yaml({**content, **file})
        (temporary / "run.yaml").write_text(text, encoding="utf-8")
    if recording is not None:
        print(reads)  # now that the folder is there, whoever reads it may leave
        warn_of_copies(folder)
    return folder
