"""Copies of the project with two models, which the tests of a cluster run."""

import shutil
import sys
from pathlib import Path

import yaml

ROOT = Path(__file__).parents[2]
SMALL = ("--configfile", "pipeline/config/ci.yaml")


def small_copy(folder: Path) -> Path:
    """Code and profiles, with the environment linked, and of the models the dearest and the cheapest, a fit each."""
    for name in ("pipeline", "env"):
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns(".venv*", "*.tmp.*"))
    shutil.copy(ROOT / "Snakefile", folder)
    (folder / "env" / ".venv").symlink_to(sys.prefix)
    for name in ("default", "ci"):
        path = folder / "pipeline" / "config" / f"{name}.yaml"
        config = yaml.safe_load(path.read_text())
        config["models"] = {model: one for model, one in config["models"].items() if model in ("inn", "traditional")}
        for one in config["models"].values():
            one["seeds"] = {"within": 1, "later": 1}
        path.write_text(yaml.safe_dump(config, sort_keys=False))
    return folder


def command(*words: str) -> list[str]:
    """Snakemake in a copy, as the launcher starts it."""
    return [sys.executable, "env/run.py", "snakemake", *words, "--retries", "2", *SMALL]
