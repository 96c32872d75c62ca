"""Ask the baselines about those recordings of a folder that there are: some cases cannot be made."""

import argparse
import os
import subprocess
import sys
from pathlib import Path

from ..ground.errors import program


@program
def main() -> None:
    """Write OUT/<run>/baselines.json for every run; raises CalledProcessError when a baseline fails."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.proof.ask_baselines", description=__doc__)
    parser.add_argument("names", nargs="+", metavar="run")
    parser.add_argument("--runs", type=Path, required=True, help="folder of run folders")
    parser.add_argument("--out", type=Path, required=True, help="the folder of what is found; required")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    runs = [str(arguments.runs / name) for name in arguments.names if (arguments.runs / name).is_dir()]
    if runs:
        command = [sys.executable, "-m", "pipeline.proof.baselines", *runs, "--out", str(arguments.out)]
        subprocess.run(command, check=True, env={**os.environ, "TWISTBENCH_PARENT": str(os.getpid())})


if __name__ == "__main__":
    main()
