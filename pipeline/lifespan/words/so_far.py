"""How far a question's limit is now, by the last strokes, in a sentence."""

import numpy as np

from ..forecast.life_questions import Answer
from ..stroke_health.indicators import REFERENCE

LAST = 3  # strokes that tell how far a limit is
LEAST_LOSS = 1e-3  # per cent of the stroke: no sensor shows less
LEAST_OFF = 1e-6  # mm: no sensor shows less


def exact(value: float, limit: float) -> str:
    """A number with two digits, or with as many as tell it from the limit: 1.03 beside 1."""
    texts = (f"{value:.{digits}g}" for digits in range(2, 7))
    return next((text for text in texts if float(text) != float(f"{limit:.6g}")), f"{value:.2g}")


def off_by(value: float, noise: float, answer: Answer) -> str:
    """A model's error with its unit; an error below its noise (a standard error) is said to be less than that."""
    if max(value, noise) < LEAST_OFF:
        return "nothing measurable"
    if value < noise:
        return f"less than the noise of a stroke, {noise:.2g} {answer.unit}"
    return f"{exact(value, answer.limit)} {answer.unit}"


def so_far(answer: Answer, at_rest: str = "") -> str:
    """The state at the last strokes, whatever the forecast; `at_rest` is a change that no stroke shows."""
    after = len(answer.n) - (REFERENCE if answer.unit == "1" else 0)
    if after <= 0:
        first = f"the first {REFERENCE} strokes are what the later ones are compared with"
        return f"So far: {first}: from stroke {REFERENCE + 1} on it shows."
    last = answer.values[-min(after, LAST) :]
    of, middle = f"the last {len(last)} strokes" if len(last) > 1 else "the last stroke", float(np.median(last))
    if answer.unit != "1":
        noise = float(np.median(answer.errors[-len(last) :]))
        off = off_by(middle, noise, answer)
        return f"So far: a model calibrated on the first {REFERENCE} strokes is off by {off} (median of {of})."
    against, rest = f"{of} against the first {REFERENCE}", f", {at_rest}" * bool(at_rest)
    if abs(100.0 * middle) < LEAST_LOSS:
        return f"So far: nothing measurable of the stroke is lost{rest} ({against})."
    if middle < 0.0:
        return f"So far: the stroke grew by {100.0 * -middle:.2g} %; nothing is lost{rest} ({against})."
    lost = exact(100.0 * middle, 100.0 * answer.limit)
    return f"So far: {lost} % of the stroke is lost ({against})."
