"""Recordings made in a moment, for tests that do not need the rig."""

from typing import Any

import numpy as np
import pandas as pd

from pipeline.ground.kinematics import Array, Geometry

BASE = Geometry("separator", 0.4, 400.0, 15.0, 150.0, 8.0)


def motion(strokes: int, top: float = 27.0, speed: float = 2.0, hold_s: float = 1.0, rest_s: float = 2.0) -> Array:
    """Corner points (time_s, turns) of a protocol: a rest, then windings, holds, unwindings and rests."""
    corners = [(0.0, 0.0), (rest_s, 0.0)]
    for _ in range(strokes):
        for duration_s, turns in ((top / speed, top), (hold_s, top), (top / speed, 0.0), (rest_s, 0.0)):
            corners.append((corners[-1][0] + duration_s, turns))
    return np.array(corners)


def recording(
    strokes: int = 3, rate_hz: float = 25.0, noise_mm: float = 0.02, seed: int = 0, **how: Any
) -> pd.DataFrame:
    """Samples of a string that lengthens by 0.1 mm a stroke; columns time_s, motor_turns, displacement_mm, load_n."""
    rng = np.random.default_rng(seed)
    corners = motion(strokes, **how)
    time_s = np.arange(0.0, corners[-1, 0], 1.0 / rate_hz)
    turns = np.interp(time_s, corners[:, 0], corners[:, 1])
    worked = np.cumsum(np.maximum(np.diff(turns, prepend=0.0), 0.0)) / corners[:, 1].max()
    x = BASE.contraction_mm(turns, 20.0) - 0.1 * worked - 5.0 + noise_mm * rng.standard_normal(len(turns))
    return pd.DataFrame({"time_s": time_s, "motor_turns": turns, "displacement_mm": x, "load_n": 20.0})


def content(name: str, **changes: Any) -> dict[str, Any]:
    """A good `run.yaml`; `changes` replace or add keys of its top level, None removes one."""
    string = {"material": "UHMWPE", "radius_mm": 0.4, "length_mm": 400, "stiffness_n_per_mm": 15}
    whole = {"run": name, "string": string, "rig": {"torsion_zone_mm": 150, "separator_mm": 8}, **changes}
    return {key: value for key, value in whole.items() if value is not None}
