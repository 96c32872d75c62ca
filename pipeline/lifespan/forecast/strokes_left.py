"""The strokes left until an indicator passes its limit: many futures, each with its law, its parameters and its errors.

Source: Lu and Meeker, "Using degradation measures to estimate a time-to-failure distribution", Technometrics 35, 1993.
"""

from dataclasses import dataclass, field, replace

import numpy as np

from ...ground.kinematics import Array
from .band import Band, band_of
from .futures_margin import later, middle_of, put_later
from .law_choice import Choice, choose
from .recovering import CALIBRATED, recovering

LEAST_STROKES = 12  # 3 set the reference, 6 are fitted at least, 3 are left out at least
FUTURES = 2000
STEPS = 200  # at which a future is looked at, ever wider apart
HORIZON = 10.0  # times the strokes seen: beyond it nothing is claimed
# What no law can know of a string is the same for all of them, and was set on the synthetic strings of seeds 1 and 2:
MARGIN = 1.5  # by which errors grow faster beyond the strokes seen than they did among them
ACCELERATES, ACCELERATION = 0.2, 0.7  # chance that wear feeds itself; mean gain in speed as the strokes seen double
HAZARD = 0.04  # exponent of the chance to see no sudden end until the strokes seen have grown by a factor
PASSED_OF = 3  # strokes whose median must be past the limit
NOISE_SIGMAS = 3.0  # a drift smaller than so many of its standard errors is none


@dataclass(frozen=True)
class Span:
    """Strokes left from the last one seen, by a level's interval; `median` and `high` may be infinite.

    `state` is "interval", "one-sided" (no upper end before the horizon: it fails below alone), "censored" (no lower
    end before it either: `low` is the horizon), "passed" or "no claim".
    """

    state: str
    low: float = np.nan
    median: float = np.nan
    high: float = np.nan


@dataclass(frozen=True)
class Left:
    """When the limit is passed in each future: strokes left, infinite beyond the horizon; or why nothing is said."""

    reason: str = ""
    passed_at: float = np.nan
    when: Array = field(default_factory=lambda: np.zeros(0))  # (FUTURES,), in strokes
    horizon: float = np.nan
    choice: Choice | None = None
    band: Band | None = None  # what is drawn of the futures
    drifts: bool = True  # whether it has changed by more than its noise
    jumped: bool = False  # whether most of its change is a jump, which no law foretells
    lacks: Array | None = None  # where breaks take a part back: what each stroke lacks of it, (strokes,), in mm

    def span(self, level: float) -> Span:
        """The interval that holds the strokes left with probability `level`."""
        if np.isfinite(self.passed_at):
            return Span("passed", 0.0, 0.0, 0.0)
        if not len(self.when):
            return Span("no claim")
        ends = [0.5 - level / 2, 0.5, 0.5 + level / 2, 1.0 - level]
        low, median, high, alone = (float(quantile) for quantile in np.quantile(self.when, ends, method="inverted_cdf"))
        low = low if np.isfinite(high) else alone
        state = "interval" if np.isfinite(high) else "one-sided" if np.isfinite(low) else "censored"
        return Span(state, min(low, self.horizon), median, high)


def futures(choice: Choice, ahead: Array, generator: np.random.Generator) -> Array:
    """Values of the indicator so many strokes ahead of the last one seen; shape (FUTURES, strokes).

    In the indicator's unit.
    """
    counts = generator.multinomial(FUTURES, choice.weights)
    seen = choice.fits[0].seen
    drawn = [
        fitted.draws(seen + ahead, int(count), generator)
        for fitted, count in zip(choice.fits, counts, strict=True)
        if count
    ]
    growth = np.repeat(choice.growth, counts)
    freedom = max(choice.origins - 1.0, 2.0)
    heavy = generator.standard_normal(FUTURES) * np.sqrt(freedom / generator.chisquare(freedom, FUTURES))
    reach = ahead / seen
    paths = np.concatenate(drawn)
    speed = ACCELERATION * generator.exponential(size=FUTURES) * (generator.random(FUTURES) < ACCELERATES)
    faster = 1.0 + speed[:, None] * reach
    change = paths - paths[:, :1]
    paths = paths[:, :1] + np.where(change > 0.0, change * faster, change)
    return np.asarray(paths + (MARGIN * growth * heavy)[:, None] * reach)


