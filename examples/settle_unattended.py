"""A rig settles its own tie, unattended: from nothing to a right and firm verdict, with the page open.

A synthetic rig stands at a pseudo-terminal and conceals friction. Its first recording is poor: equal strokes under one
load, which friction and backlash explain alike. `settle` makes it, says that they tie, makes the run that parts them,
and ends. `watch` shows all of it on a page. Run as

    python3 env/run.py python examples/settle_unattended.py [FOLDER]

It takes two minutes, three or more on a busy machine. All that it makes lies in FOLDER (default: a new one in the
temporary folder), and it says where. The page is there until it ends.
"""

import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parents[1]
CONCEALED = {"friction_hysteresis": {"turns_per_n": 0.01, "reach_turns": 0.2}}
SIZES = ["--radius-mm", "0.4", "--length-mm", "400", "--stiffness-n-per-mm", "15", "--torsion-zone-mm", "150"]
STRING = [*SIZES, "--separator-mm", "8", "--material", "example", "--string-id", "spool-1"]
LIMITS = "{turns: [0, 20], turns_per_s: 8, load_n: [10, 40], seconds: 300}"


def begin(place: Path, module: str, *words: object, log: Path | None = None) -> subprocess.Popen:
    """A program of ours in the folder; with a `log` what it says goes there."""
    path = os.pathsep.join([str(ROOT), *filter(None, [os.environ.get("PYTHONPATH")])])
    environment = {**os.environ, "PYTHONPATH": path}
    command = [sys.executable, "-m", f"pipeline.{module}", *map(str, words)]
    says = None if log is None else log.open("w")
    return subprocess.Popen(command, cwd=place, env=environment, stdout=says)


def main() -> int:
    """Begin rig and page, let the loop run to its end, and say whether it named what is concealed."""
    place = (Path(sys.argv[1]) if len(sys.argv) > 1 else Path(tempfile.mkdtemp(prefix="settle-"))).resolve()
    place.mkdir(parents=True, exist_ok=True)
    run, out, port = place / "raw" / "poor-1", place / "reports" / "settle" / "poor-1", place / "port"
    print(f"first recording: {run}\nsteps and verdicts: {out}\nwhat the rig says: {place / 'rig.log'}")
    print("The page, at the address below, stays until this program ends.", flush=True)
    setup = yaml.safe_load((ROOT / "pipeline" / "rig" / "setups" / "small.yaml").read_text())
    (place / "rig.yaml").write_text(yaml.safe_dump(setup | {"effects": CONCEALED}))
    rig = begin(place, "rig", "rig.yaml", "--standing", "--link", port, log=place / "rig.log")
    beside = [rig]
    try:
        while not port.is_symlink():
            if rig.poll() is not None:
                return rig.returncode
            time.sleep(0.1)
        # what new_run says comes next this program does itself: it goes to a log
        if begin(place, "new_run", "poor-1", *STRING, "--out", run.parent, log=place / "new_run.log").wait() != 0:
            return 2
        beside.append(begin(place, "watch", run, "--port", "0", "--settle", out))
        words = [run, "--port", port, "--approve", "auto", "--limits", LIMITS, "--out", out]
        status = begin(place, "settle", *words).wait()
    finally:
        for one in beside:
            one.send_signal(signal.SIGTERM)
            one.wait()
    if status != 0:
        return status
    found = json.loads((out / "settled.json").read_text())
    right = found["verdict"] == "explained" and found["mechanisms"] == [*CONCEALED]
    print(
        f"concealed: {', '.join(CONCEALED)}; {'settled rightly' if right else 'not settled rightly'}; the page is gone"
    )
    print(f"runs: {', '.join(found['runs'])}\nsteps and verdicts: {out}")
    return 0 if right else 1


if __name__ == "__main__":
    sys.exit(main())
