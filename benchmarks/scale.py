"""What a lab's growth costs: planning, one run more, and the index, over 10, 100 and 1,000 runs of 20 a string.

    python benchmarks/scale.py [--runs 10 100 1000] [--place FOLDER]

Once, the main job with its small fits is run on one recording of 4 strokes. What it made is then copied into projects
of so many runs, each string a material of its own, and noted by Snakemake's own functions as if it had made them.
Measured, each in a process of its own: `snakemake -n` where nothing is made (at its first start, which reads every
recording, and at the next), where all is made, and with one run more; and the job of `reports/index.html`, with the
bytes that it writes. docs/scale.md shows what came.
"""

import argparse
import json
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import yaml

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "tests")]

from made_recording import content, recording  # noqa: E402

A_STRING = 20  # runs of it
TEMPLATE = ("template-01", "template")  # run and material whose files are linked
NOTED = """
from snakemake import cli
from snakemake.scheduling.job_scheduler import JobScheduler

def note(self):
    for level in self.workflow.dag.toposorted():
        for job in level:
            for file in job.output:
                file.touch()
            self.workflow.async_run(self.workflow.persistence.finished(job))
    return True

JobScheduler.schedule = note
cli.main()
"""
SNAKEMAKE = ("-m", "snakemake", "--cores", "2", "--profile", "env/profile")


