"""What one thread of linear algebra is worth: a command as documented beside the same with a thread a core.

    python benchmarks/threads.py [--diagnose]

records nothing: it makes a dataset, or a recording, as the tests do, and prints seconds (wall, CPU) and their ratio.
"""

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "tests"), str(ROOT / "tests" / "models")]

from pipeline import ONE_THREAD  # noqa: E402

# What `python -m` does, with the variables set back between `import pipeline` and the first import of numpy.
MANY = """
import os, runpy, sys
import pipeline
for name in pipeline.ONE_THREAD:
    os.environ.pop(name)
sys.argv = sys.argv[1:]
runpy.run_module(sys.argv[0], run_name="__main__", alter_sys=True)
"""


def seconds(command: list[str]) -> tuple[float, float]:
    """Wall and CPU seconds of a command."""
    environment = {name: value for name, value in os.environ.items() if name not in ONE_THREAD}
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run(command, cwd=ROOT, env=environment, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    wall, after = time.monotonic() - began, resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def predicting(folder: Path) -> list[str]:
    """`predict` by the spline on 5,000 points."""
    from made_dataset import made_dataset

    from pipeline.ground.stored import schemas

    schemas.write(made_dataset(), schemas.DATASET, folder / "dataset.parquet")
    (folder / "questions.csv").write_text("stroke,direction,motor_turns\n3,1,12\n")
    return ["pipeline.predict", f"{folder}/dataset.parquet", f"{folder}/questions.csv", "--out", f"{folder}/out.csv"]


def diagnosing(folder: Path) -> list[str]:
    """`diagnose` of nine strokes at 25 Hz."""
    import yaml
    from made_recording import content, recording

    run = folder / "made-01"
    run.mkdir()
    (run / "run.yaml").write_text(yaml.safe_dump(content("made-01")))
    recording(9).to_parquet(run / "recording.parquet", index=False)
    return ["pipeline.diagnose", str(run), "--out", str(folder / "out")]


def main() -> None:
    """Measure."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--diagnose", action="store_true", help="diagnose instead of predict")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        words = (diagnosing if asked.diagnose else predicting)(Path(folder))
        one = seconds([sys.executable, "-m", *words])
        many = seconds([sys.executable, "-c", MANY, *words])
    print(f"{words[0]}: {one[0]:.1f} s ({one[1]:.1f} CPU); with a thread a core {many[0]:.1f} s ({many[1]:.1f} CPU)")
    print(f"ratio {many[0] / one[0]:.1f} (CPU {many[1] / one[1]:.1f})")


if __name__ == "__main__":
    main()
