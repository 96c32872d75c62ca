"""Record a synthetic rig: run.yaml for its set-up, then the rig and the capture program, as with a real one."""

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import yaml

from ..ground.command import HOUSE, command
from ..ground.errors import BadInput, program
from ..ground.stored.files import write_text
from .setup import SetUp, described, names, read_setup

PATIENCE_S = 30.0  # for the rig to be there, and to be gone


def describe(setup: SetUp, folder: Path) -> None:
    """Write run.yaml of a set-up; raises BadInput when another one stands there."""
    path = folder / "run.yaml"
    described(setup, path.resolve())
    text = yaml.safe_dump({"run": folder.resolve().name, **setup.run}, sort_keys=False)
    if path.exists() and path.read_text(encoding="utf-8") != text:
        raise BadInput(path, "run.yaml", "is not the set-up's", "choose a run folder of its own")
    write_text(path, text)


def record(which: str, folder: Path, seed: int) -> int:
    """Run the rig and the capture program against each other; the exit status of the one that failed, or 0."""
    environment = {**os.environ, "TWISTBENCH_PARENT": str(os.getpid())}
    roots = [str(Path(__file__).parents[2]), environment.get("PYTHONPATH", "")]
    environment["PYTHONPATH"] = os.pathsep.join(filter(None, roots))
    with tempfile.TemporaryDirectory(prefix="rig-") as place:
        link = Path(place) / "port"
        start = [sys.executable, "-m", __package__, which, "--link", str(link), "--seed", str(seed)]
        start += ["--pace", "inf", "--recordings", "1"]
        # a session of its own: Ctrl-C is for the capture program, which then stops the rig in good order
        rig = subprocess.Popen(start, env=environment, start_new_session=True, stdout=subprocess.DEVNULL)
        try:
            deadline_s = time.monotonic() + PATIENCE_S
            while not link.is_symlink():
                ended = rig.poll()
                if ended is not None or time.monotonic() > deadline_s:
                    print(f"error: {which}: {_absent(ended)}", file=sys.stderr)
                    return ended or 1
                time.sleep(0.01)
            capture = [sys.executable, "-m", f"{HOUSE}.capture", str(link), str(folder)]
            status = subprocess.run(capture, env=environment, check=False).returncode
            return status or rig.wait(PATIENCE_S)
        finally:
            rig.terminate()
            rig.wait()


def _absent(ended: int | None) -> str:
    """The message on a rig that was not there, from the exit status of its program; with the mend."""
    if ended is not None:
        return f"the rig ended with status {ended} before it was there; run it alone to see why: {command('rig')}"
    return f"the rig was not there within {PATIENCE_S:g} s; run the command again when the machine is less busy"


@program
def main() -> int:
    """Write RUN_DIR with run.yaml, recording.frames and capture.json."""
    parser = argparse.ArgumentParser(prog=command("rig.record"), description=__doc__)
    parser.add_argument("setup", metavar="SETUP", help=f"a YAML file, or one of {', '.join(names())}")
    parser.add_argument("run_dir", metavar="RUN_DIR", type=Path)
    parser.add_argument("--seed", type=int, default=0)
    arguments = parser.parse_args()
    describe(read_setup(arguments.setup), arguments.run_dir)
    return record(arguments.setup, arguments.run_dir, arguments.seed)


if __name__ == "__main__":
    main()
