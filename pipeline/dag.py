"""What there is to make: which runs lie in `raw/`, of which material each is, and which fits that asks for."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from pipeline.errors import BadInput
from pipeline.run_yaml import MATERIAL_NAME, STRING_ACTUATORS
from pipeline.runs import RECORDINGS, capture_info, find_runs, unfinished

SYNTHETIC_MATERIAL = "synthetic"
SYNTHETIC_DEVICE = "twistbench synthetic rig"  # what the rig's hello calls itself
SYNTHETIC_FILES = ("run.yaml", "recording.frames", "capture.json")


@dataclass
class Plan:
    """Runs by material, and the runs that no table is made of."""

    materials: dict[str, list[str]] = field(default_factory=dict)
    others: list[str] = field(default_factory=list)  # no string, or a run.yaml that reading will complain about
    unfinished: list[str] = field(default_factory=list)  # a capture under way, or cut off

    def add(self, material: str, run: str) -> None:
        """Put a run under its material."""
        self.materials.setdefault(material, []).append(run)


def _material(folder: Path) -> str | None:
    """Material of a run, or None when it has no string or its `run.yaml` is bad; ingest says what is wrong."""
    try:
        content = yaml.safe_load((folder / "run.yaml").read_text(encoding="utf-8"))
        if content.get("actuator", "separator") in STRING_ACTUATORS:
            material = content["string"]["material"]
            return material if MATERIAL_NAME.fullmatch(material) else None
    except (OSError, ValueError, yaml.YAMLError, AttributeError, KeyError, TypeError):
        pass
    return None


def make_plan(raw: Path, synthetic: list[str]) -> Plan:
    """Plan for the runs in a folder and the ones that the pipeline records itself.

    Raises BadInput when a name of the latter belongs to a real recording, which must never be made again.
    """
    plan = Plan()
    for run in synthetic:
        info = capture_info(raw / run)
        if (raw / run).exists() and info and (info.get("hello") or {}).get("device") != SYNTHETIC_DEVICE:
            mend = "rename the run, or the one under `synthetic` in the configuration"
            raise BadInput(raw / run, "run", "is a real recording under a name of the synthetic rig", mend)
        plan.add(SYNTHETIC_MATERIAL, run)
    for folder in find_runs(raw):
        if folder.name in synthetic:
            continue
        material = _material(folder)
        if unfinished(folder):
            plan.unfinished.append(folder.name)
        elif material is None:
            plan.others.append(folder.name)
        else:
            plan.add(material, folder.name)
    return plan


def recorded_files(raw: Path, run: str, synthetic: list[str]) -> list[str]:
    """Files of a run that its samples are made from."""
    if run in synthetic:
        return [str(raw / run / name) for name in SYNTHETIC_FILES]
    names = ("run.yaml", *RECORDINGS, "capture.json")
    return [str(raw / run / name) for name in names if (raw / run / name).is_file()]


def fits(models: dict[str, Any], material: str, only: str | None = None) -> Iterator[str]:
    """Predictions file of every fit of a material that the configuration asks for, or of one model's fits within."""
    for model, settings in models.items():
        for split, count in settings["seeds"].items():
            if only is None or (model == only and split == "within"):
                for seed in range(count):
                    yield f"processed/{material}/{model}/{split}-{seed}.predictions.parquet"
