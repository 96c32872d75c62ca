"""Ask the diagnosis about the recordings of a folder, as a stranger would: by its command line, one process for all."""

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TypedDict

from ..ground.errors import program
from ..ground.stored.files import write_text
from ..run.folder import find_runs

JUDGES = Path(__file__).parent / "teach" / "judges"
REFUSED = 2  # exit status of the diagnosis when some run cannot be decided; the others are written


class Asked(TypedDict):
    """How asking went, as asked.json holds it: CPU time in s of each diagnosis, by run, and the exit status."""

    seconds: dict[str, float]
    status: int


def ask(runs: list[Path], out: Path, without: str = "", together: bool = False, judge: Path | None = None) -> Asked:
    """Diagnose runs into `out`; returns how it went. Raises RuntimeError when the diagnosis fails.

    What is asked together and refused has no seconds.
    """
    command = [sys.executable, "-m", "pipeline.diagnose", *map(str, runs), "--out", str(out)]
    command += ["--without", without] if without else []
    command += ["--together"] if together else []
    command += ["--judge", str(judge)] if judge else []
    with TemporaryDirectory() as place:
        seconds = Path(place) / "seconds.json"
        # it must end when this process does, not when Snakemake does
        environment = {**os.environ, "TWISTBENCH_PARENT": str(os.getpid())}
        done = subprocess.run([*command, "--cpu-seconds", str(seconds)], env=environment)
        if done.returncode not in (0, REFUSED):
            raise RuntimeError(f"the diagnosis ended with status {done.returncode}: {' '.join(command)}")
        taken_s = json.loads(seconds.read_text(encoding="utf-8")) if seconds.is_file() else {}
        return {"seconds": taken_s, "status": done.returncode}


@program
def main() -> None:
    """Write OUT/<run>/diagnosis.json for every run of a folder, and OUT/asked.json."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.proof.verdicts", description=__doc__)
    parser.add_argument("runs", type=Path, help="folder of run folders")
    parser.add_argument("--out", type=Path, required=True, help="the folder of what is asked; required")
    parser.add_argument("--without", default="", metavar="ID", help="the mechanism that the library loses")
    parser.add_argument("--untaught-by", default="", metavar="AUTHOR", help="whom the judge must not know; none: any")
    arguments = parser.parse_args()
    runs = list(find_runs(arguments.runs))
    judge = JUDGES / f"without_{arguments.untaught_by}.json" if arguments.untaught_by else None
    question: Asked = ask(runs, arguments.out, arguments.without, judge=judge) if runs else {"seconds": {}, "status": 0}
    write_text(arguments.out / "asked.json", json.dumps(question) + "\n")


if __name__ == "__main__":
    main()
