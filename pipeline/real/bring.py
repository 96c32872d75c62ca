"""One downloaded file → a run folder, or a folder that says why the file was refused."""

import argparse
from pathlib import Path

from ..foreign.imported import import_run
from ..ground.errors import BadInput, program
from ..ground.stored.files import write_text

REFUSED = "refused.txt"


def usable(folder: Path) -> bool:
    """Whether a folder holds an imported run."""
    return (folder / "run.yaml").is_file()


def bring(file: Path, mapping: Path, folder: Path) -> str:
    """Import a file as the run folder `folder`; returns a sentence on it, or the refusal that was noted there."""
    try:
        return import_run(file, mapping, folder.name, folder.parent)
    except BadInput as error:
        write_text(folder / REFUSED, f"{file.name}: not imported: {error}\n")
        return f"refused: {error}"


@program
def main() -> None:
    """Make one folder; a file that cannot be imported is no error here: the report says why."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.real.bring", description=__doc__)
    parser.add_argument("file", type=Path)
    parser.add_argument("--map", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True, help="the folder of the run, a new one; required")
    arguments = parser.parse_args()
    print(bring(arguments.file, arguments.map, arguments.out))


if __name__ == "__main__":
    main()
