"""Made strings for the tests of a campaign and of intervals: known formulas, known noise, no rig behind them."""

import numpy as np
import pandas as pd

from pipeline.ground.kinematics import Geometry
from pipeline.stages.campaign.points import SCHEMA, labelled

NOISE_MM = 0.05
TOP_TURNS, LOAD_N = 20.0, 15.0
TOLERANCE = {
    "radius_tolerance": 0.015, "length_tolerance_mm": 1.0,
    "torsion_zone_tolerance_mm": 0.5, "separator_tolerance_mm": 0.2,
}  # fmt: skip


def made_string(
    number: int, seed: int = 0, strokes: int = 9, per_phase: int = 40, walk_mm: float = 0.0
) -> pd.DataFrame:
    """Points of one string (`points.SCHEMA` without parts): eq. 4 with an offset, slope, loop and growth of its own.

    `walk_mm` moves the string from stroke to stroke at random, so that later strokes are less sure than early ones.
    """
    rng = np.random.default_rng([seed, number])
    string = {"radius_mm": 0.4, "length_mm": 400.0, "stiffness_n_per_mm": 15.0}
    zone = {"torsion_zone_mm": 150.0, "separator_mm": 8.0}
    ideal = Geometry("separator", **string, **zone)
    offset_mm, slope, loop_mm, growth_mm = rng.normal([0.6, 0.03, 0.10, 0.10], [0.3, 0.01, 0.03, 0.04])
    walk = np.cumsum(rng.normal(0.0, walk_mm, strokes))
    ramp, order = TOP_TURNS * (np.arange(per_phase) + 0.5) / per_phase, np.arange(per_phase)
    parts = []
    for stroke in range(1, strokes + 1):
        for phase, way in (("winding", 1), ("unwinding", -1)):
            turns = ramp[::way]
            true_mm = (1.0 + slope) * ideal.contraction_mm(turns, LOAD_N) + offset_mm - loop_mm * way
            true_mm = true_mm - growth_mm * np.log(stroke) + walk[stroke - 1]
            block = (order if way > 0 else order[::-1]) // 5
            columns = {
                "run": f"made-{number:03d}", "string": f"made-{number:03d}", "stroke": stroke, "phase": phase,
                "direction": way, "block": block, "within": "", "later": "",
                "time_s": 20.0 * stroke - 5.0 * way + order / 9,
                "motor_turns": turns, "displacement_mm": true_mm + rng.normal(0.0, NOISE_MM, per_phase),
                "load_n": LOAD_N, "actuator": "separator", **string, **zone, **TOLERANCE,
                "material": ("hemp", "silk")[number % 2],
            }  # fmt: skip
            parts.append(pd.DataFrame(columns))
    points = pd.concat(parts, ignore_index=True)
    return points.astype({name: "int32" for name in ("stroke", "block", "direction")})


def made_campaign(strings: int, seed: int = 0) -> pd.DataFrame:
    """Points of many made strings, with the columns of `points.SCHEMA` and every string's part of the campaign."""
    tables = [made_string(number, seed, per_phase=20) for number in range(strings)]
    return labelled(pd.concat(tables, ignore_index=True))[SCHEMA.names]
