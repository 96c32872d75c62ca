"""The errors of a model on points left out of its fit, and the input and output column of each of its maps."""

from collections.abc import Callable

import numpy as np
import pandas as pd

from ...interface import Model
from ..rolling_origin import last_seen, last_strokes

GIVEN = {"displacement_mm": "motor_turns", "motor_turns": "displacement_mm"}  # of each map, by what it predicts
MAPS = {"displacement_mm": "forward", "motor_turns": "inverse"}


def foreseen(make: Callable[[], Model], training: pd.DataFrame, rest: pd.DataFrame, seed: int) -> pd.DataFrame:
    """Errors of both maps on left-out points, by a model fitted on the known points."""
    model = make()
    model.fit(training, seed)
    turns = model.inverse(rest.assign(motor_turns=np.nan))
    fitted = {wanted: getattr(model, map_)(training) - training[wanted] for wanted, map_ in MAPS.items()}
    return pd.DataFrame(
        {
            "displacement_mm": model.forward(rest.assign(displacement_mm=np.nan)) - rest["displacement_mm"],
            "displacement_mm_at": rest["motor_turns"],
            "motor_turns": turns - rest["motor_turns"],
            "motor_turns_at": turns,
            **{f"{wanted}_fitted": float(np.mean(error**2)) for wanted, error in fitted.items()},
            **{name: rest[name] for name in ("string", "stroke", "direction")},
            "ahead": np.maximum(rest["stroke"] - last_seen(rest, last_strokes(training)), 0).fillna(0).astype(int),
        }
    )
