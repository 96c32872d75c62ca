"""Which law predicts best: each is fitted to the first strokes and scored on the others, several times over.

The same forecasts say how much farther off the left-out strokes lay than the laws' own uncertainty says, and how that
grows with the share of strokes ahead.

Source: Tashman, "Out-of-sample tests of forecasting accuracy", International Journal of Forecasting 16, 2000.
"""

from dataclasses import dataclass

import numpy as np

from ...ground.kinematics import Array
from ...ground.words.progress import steps
from .fitted_law import Fit, fit
from .laws import LAWS, Law

MOST_POINTS = 80  # strokes beyond are averaged in blocks: the laws are smooth
ORIGINS = (0.4, 0.5, 0.6, 0.7, 0.8, 0.9)  # of the strokes seen: fitted up to there, scored on what comes after
LEAST_FITTED = 6
JUDGED = 0.6  # share of the origins at which a law must have had enough strokes to be a candidate
TAIL = 4.0  # degrees of freedom of a forecast's error: one bad forecast must not decide alone
TEMPER = 0.8  # origins share strokes, so that two of them tell about as much as one
OUTLIER = 6.0  # robust spreads

Forecast = tuple[Array, Array, Array]


@dataclass(frozen=True)
class Choice:
    """Fits to all strokes with their weights, and the scores from the rolling origins.

    `weights` add up to 1. `errors` holds each law's root mean square forecast error, in the indicator's unit, of the
    strokes left out; `growth`, per strokes ahead/strokes seen, is the standard deviation of what it did not foresee.
    """

    fits: list[Fit]
    weights: Array  # (fits,), in shares of 1
    errors: Array  # (fits,)
    growth: Array  # (fits,), in the indicator's unit
    origins: int

    @property
    def best(self) -> Fit:
        """Fit of the law with the greatest weight."""
        return self.fits[int(np.argmax(self.weights))]

    def curve(self, n: Array) -> Array:
        """Weighed mean of the laws at strokes n. Shape (strokes,)."""
        return np.asarray(
            sum(weight * fitted.moments(n)[0] for weight, fitted in zip(self.weights, self.fits, strict=True))
        )


def blocks(n: Array, values: Array, most: int = MOST_POINTS) -> tuple[Array, Array, Array]:
    """Strokes, mean values and numbers of strokes of at most `most` blocks of equal length, outliers left out.

    From shape (strokes,) to shape (blocks,), values in the indicator's unit.
    """
    kept = ~outliers(values)
    parts = np.array_split(np.flatnonzero(kept), min(most, int(kept.sum())))
    means = [(n[part].mean(), values[part].mean(), float(len(part))) for part in parts]
    block_n, block_means, block_counts = np.array(means).T
    return block_n, block_means, block_counts


def outliers(values: Array, reach: int = 3) -> np.ndarray:
    """Whether a value lies far off the median of its neighbours on either side, shape (strokes,).

    Values of shape (strokes,), in any unit.
    """
    if len(values) <= 2 * reach:
        return np.zeros(len(values), bool)
    padded = np.pad(values, reach, mode="reflect", reflect_type="odd")
    windows = np.lib.stride_tricks.sliding_window_view(padded, 2 * reach + 1)
    off = values - np.median(np.delete(windows, reach, axis=1), axis=1)
    spread = 1.4826 * float(np.median(np.abs(off)))
    return np.asarray(np.abs(off) > OUTLIER * spread) if spread > 0 else np.zeros(len(values), bool)


def forecasts(law: Law, n: Array, values: Array, weights: Array) -> list[Forecast | None]:
    """For each origin the strokes ahead over those seen, a law's errors there, and their variance as it sees it.

    `n`, values and weights have the shape (strokes,): values and errors in the indicator's unit, variance in its unit
    squared, the rest without a unit. Each answer has the shape (strokes ahead,).
    """
    each_origin: list[Forecast | None] = []
    for share in ORIGINS:
        first = round(share * len(n))
        if first < LEAST_FITTED or first >= len(n):
            continue
        fitted = fit(law, n[:first], values[:first], weights[:first])
        if fitted is None:
            each_origin.append(None)
            continue
        ahead = n[first:]
        mean, variance = fitted.moments(ahead)
        noise = np.square(fitted.noise) / weights[first:]
        each_origin.append((ahead / n[first - 1] - 1.0, values[first:] - mean, variance + noise))
    return each_origin


def likelihood(errors: Array, variance: Array) -> float:
    """Mean log-likelihood of forecast errors under Student's t of the variance foreseen.

    Both of shape (forecasts,), in the indicator's unit and its unit squared.
    """
    return float(
        np.mean(-0.5 * np.log(variance) - 0.5 * (TAIL + 1.0) * np.log1p(np.square(errors) / (TAIL * variance)))
    )


def choose(n: Array, values: Array, laws: tuple[Law, ...] = LAWS) -> Choice:
    """Weigh laws of an indicator over strokes n, both of shape (strokes,); at least LEAST_FITTED of them.

    In the indicator's unit.
    """
    n, values, counts = blocks(n, values)
    fits = [(law, fit(law, n, values, counts)) for law in laws]
    pairs = [(fitted, forecasts(law, n, values, counts)) for law, fitted in steps(fits, "law") if fitted is not None]
    pairs = [(fitted, ahead) for fitted, ahead in pairs if sum(at is not None for at in ahead) > JUDGED * len(ahead)]
    common = [at for at in range(len(pairs[0][1])) if all(ahead[at] is not None for _, ahead in pairs)]
    of_laws = [[origin for at in common if (origin := ahead[at]) is not None] for _, ahead in pairs]
    scores = TEMPER * np.array([sum(likelihood(error, variance) for _, error, variance in law) for law in of_laws])
    weights = np.exp(scores - scores.max())
    weights /= weights.sum()
    errors = [float(np.sqrt(np.mean(np.concatenate([np.square(error) for _, error, _ in law])))) for law in of_laws]
    fitted_laws, surpluses = [fitted for fitted, _ in pairs], np.array([surplus(law) for law in of_laws])
    return Choice(fitted_laws, weights, np.array(errors), surpluses, len(common))


def surplus(origins: list[Forecast]) -> float:
    """Standard deviation of a law's forecast errors beyond the predicted ones, per strokes ahead/strokes seen."""
    above = sum(float(np.mean((np.square(error) - variance) * np.square(ahead))) for ahead, error, variance in origins)
    below = sum(float(np.mean(ahead**4)) for ahead, _, _ in origins)
    return float(np.sqrt(max(above, 0.0) / below)) if below > 0 else 0.0
