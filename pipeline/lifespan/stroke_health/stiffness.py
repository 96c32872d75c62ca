"""The stiffness of the string in one stroke, from the change of its length with a load that varies.

Source: Björck, Numerical Methods for Least Squares Problems, 1996.
"""

import numpy as np
import pandas as pd

LEAST_VARIATION = 0.05  # of the load's median: less tells nothing of the stiffness
LEAST_SAMPLES = 20
DEGREE = 3  # of the polynomial in the twist that stands for all that is not load
SURE = 4.0  # standard errors by which the slope must differ from none


def stiffness(moving: pd.DataFrame) -> dict[str, float]:
    """Stiffness of a stroke in N/mm and its standard error; NaN if the load or the length does not vary.

    `moving` has the columns motor_turns, left_mm, load_n and direction (1 winding, -1 unwinding), a row a sample.
    """
    nothing = {"stiffness_n_per_mm": np.nan, "stiffness_n_per_mm_error": np.nan}
    load_n = moving["load_n"].to_numpy()
    low, high = np.percentile(load_n, [5, 95])
    if len(moving) < LEAST_SAMPLES or high - low < LEAST_VARIATION * abs(float(np.median(load_n))):
        return nothing
    turns, direction = moving["motor_turns"].to_numpy(), moving["direction"].to_numpy()
    place = 2.0 * (turns - turns.min()) / max(float(np.ptp(turns)), 1e-9) - 1.0
    polynomials = np.polynomial.legendre.legvander(place, DEGREE)
    columns = np.column_stack([load_n - load_n.mean(), polynomials, direction[:, None] * polynomials])
    solution, _, rank, _ = np.linalg.lstsq(columns, moving["left_mm"].to_numpy(), rcond=1e-9)
    if rank < columns.shape[1]:
        return nothing
    residual_mm = moving["left_mm"].to_numpy() - columns @ solution
    alike = float(np.clip(residual_mm[1:] @ residual_mm[:-1] / max(residual_mm @ residual_mm, 1e-300), 0.0, 0.9))
    variance = residual_mm @ residual_mm / (len(residual_mm) - columns.shape[1]) * (1.0 + alike) / (1.0 - alike)
    slope, error = -solution[0], float(np.sqrt(variance * np.linalg.inv(columns.T @ columns)[0, 0]))
    if slope < SURE * error:
        return nothing
    return {"stiffness_n_per_mm": 1.0 / slope, "stiffness_n_per_mm_error": error / slope**2}
