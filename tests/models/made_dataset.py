"""A made dataset for model tests: one string with separator and simple effects that the models do not know."""

from pathlib import Path

import numpy as np
import pandas as pd

from pipeline.ground.kinematics import Array, Geometry
from pipeline.ground.stored.schemas import DATASET
from pipeline.models.interface import make_model

TOP_TURNS = 27.2
PLAY_TURNS = 0.1  # half width of the loop: the string's twist follows the motor's this much behind
STRING = {"radius_mm": 0.4, "length_mm": 400.0, "stiffness_n_per_mm": 15.0}
ZONE = {"torsion_zone_mm": 150.0, "separator_mm": 8.0}
TOLERANCE = {
    "radius_tolerance": 0.03, "length_tolerance_mm": 2.0,
    "torsion_zone_tolerance_mm": 1.0, "separator_tolerance_mm": 0.5,
}  # fmt: skip
LOAD_N = 20.0
BLOCKS = 40


def hidden_mm(motor_turns: Array, direction: Array, cycles: Array) -> Array:
    """True contraction of the made rig: play, a radius that compacts by 17 %, a plastic offset of log law."""
    turns = np.maximum(motor_turns - PLAY_TURNS * direction, 0.0)
    packed = 1.0 - 0.17 * (np.maximum(turns, 0.0) / TOP_TURNS) ** 1.5
    string = Geometry("separator", **{**STRING, "radius_mm": STRING["radius_mm"] * packed}, **ZONE)
    return np.asarray(string.contraction_mm(turns, LOAD_N) - 0.435 * np.log1p(cycles))


def made_dataset(per_phase: int = 370, strokes: int = 9, seed: int = 0) -> pd.DataFrame:
    """Winding and unwinding of each stroke at 2 turn/s with 0.03 mm of noise (`schemas.DATASET`).

    With the defaults 5,000 points or so are "train" in the split `within`.
    """
    rng = np.random.default_rng(seed)
    order = np.arange(per_phase)
    ramp = TOP_TURNS * (order + 0.5) / per_phase
    parts = []
    for stroke in range(1, strokes + 1):
        for phase, direction in (("winding", 1), ("unwinding", -1)):
            turns = ramp[::direction]
            block = order * BLOCKS // per_phase
            from_top = BLOCKS - 1 - block if phase == "winding" else block
            test = from_top % 4 == (from_top // 4 + stroke - 1) % 4
            worked = (turns / TOP_TURNS) ** 2 if phase == "winding" else np.ones(per_phase)
            true_mm = hidden_mm(turns, np.full(per_phase, direction), stroke - 1 + worked)
            parts.append(
                pd.DataFrame(
                    {
                        "run": "made-01", "string": "made-01", "stroke": stroke, "phase": phase,
                        "direction": direction, "block": block,
                        "within": np.where(test, "test", "train"),
                        "later": "train" if stroke <= 7 else "test",
                        "time_s": 30.0 * stroke + (0.0 if direction > 0 else 14.6) + order * 13.6 / per_phase,
                        "motor_turns": turns,
                        "displacement_mm": true_mm + rng.normal(0.0, 0.03, per_phase),
                        "load_n": LOAD_N, "actuator": "separator", **STRING, **ZONE, **TOLERANCE,
                    }
                )
            )  # fmt: skip
    return pd.concat(parts, ignore_index=True)[DATASET.names].astype({"stroke": "int32", "block": "int32"})


def pair_dataset(per_phase: int = 120, seed: int = 0) -> pd.DataFrame:
    """The same strokes of a twisted pair without separator (radius 0.4 mm, length 300 mm), its dimensions exact."""
    points = made_dataset(per_phase, 2, seed).assign(
        run="pair-01", string="pair-01", actuator="twisted_pair", length_mm=300.0,
        torsion_zone_mm=np.nan, separator_mm=np.nan,
    )  # fmt: skip
    string = Geometry("twisted_pair", 0.4, 300.0, 15.0)
    noise_mm = np.random.default_rng(seed).normal(0.0, 0.03, len(points))
    return points.assign(displacement_mm=string.contraction_mm(points["motor_turns"], LOAD_N) + noise_mm)


def words_that_ask(dataset: Path, *, is_saved: bool) -> tuple[str, ...]:
    """Options of `predict` for a model that is fitted anew, or for one that was fitted to all points and saved."""
    if not is_saved:
        return "--model", "polynomial"
    file = dataset.parent / "spline" / "within-0.model"
    file.parent.mkdir(exist_ok=True)
    model = make_model("spline")
    model.fit(pd.read_parquet(dataset), 0)
    model.save(file)
    return "--saved", str(file)
