"""What a long recording costs: memory and seconds of each stage, beside pandas alone that reads the same file.

    python benchmarks/long_recordings.py [--minutes 120] [--stages ingest strokes ...]

makes a recording at 1 kHz (a twisted pair that creeps, a stroke a minute), takes it through each stage in a process of
its own, and prints what each needed at most. What was measured stands in docs/scale.md.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import yaml

ROOT = Path(__file__).parents[1]
RATE_HZ, STROKE_S = 1000.0, 60.0
PIECE = 1 << 20  # samples
STRING = {"material": "Z", "radius_mm": 0.4, "length_mm": 300.0, "stiffness_n_per_mm": 50.0}


def record(folder: Path, minutes: float) -> None:
    """A run folder with a recording of so many minutes, which is written piece by piece."""
    folder.mkdir(parents=True)
    schema = pa.schema([(name, pa.float64()) for name in ("time_s", "motor_turns", "displacement_mm", "load_n")])
    generator, samples = np.random.default_rng(1), round(60.0 * minutes * RATE_HZ)
    with pq.ParquetWriter(folder / "recording.parquet", schema) as to_file:
        for first in range(0, samples, PIECE):
            time_s = np.arange(first, min(first + PIECE, samples)) / RATE_HZ
            turns = 25.0 * np.interp(
                time_s / STROKE_S % 1.0, [0.0, 0.05, 0.45, 0.55, 0.95, 1.0], [0.0, 0.0, 1.0, 1.0, 0.0, 0.0]
            )
            noise = generator.normal(0.0, 1.0, (2, len(time_s)))
            contraction_mm = 300.0 - np.sqrt(300.0**2 - (2.0 * np.pi * turns * 0.4) ** 2)
            creep_mm = 0.8 * (1.0 - np.exp(-time_s / 120.0))
            columns = [time_s, turns, contraction_mm - creep_mm + 0.02 * noise[0], 20.0 + 0.05 * noise[1]]
            to_file.write_table(pa.Table.from_arrays([pa.array(one) for one in columns], schema=schema))
    content = {"run": folder.name, "actuator": "twisted_pair", "string": STRING, "rig": {}}
    (folder / "run.yaml").write_text(yaml.safe_dump(content))


def cost(command: list[str], log: Path) -> tuple[float, float]:
    """Peak memory in MB and seconds of a command; raises RuntimeError where it fails."""
    began = time.monotonic()
    with log.open("w") as out:
        process = subprocess.Popen(command, cwd=ROOT, stdout=out, stderr=out)
        _, status, usage = os.wait4(process.pid, 0)
    if status:
        raise RuntimeError(f"{' '.join(command)}: {log.read_text()[-2000:]}")
    return usage.ru_maxrss / 1024.0, time.monotonic() - began


def main() -> None:
    """Make the recording, and print what each stage needs."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--minutes", type=float, default=120.0)
    parser.add_argument("--stages", nargs="+", help="only these; default: all")
    arguments = parser.parse_args()
    minutes = arguments.minutes
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        run, stored = folder / "raw" / "long-01", folder / "processed"
        record(run, minutes)
        (stored / run.name).mkdir(parents=True)
        samples, strokes = (str(stored / run.name / f"{what}.parquet") for what in ("samples", "strokes"))
        reading = f"import pandas; pandas.read_parquet({str(run / 'recording.parquet')!r})"
        verdict = str(folder / "out" / run.name / "diagnosis.json")
        commands = {
            "pandas reads it": ["-c", reading],
            "ingest": ["-m", "pipeline.stages.ingest", str(run), "--out", samples],
            "strokes": ["-m", "pipeline.stages.strokes", samples, "--out", strokes],
            "dataset": ["-m", "pipeline.stages.dataset", str(run), "--processed", str(stored), "--out",
                        str(folder / "dataset.parquet")],
            "lifespan": ["-m", "pipeline.lifespan", str(run), "--out", str(folder / "lifespan")],
            "diagnose": ["-m", "pipeline.diagnose", str(run), "--out", str(folder / "out")],
            "simulate": ["-m", "pipeline.simulate", str(run), "--simulation", verdict, "--out",
                         str(folder / "simulated.parquet")],
        }  # fmt: skip
        print("| stage | peak memory (MB) | times pandas' | seconds | times pandas' |\n|---|---|---|---|---|")
        alone = (float("nan"), float("nan"))  # where pandas is not among the stages
        for stage, command in commands.items():
            if arguments.stages and stage not in arguments.stages:
                continue
            found = cost([sys.executable, *command], folder / "log")
            alone = found if stage == "pandas reads it" else alone
            ratios = [one / other for one, other in zip(found, alone, strict=True)]
            print(f"| {stage} | {found[0]:.0f} | {ratios[0]:.1f} | {found[1]:.1f} | {ratios[1]:.1f} |", flush=True)


if __name__ == "__main__":
    main()
