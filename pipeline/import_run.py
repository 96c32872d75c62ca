"""A foreign recording → a run folder, through a mapping that says which column is what.

A mapping is a `run.yaml` without `run`: the string, the rig, how the file is written and where its channels stand.
"""

import shlex
import sys
from collections.abc import Collection
from pathlib import Path

from .foreign.drafted import guess
from .foreign.folder_files import OPTION, files_in
from .foreign.imported import ImportedRun, imported
from .foreign.same_recording import warn_of_copies
from .ground.command import HOUSE, command
from .ground.errors import BadInput, program
from .ground.input.outputs import folder_to_write
from .ground.input.parser import Parser
from .ground.names import checked, run_name
from .ground.words.counts import counted
from .run.folder import read_run
from .run.next_command import following
from .string.known_strings import imported_as_another
from .string.same_string import others_recorded
from .systems import systems


def say_another(folder: Path, axes: Collection[str] = ()) -> None:
    """Say of the last imported run where it counts as another string than one like it; `axes` are its file's runs."""
    if note := imported_as_another(read_run(folder), folder.parent, axes):
        print(note, file=sys.stderr)


def say_imported(runs: list[ImportedRun]) -> None:
    """Print what was imported from one file, and warn of runs beside it that hold the same recording."""
    print("\n".join(run.said for run in runs))
    for run in runs:
        warn_of_copies(run.folder)


def import_folder(
    folder: Path, mapping: Path, name: str, out: Path, pattern: str | None = None, string_id: str | None = None
) -> int:
    """Import each recording below a folder by one mapping, as run `name`-<its name>; say what became of each file.

    A file that is refused costs itself alone: it is named, and the answer is 2, else 0. Raises BadInput where the
    mapping is wrong, or where there is nothing to import.
    """
    files = files_in(folder, checked(run_name, name, "--run", "run"), pattern)
    count_imported, refused, last = 0, 0, out
    for run, file in files.file_by_run.items():
        try:
            say_imported(imported(file, mapping, run, out, string_id))
            count_imported, last = count_imported + 1, out / run
        except BadInput as error:
            if error.file == str(mapping):  # no file can be read through it
                raise
            print(f"error: {error}", file=sys.stderr)
            refused += 1
    if files.passed_over:
        print(files.sentence)
    print(
        f"{count_imported} of {counted(count_imported + refused, 'file')} imported"
        + (", the others refused (above)" if refused else "")
    )
    if count_imported:
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
    raw = folder_to_write(arguments.out or Path("raw"))
    if arguments.files is not None and not arguments.file.is_dir():
        parser.error(f"{OPTION} goes with a folder")
    if arguments.file.is_dir():
        return import_folder(arguments.file, arguments.map, arguments.run, raw, arguments.files, arguments.string_id)
    runs = imported(arguments.file, arguments.map, arguments.run, raw, arguments.string_id)
    say_imported(runs)
    folder = runs[0].folder
    say_another(folder, [run.folder.name for run in runs])
    print("\n".join(following(folder, recorded=True, others=others_recorded(folder, read_run(folder)))))
    return 0


if __name__ == "__main__":
    main()
