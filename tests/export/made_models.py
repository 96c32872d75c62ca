"""Small fitted models to export: of one string, of a used one, of a campaign, and of a twisted pair."""

from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from models.made_dataset import LOAD_N, STRING, ZONE, hidden_mm, made_dataset, pair_dataset

from pipeline.ground.kinematics import Geometry
from pipeline.ground.stored import schemas
from pipeline.models.interface import make_model

QUICK: dict[str, dict[str, Any]] = {
    "inn": {"blocks": 4, "width": 20, "layers": 3, "epochs": 12, "batch": 60, "rates": [8e-3, 4e-3, 1e-3, 5e-4]},
    "cinn": {"blocks": 4, "width": 20, "epochs": 12, "batch": 60},
    "mlp": {"width": 16, "epochs": 12, "batch": 60, "rate": 1e-2},
}


def campaign() -> pd.DataFrame:
    """Four strings that differ in radius, load and material, whose curves differ accordingly."""
    parts = []
    for number, (radius_mm, load_n, material) in enumerate(
        [(0.40, 20.0, "UHMWPE"), (0.46, 32.0, "Kevlar"), (0.40, 32.0, "Kevlar"), (0.46, 20.0, "UHMWPE")]
    ):
        points = made_dataset(40, 5, seed=number)
        turns, direction = points["motor_turns"].to_numpy(), points["direction"].to_numpy()
        nominal = Geometry("separator", **STRING, **ZONE).contraction_mm(turns, LOAD_N)
        mine = Geometry("separator", **{**STRING, "radius_mm": radius_mm}, **ZONE).contraction_mm(turns, load_n)
        beyond = hidden_mm(turns, direction, points["stroke"].to_numpy() - 1.0) - nominal
        grown = beyond * (1.0 + 0.01 * (load_n - 20.0)) * (1.2 if material == "Kevlar" else 1.0)
        load = load_n + np.random.default_rng(number).normal(0.0, 0.1, len(points))
        parts.append(
            points.assign(
                string=f"s{number}", run=f"s{number}", radius_mm=radius_mm, load_n=load, displacement_mm=mine + grown,
                material=material,
            )
        )  # fmt: skip
    return pd.concat(parts, ignore_index=True)


def short_wound() -> pd.DataFrame:
    """One string under 20 N, under 30 N only to 16 turns, under 40 N from 5 to 20: with the noise of a load cell."""
    points = made_dataset(60, 6)
    stroke, turns = points["stroke"], points["motor_turns"]
    load_n = np.where(stroke > 4, np.where(stroke > 5, 40.0, 30.0), 20.0)
    points["load_n"] = load_n + np.random.default_rng(3).normal(0.0, 0.05, len(points))
    whole = (stroke <= 4) | ((stroke == 5) & (turns <= 16.0)) | ((stroke == 6) & turns.between(5.0, 20.0))
    return points[whole].reset_index(drop=True)


def switched() -> pd.DataFrame:
    """One string of whose strokes 1 to 4 are under 20 N and stroke 5 is under 30 N, as the quick job's."""
    points = made_dataset(60, 5)
    load_n = np.where(points["stroke"] > 4, 30.0, 20.0)
    return points.assign(load_n=load_n + np.random.default_rng(4).normal(0.0, 0.05, len(points)))


def back() -> pd.DataFrame:
    """One string of whose strokes 4 to 6 are under 35 N, those before and those after under 20 N."""
    points = made_dataset(60, 8)
    load_n = np.where(points["stroke"].between(4, 6), 35.0, 20.0)
    return points.assign(load_n=load_n + np.random.default_rng(5).normal(0.0, 0.05, len(points)))


def hung_on() -> pd.DataFrame:
    """The same where the 30 N were hung on in the last rest of stroke 4, of which one sample was under them."""
    points = switched()
    at_rest = points.index[points["stroke"] == 4][-1]
    points.loc[at_rest, ["load_n", "motor_turns"]] = 30.0, 0.0
    return points


def apart() -> pd.DataFrame:
    """Two strings: that of 0.4 mm was under 10 N alone, and that of 0.6 mm under 20 N alone."""
    parts = [
        made_dataset(60, 6, seed=number).assign(string=string, run=string, radius_mm=radius_mm, load_n=load_n)
        for number, (string, radius_mm, load_n) in enumerate([("thin", 0.4, 10.0), ("thick", 0.6, 20.0)])
    ]
    parts[1]["displacement_mm"] *= 1.5
    return pd.concat(parts, ignore_index=True)


DATASETS = {
    "apart": apart,
    "hung": hung_on,
    "switched": switched,
    "back": back,
    "short": short_wound,
    "one": lambda: made_dataset(60, 6),
    "used": lambda: made_dataset(60, 6).assign(stroke=lambda points: points["stroke"] + np.int32(50)),
    "campaign": campaign,
    "pair": lambda: pair_dataset(80),
}


def saved(name: str, kind: str, folder: Path) -> Path:
    """A model fitted on the split `within` of a dataset, saved as the pipeline does, its dataset beside it."""
    dataset = DATASETS[kind]()
    model = make_model(name, **QUICK.get(name, {}))
    model.fit(dataset[dataset["within"] == "train"], 0)
    path = folder / name / "within-0.model"
    path.parent.mkdir(parents=True)
    model.save(path)
    if not (folder / "dataset.parquet").exists():
        schemas.write(dataset[schemas.DATASET.names], schemas.DATASET, folder / "dataset.parquet")
    return path
