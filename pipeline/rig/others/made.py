"""A made recording: its samples, its run.yaml, and the truth, which never goes into the run folder."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TypedDict

import numpy as np
import pandas as pd
import yaml

from ...ground.kinematics import Array
from ...ground.stored import schemas
from ...ground.stored.files import write_text

NOISES = ("none", "usual", "trap")


@dataclass(frozen=True)
class Kind:
    """One concealed effect: its name in docs/physics.md (None: it has none), the size's unit and meaning."""

    mechanism: str | None
    unit: str
    size: str
    signed: bool = False


Shape = Mapping[str, float | list[float]]  # what is drawn of an effect beside its size, by name


class OfRig(TypedDict):
    """The content of a made run.yaml: the rig's dimensions as measured, and how well they were, by their names."""

    run: str
    actuator: str
    rig: dict[str, float]
    tolerance: dict[str, float]


class EffectTruth(TypedDict):
    """The truth on one hidden effect: `rms` is what its removal changes, in the measured channel's unit."""

    mechanism: str | None
    size: float
    unit: str
    rms: float
    parameters: dict[str, float | list[float]]


class Truth(TypedDict):
    """The truth about a made recording; `parameters` are the rig's true ones, by their names."""

    actuator: str
    seed: int
    plan: str
    take: int
    parameters: dict[str, float]
    noise: dict[str, str | float]  # its `kind`, and its rms by the channel's name
    effects: dict[str, EffectTruth]


@dataclass(frozen=True)
class Made:
    """A recording (`time_s` and the channels, one row a sample), the content of its run.yaml, and what was hidden.

    `hidden`, of the samples' rows, holds what no sensor says: each effect's part of the channel, and the truth.
    """

    samples: pd.DataFrame
    run: OfRig
    truth: Truth
    hidden: pd.DataFrame


def check(effects: Mapping[str, float], kinds: Mapping[str, Kind], noise: str) -> None:
    """Raise ValueError for an effect, a size or a noise that no rig of this kind can have."""
    for name, size in effects.items():
        if name not in kinds:
            raise ValueError(f"{name} is not an effect of this rig; known are {', '.join(kinds)}")
        if size < 0 and not kinds[name].signed:
            raise ValueError(f"{name} is {size:g} {kinds[name].unit}; it must be positive")
    if noise not in NOISES:
        raise ValueError(f"noise is {noise!r}; known are {', '.join(NOISES)}")


def told(
    kinds: Mapping[str, Kind], sizes: Mapping[str, float], parts: Mapping[str, Array], drawn: Mapping[str, Shape]
) -> dict[str, EffectTruth]:
    """The truth about every effect, by its name. Each of `parts` has the shape (samples,), in its effect's unit."""
    return {
        name: {
            "mechanism": kinds[name].mechanism,
            "size": size,
            "unit": kinds[name].unit,
            "rms": float(np.sqrt(np.mean(parts[name] ** 2))),
            "parameters": dict(drawn.get(name, {})),
        }
        for name, size in sizes.items()
    }


def write_run(case: Made, folder: Path) -> Path:
    """Write a run folder, run.yaml and recording.parquet, named after the folder; the truth stays out of it."""
    schemas.write(case.samples, schemas.samples(list(case.samples.columns)), folder / "recording.parquet")
    content = {"run": folder.resolve().name, **{key: value for key, value in case.run.items() if key != "run"}}
    write_text(folder / "run.yaml", yaml.safe_dump(content, sort_keys=False))
    return folder
