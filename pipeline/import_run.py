"""A foreign recording → a run folder, through a mapping that says which column is what.

A mapping is a `run.yaml` without `run`: the string, the rig, how the file is written and where its channels stand.
"""

import shlex
import sys
from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pandas as pd

from .foreign.axes import each_axis
from .foreign.drafted import guess
from .foreign.empty_fields import refuse_empty
from .foreign.folder_files import OPTION, files_in
from .foreign.mended_clock import check_mended, mend_time
from .foreign.origin import origin
from .formats import read_foreign
from .ground import schemas
from .ground.command import HOUSE, command
from .ground.counts import counted, mends
from .ground.errors import BadInput, program
from .ground.folders import whole_folder
from .ground.names import checked, own_material, run_name
from .ground.parser import Parser
from .ground.strict_yaml import read_yaml, write_yaml
from .run.columns_read import read_as
from .run.description import parse_run
from .run.folder import read_run
from .run.named_units import in_its_unit
from .run.next_command import following
from .run.plausible_dimensions import dimension_questions
from .run.read_log import read_log
from .run.recorded_table import asked_columns
from .run.samples import check, check_finite, questions
from .run.tolerances_given import read_back
from .string.known_strings import imported_as_another
from .string.same_string import others_recorded
from .systems import systems

TAKEN = "choose another --run; runs are never overwritten"


def read_mapping(path: Path) -> dict[str, Any]:
    """Content of a mapping; raises BadInput when it is not there, not YAML, or names a run."""
    content = read_yaml(path)
    if not isinstance(content, dict) or {"run", "mended"} & content.keys():
        raise BadInput(path, "mapping", "is not a mapping", "write it as a run.yaml, without run and mended")
    refuse_empty(content, path)
    return content


def write_run(content: dict[str, Any], samples: pd.DataFrame, folder: Path, came_from: str) -> None:
    """Make a run folder, whole or not at all; raises BadInput when it is there already."""
    with whole_folder(folder, "run", TAKEN) as temporary:
        schemas.write(samples, schemas.samples(list(samples.columns)), temporary / "recording.parquet")
        (temporary / "run.yaml").write_text(came_from + write_yaml(content), encoding="utf-8")


@dataclass(frozen=True)
class _Run:
    """A run that is ready to be written, and a sentence on it."""

    content: dict[str, Any]
    samples: pd.DataFrame
    folder: Path
    said: str


def _checked(file: Path, mapping: Path, own: dict[str, Any], name: str, out: Path) -> _Run:
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
    sentence = "\n".join(filter(None, (sentence, read_as(run, checked_samples, file, len(samples)), read_back(run))))
    return _Run({**kept, **({"mended": mended} if mended else {})}, samples, folder, sentence)


def import_run(file: Path, mapping: Path, name: str, out: Path, string_id: str | None = None) -> str:
    """Import one file as run `name` under `out`, or one run an axis; a sentence on each that was made.

    `string_id` goes before the mapping's. Raises BadInput, before anything is written.
    """
    return "\n".join(run.said for run in _imported(file, mapping, name, out, string_id))


def _imported(file: Path, mapping: Path, name: str, out: Path, string_id: str | None) -> list[_Run]:
    """The runs that `import_run` makes."""
    axes = each_axis(read_mapping(mapping), mapping, string_id)
    names = {axis: f"{name}-{axis}" if axis else name for axis in axes}
    runs = [_checked(file, mapping, own, names[axis], out) for axis, own in axes.items()]
    for run in runs:
        if run.folder.exists():
            raise BadInput(run.folder, "run", "is there already", TAKEN)
    for run in runs:
        write_run(run.content, run.samples, run.folder, origin(file, mapping))
    return runs


def say_another(folder: Path, axes: Collection[str] = ()) -> None:
    """Say of the last imported run where it counts as another string than one like it; `axes` are its file's runs."""
    if note := imported_as_another(read_run(folder), folder.parent, axes):
        print(note, file=sys.stderr)


def import_folder(
    folder: Path, mapping: Path, name: str, out: Path, pattern: str | None = None, string_id: str | None = None
) -> int:
    """Import each recording below a folder by one mapping, as run `name`-<its name>; say what became of each file.

    A file that is refused costs itself alone: it is named, and the answer is 2, else 0. Raises BadInput where the
    mapping is wrong, or where there is nothing to import.
    """
    files = files_in(folder, checked(run_name, name, "--run", "run"), pattern)
    made, refused, last = 0, 0, out
    for run, file in files.file_by_run.items():
        try:
            print(import_run(file, mapping, run, out, string_id))
            made, last = made + 1, out / run
        except BadInput as error:
            if error.file == str(mapping):  # no file can be read through it
                raise
            print(f"error: {error}", file=sys.stderr)
            refused += 1
    if files.passed_over:
        print(files.sentence)
    print(f"{made} of {counted(made + refused, 'file')} imported" + (", the others refused (above)" if refused else ""))
    if made:
        say_another(last)
        runs = shlex.quote(str(out / name))
        print(f"diagnose each by {command('diagnose')} {runs}-* --out reports/mine; runs of one rig in one: --together")
    return 2 if refused else 0


@program
def main() -> int:
    """Import one file, or all of a folder, or draft a mapping for one."""
    parser = Parser(prog=command("import_run"), description=__doc__)
    whole = "the recording, or a folder: each recording below it becomes a run NAME-<name of the file>"
    parser.add_argument("file", type=Path, metavar="FILE", help=whole)
    mapping = f"what is where in the file (docs/import.md), such as {HOUSE}/mappings/tsa_haptic_1.yaml"
    parser.add_argument("--map", type=Path, help=mapping)
    parser.add_argument("--run", help="name of the new run: lower-case letters, digits and -")
    which = "of a folder, which files are recordings, such as '*.TXT'; default: by their endings"
    parser.add_argument(OPTION, metavar="PATTERN", help=which)
    own = "name of this very string, in place of string.id of the mapping: runs that share it continue each other"
    parser.add_argument("--string-id", metavar="ID", help=own)
    parser.add_argument("--guess", action="store_true", help="draft a mapping for the file, and show its first rows")
    kinds = ", ".join(systems())
    parser.add_argument("--actuator", help=f"with --guess, the kind of rig: {kinds}; default: separator, to be checked")
    parser.add_argument(
        "--out",
        type=Path,
        help="folder of the run's folder, with --guess file of the mapping; default: raw, the screen",
    )
    arguments = parser.parse_args()
    if arguments.guess:
        guess(arguments.file, arguments.actuator, arguments.out)
        return 0
    if arguments.map is None or arguments.run is None:
        parser.error("--map and --run are needed; without a mapping yet, draft one with --guess")
    raw = arguments.out or Path("raw")
    if arguments.files is not None and not arguments.file.is_dir():
        parser.error(f"{OPTION} goes with a folder")
    if arguments.file.is_dir():
        return import_folder(arguments.file, arguments.map, arguments.run, raw, arguments.files, arguments.string_id)
    runs = _imported(arguments.file, arguments.map, arguments.run, raw, arguments.string_id)
    print("\n".join(run.said for run in runs))
    folder = runs[0].folder
    say_another(folder, [run.folder.name for run in runs])
    print("\n".join(following(folder, recorded=True, others=others_recorded(folder, read_run(folder)))))
    return 0


if __name__ == "__main__":
    main()
