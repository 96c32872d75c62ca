"""Which files a material is: what Snakemake says that it made of it, all of it up to date, and its recordings."""

import os
import subprocess
import sys
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

import yaml

from ..ground.errors import BadInput
from ..ground.stored.regular_file import read_regular
from ..workflow.dag import make_plan, recorded_files
from .manifest import PROVENANCE, allowed
from .provenance import note_of

LARGEST_CONFIGURATION = 10_000_000  # bytes
MADE = "no update"  # Snakemake's word for a file that is as it should be
SNAKEMAKE = (sys.executable, "-m", "snakemake", "--summary", "--cores", "1")


def synthetic_runs(configuration: Sequence[str]) -> list[str]:
    """Runs that the pipeline records itself, by the default configuration and those laid over it."""
    runs: dict[str, None] = {}
    for path in ("pipeline/config/default.yaml", *configuration):
        try:
            content = yaml.safe_load(read_regular(Path(path), LARGEST_CONFIGURATION)) or {}
            runs |= dict.fromkeys(content.get("synthetic", {}))
        except (OSError, ValueError, AttributeError, yaml.YAMLError):
            raise BadInput(path, "configuration", "cannot be read", "start in the project's folder") from None
    return list(runs)


def summary(configuration: Sequence[str]) -> list[list[str]]:
    """Of every file of the main job: name, date, rule, logs, state and plan, as Snakemake says; raises BadInput."""
    words = [*SNAKEMAKE, *(["--configfile", *configuration] if configuration else [])]
    done = subprocess.run(words, capture_output=True, text=True, errors="replace", env={**os.environ, "COLUMNS": "500"})
    if done.returncode:
        why = (done.stderr.strip().splitlines() or ["it failed"])[-1]
        raise BadInput("snakemake", "--summary", why, "run snakemake, and mend what it says")
    return [line.split("\t") for line in done.stdout.splitlines()[1:] if line.count("\t") >= 5]


def _belongs(name: str, materials: set[str], runs: set[str]) -> bool:
    """Whether a file that the main job makes is of one of the materials, or of one of their runs."""
    place, own, *more = [*name.split("/"), "", ""]
    if place == "reports":
        return own in materials or (own == "diagnosis" and more[0] in runs)
    return own in materials | runs if place == "processed" else place == "raw" and own in runs


def below(path: str) -> Iterator[str]:
    """A file's name, or those of all files of a folder."""
    if not os.path.isdir(path):
        yield path
    for folder, _, names in os.walk(path):
        yield from (f"{folder}/{name}" for name in names)


def contents(
    wanted: Iterable[str], every: bool, configuration: Sequence[str]
) -> tuple[dict[str, list[str]], dict[str, str]]:
    """The materials with their runs, and by its name in the archive the path of each file; raises BadInput.

    With `every` all materials, and what is made of all of them together.
    """
    synthetic = synthetic_runs(configuration)
    plan_materials = make_plan(Path("raw"), synthetic).materials
    materials = {
        name: plan_materials[name]
        for name in (plan_materials if every else dict.fromkeys(wanted))
        if name in plan_materials
    }
    for name in wanted:
        if name not in plan_materials:
            mend = f"give some of {', '.join(plan_materials) or 'none: raw/ holds no run'}"
            raise BadInput("arguments", ascii(name)[:200], "no run in raw/ is of this material", mend)
    runs = {run for own in materials.values() for run in own}
    files: dict[str, str] = {}
    late = []
    for product, _, _, logs, _, plan in (line[:6] for line in summary(configuration)):
        if not every and not _belongs(product, set(materials), runs):
            continue
        if plan != MADE:
            late.append(product)
        files |= {name: name for name in [*below(product), *filter(os.path.isfile, logs.split(","))]}
        files[f"{PROVENANCE}/{product}.json"] = str(note_of(Path(), product))
    if late or not files:
        what = (
            f"{len(late)} of its files are not made, or not as they should be, such as {late[0]}" if late else "nothing"
        )
        raise BadInput("snakemake", ", ".join(materials), what, "run snakemake with the same configuration, then pack")
    files |= {name: name for run in runs for name in recorded_files(Path("raw"), run, synthetic)}
    return materials, {name: files[name] for name in sorted(files) if allowed(name) and os.path.isfile(files[name])}
