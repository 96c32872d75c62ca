"""Run folders of one rig → their diagnosis, alone or together; a refusal is noted where the words would be."""

import argparse
from pathlib import Path

from ..ground.errors import BadInput, program
from ..ground.stored.files import write_text
from ..notebook.of_folders import Options, diagnose
from ..string.from_raw import read
from ..string.jumps_beside import Beside, Reader
from .bring import REFUSED, usable


def ask(folders: list[Path], out: Path, reader: Reader = read, beside: Beside | None = None) -> str:
    """Diagnose runs into `out`, together when they are several, and return the words, or why there is no verdict.

    Of several, those that could not be imported are left out. `reader` and `beside` are as `diagnose` takes them.
    """
    together = len(folders) > 1
    good = [folder for folder in folders if usable(folder)]
    try:
        if len(good) > together:
            return diagnose(good, out, Options(together, reader=reader), beside)
        if not together:
            words = (folders[0] / REFUSED).read_text(encoding="utf-8").strip()
        else:
            words = f"{out.name}: not decided: of {len(folders)} recordings {len(good)} could be imported"
    except BadInput as error:
        words = f"{out.name}: not decided: {error}"
    write_text(out / "verdict.txt", words + "\n")
    return words


@program
def main() -> None:
    """Write the verdict on one run, or on several together."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.real.verdicts", description=__doc__)
    parser.add_argument("run_dir", type=Path, nargs="+")
    parser.add_argument("--out", type=Path, required=True, help="the folder of the diagnosis; required")
    arguments = parser.parse_args()
    print(ask(arguments.run_dir, arguments.out))


if __name__ == "__main__":
    main()
