"""How far a question's limit is now, by the last strokes, in a sentence."""

import numpy as np

from ..forecast.life_questions import Answer
from ..forecast.strokes_left import drifts
from ..stroke_health.indicators import REFERENCE
from .stroke_counts import strokes

LAST = 3  # strokes that tell how far a limit is
LEAST_LOSS = 1e-3  # per cent of the stroke: no sensor shows less
LEAST_OFF = 1e-6  # mm: no sensor shows less


def beside_limit(value: float, limit: float) -> str:
    """A number with two digits, or with as many as tell it from the limit: 1.03 beside 1."""
    texts = (f"{value:.{digits}g}" for digits in range(2, 7))
    return next((text for text in texts if float(text) != float(f"{limit:.6g}")), f"{value:.2g}")


def off_by(value: float, noise: float, answer: Answer) -> str:
    """A model's error with its unit; an error below its noise (a standard error) is said to be less than that."""
    if max(value, noise) < LEAST_OFF:
        return "nothing measurable"
    if value < noise:
        return f"less than the noise of a stroke, {noise:.2g} {answer.unit}"
    return f"{beside_limit(value, answer.limit)} {answer.unit}"


def not_yet(count: int) -> str:
    """The remark that so few strokes, `count` of them compared, show no change at all."""
    compared = f"{strokes(count)} {'is' if count == 1 else 'are'} compared"
    more = f"{REFERENCE + 1 - count} more like {'it' if count == 1 else 'these'}"
    return (
        f"So far: no change can be seen: {compared}, and the first {REFERENCE} are what later ones are compared with. "
        f"A change shows after {more}."
    )


def so_far(answer: Answer, at_rest: str = "") -> str:
    """The state at the last strokes, whatever the forecast; empty where no stroke follows those of the reference.

    `at_rest` is a change beyond the noise that no stroke shows: beside it the stroke's own change is judged too.
    """
    after = len(answer.n) - (REFERENCE if answer.unit == "1" else 0)
    if after <= 0:
        return ""
    last = answer.values[-min(after, LAST) :]
    of, middle = f"the last {len(last)} strokes" if len(last) > 1 else "the last stroke", float(np.median(last))
    if answer.unit != "1":
        noise = float(np.median(answer.errors[-len(last) :]))
        off = off_by(middle, noise, answer)
        return f"So far: a model calibrated on the first {REFERENCE} strokes is off by {off} (median of {of})."
    against, rest = f"{of} against the first {REFERENCE}", f", {at_rest}, beyond the noise" * bool(at_rest)
    moved = drifts(answer.n, answer.values)
    verdict = f", {'beyond' if moved else 'within'} the noise" * bool(at_rest)
    if abs(100.0 * middle) < LEAST_LOSS:
        return f"So far: nothing measurable of the stroke is lost{rest} ({against})."
    if middle < 0.0:
        return f"So far: the stroke grew by {100.0 * -middle:.2g} %{verdict}; nothing is lost{rest} ({against})."
    lost = beside_limit(100.0 * middle, 100.0 * answer.limit)
    if at_rest and not moved:
        return f"So far: {lost} % of the stroke is lost{verdict}{rest} ({against})."
    return f"So far: {lost} % of the stroke is lost ({against})."
