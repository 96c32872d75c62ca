"""How far and how slowly the strength of each effect wanders."""

from typing import Any

import numpy as np

WAVES, PERIODS_S = 4, (10.0, 60.0)
# How far the strength of an effect wanders, rms: no formula of few numbers, whosever it is, may fit an effect without
# remainder, and these would be fitted so (`python -m pipeline.proof.twins`). The others leave enough as they are.
WANDERS = {
    "backlash": 0.034,
    "clamp_slip": 0.019,
    "count_slip": 0.032,
    "end_stop": 0.035,
    "jam": 0.036,
    "overtwist": 0.034,
    "plastic_elongation": 0.010,
    "radius_compaction": 0.036,
    "sensor_drift": 0.017,
    "sensor_lag": 0.044,
    "shaft_windup": 0.030,
    "slack": 0.020,
    "viscous_loss": 0.015,
    "wear": 0.030,
}


def wander(rms_share: float, rng: np.random.Generator) -> dict[str, Any]:
    """Arguments of `pipeline.rig.unsteady.Unsteady`: so far, rms, in waves of PERIODS_S each."""
    periods_s = np.exp(rng.uniform(np.log(PERIODS_S[0]), np.log(PERIODS_S[1]), WAVES))
    phases_rad = rng.uniform(0.0, 2.0 * np.pi, WAVES)
    share = rms_share * float(np.sqrt(2.0 / WAVES))
    return {"shares": [share] * WAVES, "periods_s": periods_s.tolist(), "phases_rad": phases_rad.tolist()}
