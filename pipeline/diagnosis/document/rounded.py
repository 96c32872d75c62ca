"""Numbers of a JSON value rounded, so that it reads well and repeats exactly."""

from typing import Any

import numpy as np

DIGITS = 5  # more of them would be rounding, which processors do each in their own way


def tidy(value: Any) -> Any:
    """A JSON value with its numbers rounded to five digits, so that it reads well and repeats exactly."""
    if isinstance(value, dict):
        return {key: tidy(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [tidy(entry) for entry in value]
    if isinstance(value, float | np.floating):
        return float(f"{value:.{DIGITS}g}") + 0.0 if np.isfinite(value) else None
    return int(value) if isinstance(value, np.integer) else value