def project(folder: Path) -> Path:
    """A project without runs: the code, the rules and the configuration, without the synthetic rig's run."""
    shutil.copytree(ROOT / "pipeline", folder / "pipeline", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(ROOT / "env" / "profile", folder / "env" / "profile")
    shutil.copy(ROOT / "Snakefile", folder)
    for name in ("default", "ci"):
        path = folder / "pipeline" / "config" / f"{name}.yaml"
        config = yaml.safe_load(path.read_text(encoding="utf-8"))
        config["synthetic"] = {}
        path.write_text(yaml.safe_dump(config, sort_keys=False), encoding="utf-8")
    return folder


def add_run(folder: Path, run: str, material: str, seed: int) -> None:
    """Put a recording of four strokes of a string into `raw/`."""
    place = folder / "raw" / run
    place.mkdir(parents=True)
    recording(4, seed=seed).to_parquet(place / "recording.parquet", index=False)
    described = content(run)
    described["string"] |= {"material": material, "id": f"{material}-a"}
    (place / "run.yaml").write_text(yaml.safe_dump(described), encoding="utf-8")


def cost(command: Sequence[str], folder: Path) -> tuple[float, float, str]:
    """CPU seconds, peak memory in MB and the output of a Python command; raises RuntimeError where it fails.

    The CPU's seconds are what the same takes on a machine that does nothing else; other work makes a clock's longer.
    """
    log = folder / "log.txt"
    with log.open("w") as out:
        process = subprocess.Popen([sys.executable, *command], cwd=folder, stdout=out, stderr=out)
        _, status, usage = os.wait4(process.pid, 0)
    said = log.read_text(encoding="utf-8")
    if status:
        raise RuntimeError(f"{' '.join(command)[:300]}: {said[-3000:]}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.0, said


def jobs(said: str) -> dict[str, int]:
    """Jobs by rule of a dry run; none where nothing is to be done."""
    if "Nothing to be done" in said:
        return {}
    table = said.split("job ", 1)[1].split("\n\n", 1)[0].splitlines()[2:]
    return {words[0]: int(words[1]) for words in map(str.split, table) if len(words) == 2}


def copy(source: Path, target: Path) -> None:
    """Copy a file or a folder; pages and figures, whose times nobody asks, are linked."""
    if source.is_dir():
        for path in source.iterdir():
            copy(path, target / path.name)
        return
    target.parent.mkdir(parents=True, exist_ok=True)
    (os.link if source.parent.parent.name == "diagnosis" and source.name[0] != "." else shutil.copy2)(source, target)


def finish(folder: Path, template: Path, seeds: dict[str, dict[str, int]]) -> None:
    """Link what the main job made of the template to the place of every run and material, for every seed."""
    run, material = TEMPLATE
    names = sorted(path.name for path in (folder / "raw").iterdir())
    for name in names:
        copy(template / "processed" / run, folder / "processed" / name)
        copy(template / "reports" / "diagnosis" / run, folder / "reports" / "diagnosis" / name)
    for name in sorted({one.rpartition("-")[0] for one in names}):
        copy(template / "reports" / material, folder / "reports" / name)
        for path in (template / "processed" / material).iterdir():
            if path.name not in seeds:
                copy(path, folder / "processed" / name / path.name)
        for model, splits in seeds.items():
            for split, count in splits.items():
                for seed in range(count):
                    for suffix in ("predictions.parquet", "model"):
                        source = template / "processed" / material / model / f"{split}-0.{suffix}"
                        copy(source, folder / "processed" / name / model / f"{split}-{seed}.{suffix}")
    for one in ("reports/metrics.csv", "reports/metrics.csv-metadata.json", "processed/left_out.json"):
        copy(template / one, folder / one)
    index = template / "reports"
    for path in index.iterdir():
        if path.name == "index.html" or path.name == "pages":
            copy(path, folder / "reports" / path.name)
    (folder / "reports" / "pages").mkdir(exist_ok=True)


def measured(folder: Path, template: Path, count: int) -> dict[str, tuple[float, float]]:
    """Seconds and MB of each step in a project of so many runs; prints what one run more asks for."""
    project(folder)
    for at in range(count):
        string = at // A_STRING
        add_run(folder, f"string-{string:03d}-{at % A_STRING + 1:02d}", f"string-{string:03d}", at)
    time.sleep(3.0)  # a file that has just changed is read again
    found: dict[str, tuple[float, float]] = {}
    for step in ("first plan", "plan"):
        took_s, peak_mb, said = cost([*SNAKEMAKE, "--dry-run", "--quiet", "rules"], folder)
        found[step] = took_s, peak_mb
    config = yaml.safe_load((folder / "pipeline/config/default.yaml").read_text(encoding="utf-8"))
    print(f"{count} runs: {sum(jobs(said).values()) // 2} jobs to do", flush=True)
    finish(folder, template, {model: one["seeds"] for model, one in config["models"].items()})
    cost(["-c", NOTED, *SNAKEMAKE[2:], "--touch", "--forceall", "--quiet", "all"], folder)
    time.sleep(3.0)
    cost([*SNAKEMAKE, "--dry-run", "--quiet", "rules"], folder)
    took_s, peak_mb, said = cost([*SNAKEMAKE, "--dry-run", "--quiet", "rules"], folder)
    if jobs(said):
        raise RuntimeError(f"a finished project has jobs to do: {jobs(said)}")
    found["plan, all made"] = took_s, peak_mb
    add_run(folder, "another-01", "another", count)
    took_s, peak_mb, said = cost([*SNAKEMAKE, "--dry-run", "--quiet", "rules"], folder)
    found["plan, one more"] = took_s, peak_mb
    print(f"{count} runs and one of another string: {json.dumps(jobs(said))}", flush=True)
    shutil.rmtree(folder / "raw" / "another-01")
    (folder / "reports" / "index.html").unlink()
    took_s, peak_mb, said = cost([*SNAKEMAKE, "--dry-run", "--printshellcmds", "reports/index.html"], folder)
    command = next(line for line in said.splitlines() if "pipeline.report.index" in line)
    took = cost(shlex.split(command.partition("exec python ")[2].partition(" > ")[0]), folder)
    found["index"] = took[:2]
    pages = [path for path in (folder / "reports" / "pages").iterdir() if path.is_file()]
    largest = max((path.stat().st_size for path in pages), default=0)
    print(
        f"{count} runs: index.html {(folder / 'reports/index.html').stat().st_size / 1e6:.2f} MB, {len(pages)} pages of"
        f" {sum(path.stat().st_size for path in pages) / 1e6:.2f} MB, the largest {largest / 1e6:.3f} MB", flush=True
    )  # fmt: skip
    return found


def main() -> None:
    """Measure each size, and print a table with the exponents."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--runs", type=int, nargs="+", default=[10, 100, 1000])
    parser.add_argument("--place", type=Path, help="an empty folder to work in; a temporary one otherwise")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=asked.place) as name:
        template = project(Path(name) / "template")
        add_run(template, *TEMPLATE, 0)
        cost([*SNAKEMAKE, "--configfile", "pipeline/config/ci.yaml"], template)
        found = [measured(Path(name) / str(count), template, count) for count in asked.runs]
    print("| step | " + " | ".join(f"{count} runs" for count in asked.runs) + " | exponent: seconds, MB |")
    print("|---|" + "---|" * (len(asked.runs) + 1))
    for step in found[0]:
        cells = [f"{one[step][0]:.1f} s, {one[step][1]:.0f} MB" for one in found]
        slopes = [np.polyfit(np.log(asked.runs), np.log([one[step][of] for one in found]), 1)[0] for of in (0, 1)]
        print(f"| {step} | {' | '.join(cells)} | {slopes[0]:.2f}, {slopes[1]:.2f} |")


if __name__ == "__main__":
    main()
