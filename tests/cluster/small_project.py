"""Copies of the project with two models, few cases and strings, and made-up downloads, which a cluster's tests run."""

import shutil
import sys
from pathlib import Path

import numpy as np
import pandas as pd
import yaml

ROOT = Path(__file__).parents[2]
SMALL = ("--configfile", "pipeline/config/ci.yaml", "--config", "recordings=downloads")
# Of each kind of job one at least: a case that the baselines see, and one that ends in a tie, which is carried on.
PROOF = {
    "seed": 100, "batch": 2, "twins": ["creep"],
    "mixes": [
        {"stratum": "single", "protocol": "rich", "kappas": [1], "each": 1, "effects": ["creep"], "baselines": True},
        {"stratum": "single", "protocol": "poor", "kappas": [3], "each": 1, "effects": ["backlash"]},
    ],
}  # fmt: skip
LEARNERS = {"mlp": {"epochs": 2}, "spline": {"bins": 4, "steps": 6}}


def small_copy(folder: Path) -> Path:
    """Code and profiles, with the environment linked, and of the models the dearest and the cheapest, a fit each."""
    for name in ("pipeline", "env"):
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns(".venv*", "*.tmp.*"))
    shutil.copy(ROOT / "Snakefile", folder)
    (folder / "env" / ".venv").symlink_to(sys.prefix)
    for name in ("default", "ci"):
        path = folder / "pipeline" / "config" / f"{name}.yaml"
        config = yaml.safe_load(path.read_text())
        config["models"] = {
            model: settings for model, settings in config["models"].items() if model in ("inn", "traditional")
        }
        for settings in config["models"].values():
            settings["seeds"] = {"within": 1, "later": 1}
        config["proof"] = PROOF
        config["campaign"] |= {"strings": 20, "models": LEARNERS}
        path.write_text(yaml.safe_dump(config, sort_keys=False))
    (folder / "downloads").mkdir()
    for number in range(2):
        tool(number).to_csv(folder / "downloads" / f"Tool_1_A_0{number}.TXT", index=False, header=False)
    return folder


def tool(number: int) -> pd.DataFrame:
    """Recording of a surgical tool in the columns of its source, 20 s at 100 Hz: gear, half a loop, stretch, noise."""
    rng, time_s = np.random.default_rng(number), np.arange(0.0, 20.0, 0.01)
    motor_deg = 30.0 * np.sin(2 * np.pi * 0.2 * (number + 1) * time_s)
    torque_nm = 0.1 * np.sin(2 * np.pi * 0.07 * time_s)
    jaw_deg = 0.9 * motor_deg - 1.5 * np.sign(np.gradient(motor_deg)) - 8.0 * torque_nm
    jaw_deg += 0.05 * rng.normal(size=len(time_s))
    table = pd.DataFrame(0.0, index=range(len(time_s)), columns=range(10))
    table[0] = time_s.round(3)
    table[1] = (-motor_deg / 360 * 8192).round()
    table[4] = (jaw_deg / 360 * 4000).round()
    table[5] = (torque_nm / -3.9811e-5).round()
    return table


def command(*words: str) -> list[str]:
    """Snakemake in a copy, as the launcher starts it."""
    return [sys.executable, "env/run.py", "snakemake", *words, "--retries", "2", *SMALL]
