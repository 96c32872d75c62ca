"""How slowly the strength of an effect wanders; the effect's own file says how far."""

import numpy as np

from ..rig.wandering_strength import Waves

WAVES, PERIODS_S = 4, (10.0, 60.0)


def wander(rms_share: float, rng: np.random.Generator) -> Waves:
    """Arguments of `pipeline.rig.wandering_strength.Unsteady`: so far, rms, in waves of PERIODS_S each."""
    periods_s = np.exp(rng.uniform(np.log(PERIODS_S[0]), np.log(PERIODS_S[1]), WAVES))
    phases_rad = rng.uniform(0.0, 2.0 * np.pi, WAVES)
    share = rms_share * float(np.sqrt(2.0 / WAVES))
    return {"shares": [share] * WAVES, "periods_s": periods_s.tolist(), "phases_rad": phases_rad.tolist()}