def passages(paths: Array, limit: Array, ahead: Array) -> Array:
    """Strokes ahead at which each path first passes its limit, infinite where it does not; shape (paths,).

    Paths have the shape (paths, strokes), in the indicator's unit.
    """
    past = paths >= limit[:, None]
    first = np.argmax(past, axis=1)
    before = np.maximum(first - 1, 0)
    rows = np.arange(len(paths))
    low, high = paths[rows, before], paths[rows, first]
    share = np.clip((limit - low) / np.where(high > low, high - low, 1.0), 0.0, 1.0)
    when = np.where(first == 0, 0.0, ahead[before] + share * (ahead[first] - ahead[before]))
    return np.where(past.any(axis=1), when, np.inf)


def surprises(seen: float, generator: np.random.Generator) -> Array:
    """Strokes left until a sudden end: each doubling of the strokes seen is as dangerous as the one before.

    Shape (futures,), a count of strokes.
    """
    return np.asarray(seen * (generator.random(FUTURES) ** (-1.0 / HAZARD) - 1.0))


def sudden(times: float) -> float:
    """Chance of a sudden end within `times` the strokes seen, the same for every string."""
    return float(1.0 - (1.0 + times) ** -HAZARD)


def first_passed(n: Array, values: Array, limit: float) -> float:
    """First stroke at which the median of PASSED_OF strokes is past the limit, NaN where none is.

    Both of shape (strokes,), in the indicator's unit.
    """
    windows = np.lib.stride_tricks.sliding_window_view(values, PASSED_OF)
    past = np.flatnonzero(np.median(windows, axis=1) >= limit)
    return float(n[past[0] + PASSED_OF // 2]) if len(past) else np.nan


def strokes_left(
    n: Array,
    values: Array,
    limit: float,
    limit_error: float = 0.0,
    before: int = 0,
    seed: int = 0,
    lived: float | None = None,
    power: float = 1.0,
    since: Array | None = None,
) -> Left:
    """Strokes left until the indicator `values` over strokes n, both of shape (strokes,), passes a limit.

    Values and limit in the indicator's unit.

    `limit_error` is the limit's standard error, `before` how many strokes set the reference and are not among these.
    `lived` is how many strokes the string was seen for, which sets the horizon; without it those from first n to last.
    `power` is that of `futures_margin.later`. `since` counts each stroke from the break before it, shape (strokes,),
    where breaks take back a part of the values: that part is no wear.
    """
    if len(n) + before < LEAST_STROKES:
        count = len(n) + before
        why = f"{count} stroke{' is' if count == 1 else 's are'} too few: {LEAST_STROKES} are the least"
        return Left(f"{why}, of which 3 set the reference and the last 3 check what those before foretell")
    passed = first_passed(n, values, limit)
    if np.isfinite(passed):
        return Left(passed_at=passed)
    recovers = None if since is None else recovering(n, values, since)
    lacks = None if recovers is None else recovers.at(recovers.since[-1:]) - recovers.at(recovers.since)
    if lacks is not None:  # as if each stroke were as far from a break as the last one
        values = values + lacks
    used = np.full(len(n), True) if recovers is None else recovers.since > CALIBRATED
    choice = choose(n[used] - n[0] + 1.0, values[used])
    seen = float(n[-1] - n[0] + 1.0)
    horizon = HORIZON * (seen if lived is None else lived)
    ahead = np.concatenate([[0.0], np.geomspace(0.25, horizon, STEPS)])
    generator = np.random.default_rng(seed)
    paths = futures(choice, ahead + (n[-1] - n[used][-1]), generator)
    if recovers is not None:
        paths = paths + recovers.ahead(ahead, FUTURES)
    off = limit_error * generator.standard_normal(FUTURES)
    ends = surprises(seen, generator)
    when = np.minimum(passages(paths, limit + off, ahead), ends)
    when = np.where(when > horizon, np.inf, when)
    band = band_of(paths, off, ends, ahead)
    band = replace(band, ahead=put_later(ahead, middle_of(when), power))
    return Left(
        "", np.nan, later(when, horizon, power), horizon, choice, band, drifts(n[used], values[used]), lacks=lacks
    )


def drifts(n: Array, values: Array) -> bool:
    """Whether the later strokes differ from the first ones by more than their noise.

    Both of shape (strokes,), values in the indicator's unit.
    """
    noise = float(np.median(np.abs(np.diff(values)))) / (0.6745 * np.sqrt(2.0))
    third = max(len(n) // 3, 1)
    change = abs(values[-third:].mean() - values[:third].mean())
    return bool(change > NOISE_SIGMAS * noise * np.sqrt(2.0 / third))
