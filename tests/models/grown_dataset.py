"""A made dataset whose string grows by a law of n: nine strokes, a rounded loop and noise, so that floors are known."""

from collections.abc import Callable

import numpy as np
import pandas as pd
from made_dataset import TOLERANCE

from pipeline.ground.kinematics import Array, Geometry
from pipeline.ground.stored.schemas import DATASET

STRING = {"radius_mm": 0.5, "length_mm": 400.0, "stiffness_n_per_mm": 15.0}
ZONE = {"torsion_zone_mm": 150.0, "separator_mm": 10.0}
TOP_TURNS, LOAD_N, NOISE_MM, PLASTIC_MM, LOOP_MM, REACH_TURNS = 40.0, 20.0, 0.05, 2.5, 0.25, 2.0
LAWS: dict[str, Callable[[Array], Array]] = {  # each is 1 at stroke 9
    "logarithmic": lambda n: np.log1p(n) / np.log(10.0),
    "power": lambda n: (n / 9.0) ** 0.35,
    "saturating": lambda n: (1.0 - np.exp(-n / 2.5)) / (1.0 - np.exp(-9.0 / 2.5)),
    # none of these is among the candidates that models choose from
    "slow logarithm": lambda n: np.log1p(n / 4.6) / np.log1p(9.0 / 4.6),
    "steep power": lambda n: (n / 9.0) ** 0.62,
    "slow saturation": lambda n: (1.0 - np.exp(-n / 4.1)) / (1.0 - np.exp(-9.0 / 4.1)),
    "two saturations": lambda n: 0.6 * (1.0 - np.exp(-n / 1.2)) + 0.4 * (1.0 - np.exp(-n / 6.0)),
}


def true_mm(turns: Array, direction: Array, stroke: Array, law: str) -> Array:
    """Contraction without noise: eq. 4 of a string that packs, less growth that fades with twist, less the loop."""
    packed = 0.997 * (1.0 - 0.05 * (turns / TOP_TURNS) ** 1.5)
    string = Geometry("separator", **{**STRING, "radius_mm": STRING["radius_mm"] * packed}, **ZONE)
    grown = PLASTIC_MM * LAWS[law](stroke.astype(float)) * (1.0 - 0.8 * turns / TOP_TURNS)
    since_turns = np.where(direction > 0, turns, TOP_TURNS - turns)
    loop = LOOP_MM * direction * (1.0 - 2.0 * np.exp(-since_turns / REACH_TURNS))
    return np.asarray(string.contraction_mm(turns, LOAD_N) - grown - loop)


def grown_dataset(law: str, seed: int = 0, points: int = 5000) -> pd.DataFrame:
    """Strokes 1 to 7 to train on and strokes 8 and 9 to test on (split `later`), equally many each way."""
    rng = np.random.default_rng(seed)
    stroke = rng.integers(1, 10, points)
    direction = rng.choice([-1, 1], points)
    turns = rng.uniform(0.0, TOP_TURNS, points)
    measured_mm = true_mm(turns, direction, stroke, law) + rng.normal(0.0, NOISE_MM, points)
    test = rng.random(points) < 0.25
    columns = {
        "run": "grown-01", "string": "grown-01", "stroke": stroke,
        "phase": np.where(direction > 0, "winding", "unwinding"), "direction": direction, "block": 0,
        "within": np.where(test, "test", "train"),
        "later": np.where(stroke > 7, "test", "train"), "time_s": 60.0 * stroke + turns,
        "motor_turns": turns, "displacement_mm": measured_mm, "load_n": LOAD_N, "actuator": "separator",
        **STRING, **ZONE, **TOLERANCE,
    }  # fmt: skip
    return pd.DataFrame(columns)[DATASET.names].astype({"stroke": "int32", "block": "int32", "direction": "int32"})
