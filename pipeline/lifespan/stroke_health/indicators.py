"""One stroke's readings → its indicators with standard errors: the stroke, the rest, the loop, the model's error.

Source: Hampel, "The influence curve and its role in robust estimation", Journal of the American Statistical Association
69, 1974 (the median of distances as their spread).
"""

import numpy as np

from ...ground.kinematics import Array
from .readings import Stroke

REFERENCE = 3  # first complete strokes: what later ones are compared with
END_BAND = 0.04  # of the twist range: readings that tell the rest, or the top
MIDDLE = (0.2, 0.8)  # of the twist range: where the loop is measured
CELLS = 20  # of the twist range, for winding and for unwinding
Curves = tuple[Array, Array]  # means in mm and their variances in mm², cell by cell


def mean_error(values: Array) -> tuple[float, float]:
    """Median of values and its standard error, which allows for each value's likeness to the one before.

    They have the shape (values,), and all have one unit.
    """
    if len(values) < 2:
        return (float(values[0]) if len(values) else np.nan), np.nan
    middle = float(np.median(values))
    off = values - middle
    spread = 1.4826 * float(np.median(np.abs(off)))
    off = np.clip(off, -4.0 * spread, 4.0 * spread)
    alike = float(np.clip((off[1:] @ off[:-1]) / (off @ off + 1e-300), 0.0, 0.9))
    return middle, 1.2533 * spread * float(np.sqrt((1.0 + alike) / (1.0 - alike) / len(values)))


def cells(turns: Array, rest_mm: Array, low: float, high: float) -> tuple[Array, Array]:
    """Mean and variance of the mean of readings in equal cells between two twists; NaN and infinity where empty.

    From shape (samples,) to shape (cells,), in mm and its square; twists in turns.
    """
    place = np.floor(CELLS * (turns - low) / (high - low)).astype(int)
    inside = (place >= 0) & (place < CELLS)
    place, rest_mm = place[inside], rest_mm[inside]
    count = np.bincount(place, minlength=CELLS)
    with np.errstate(invalid="ignore", divide="ignore"):
        mean = np.bincount(place, rest_mm, CELLS) / count
        square = np.bincount(place, np.square(rest_mm - mean[place]), CELLS)
        few = np.square(rest_mm - mean[place]).sum() / max(len(place) - CELLS, 1)
        return mean, np.where(count > 3, square / np.maximum(count - 1, 1), few) / count


def ends_mm(stroke: Stroke, low: float, high: float, nominal_mm: float) -> dict[str, float]:
    """Rest and stroke in mm with their standard errors, at the twists of the reference, `nominal_mm` apart."""
    band = END_BAND * (high - low)
    turns, left_mm = stroke.rest
    if not len(turns):
        turns, left_mm = stroke.winding
    rest, rest_error = mean_error(left_mm[turns <= turns.min() + band])
    turns, left_mm = (np.concatenate(pair) for pair in zip(stroke.winding, stroke.hold, strict=True))
    top, top_error = mean_error(left_mm[turns >= high - band])
    error = float(np.hypot(rest_error, top_error))
    return {
        "stroke_mm": top - rest + nominal_mm, "stroke_mm_error": error,
        "rest_mm": rest, "rest_mm_error": rest_error,
    }  # fmt: skip


def loop(stroke: Stroke, low: float, high: float) -> dict[str, float]:
    """Winding minus unwinding at equal twist, mean over the middle of the range, in mm, and its standard error."""
    (up_mm, up_variance), (down_mm, down_variance) = (
        cells(*part, low, high) for part in (stroke.winding, stroke.unwinding)
    )
    place = (np.arange(CELLS) + 0.5) / CELLS
    used = np.isfinite(up_mm - down_mm) & (place > MIDDLE[0]) & (place < MIDDLE[1])
    if not used.any():
        return {"loop_mm": np.nan, "loop_mm_error": np.nan}
    error = float(np.sqrt((up_variance + down_variance)[used].sum()) / used.sum())
    return {"loop_mm": float((up_mm - down_mm)[used].mean()), "loop_mm_error": error}


def curves(stroke: Stroke, low: float, high: float) -> Curves:
    """A stroke's mean over twist, winding and then unwinding, and its variance, each of shape (2 cells,)."""
    (up_mm, up_variance), (down_mm, down_variance) = (
        cells(*part, low, high) for part in (stroke.winding, stroke.unwinding)
    )
    return np.concatenate([up_mm, down_mm]), np.concatenate([up_variance, down_variance])


def model_errors(tables: list[Curves]) -> list[dict[str, float]]:
    """Root mean square over each stroke of its difference from the model calibrated on the first ones, and its error.

    That model is the mean of the first REFERENCE strokes' own curves over twist, winding and unwinding apart: no law
    of mechanics fits them better, so that what it leaves later is what has changed. The noise's share is taken off.
    """
    first = np.array([mean for mean, _ in tables[:REFERENCE]])
    model, own = (
        first.mean(axis=0),
        np.array([variance for _, variance in tables[:REFERENCE]]).sum(axis=0) / REFERENCE**2,
    )
    each_stroke = []
    for mean, variance in tables:
        used = np.isfinite(mean - model)
        if not used.any():
            each_stroke.append({"model_error_mm": np.nan, "model_error_mm_error": np.nan})
            continue
        off, noise = (mean - model)[used], (variance + own)[used]
        square = float(np.mean(np.square(off)) - noise.mean())
        error = float(np.sqrt(np.sum(noise * np.square(off) + np.square(noise) / 2)) / used.sum())
        size = float(np.sqrt(max(square, 0.0)))
        each_stroke.append(
            {"model_error_mm": size, "model_error_mm_error": error / max(size, float(np.sqrt(noise.mean())))}
        )
    return each_stroke
