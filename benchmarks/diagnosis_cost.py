"""What a diagnosis costs beside an earlier commit's: CPU seconds, peak memory, and whether the verdict is the same.

    python benchmarks/diagnosis_cost.py COMMIT raw/synthetic-01 [RUN ...]

checks the commit out beside this one, diagnoses each run by both in turn, each in a process of its own after one run
that compiles, and prints a line a run. Seconds are the processor's, import and figures included: other work beside it
changes them less than it changes the clock's.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]


def cost(code: Path, run: Path, out: Path) -> tuple[float, float, dict[str, Any]]:
    """CPU seconds, peak memory in MB and the verdict of a diagnosis by the code in a folder."""
    command = [sys.executable, "-m", "pipeline.diagnose", str(run), "--out", str(out)]
    process = subprocess.Popen(command, cwd=code, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        raise RuntimeError(f"{' '.join(command)} failed in {code}")
    content = json.loads((out / run.name / "diagnosis.json").read_text())
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.0, content


def said(content: dict[str, Any]) -> Any:
    """Verdict, sets and probabilities, to the percent that a person reads."""
    explanations = content["evidence"]["explanations"]
    likely = [(one["ids"], round(100.0 * (one["probability"] or 0.0))) for one in explanations]
    named = [(one["id"], round(100.0 * one["confidence"])) for one in content["mechanisms"]]
    return content["verdict"], named, content["alternatives"], likely


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("commit")
    parser.add_argument("runs", type=Path, nargs="+")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        before, out = Path(name) / "before", Path(name) / "out"
        subprocess.run(["git", "worktree", "add", "--detach", str(before), given.commit], cwd=ROOT, check=True)
        try:
            for code in (before, ROOT):
                cost(code, given.runs[0].resolve(), out)
            print("| run | CPU s before | now | ratio | MB before | now | the same verdict |")
            print("|---|---|---|---|---|---|---|")
            for run in given.runs:
                old, new = (cost(code, run.resolve(), out) for code in (before, ROOT))
                times = f"{old[0]:.1f} | {new[0]:.1f} | {new[0] / old[0]:.2f} | {old[1]:.0f} | {new[1]:.0f}"
                print(f"| {run.name} | {times} | {'yes' if said(old[2]) == said(new[2]) else 'NO'} |", flush=True)
        finally:
            subprocess.run(["git", "worktree", "remove", "--force", str(before)], cwd=ROOT, check=True)


if __name__ == "__main__":
    main()
