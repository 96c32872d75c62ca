"""What to do about a string's age: when to calibrate the model again, and when to ask again."""

import math

import numpy as np

from .questions import Answer
from .stroke_counts import strokes
from .strokes_left import LEAST_STROKES, Span

SOONER = 0.5  # of the nearest lower bound: the new strokes then still count before it is reached
LEVEL = 0.9


def drift(answers: list[Answer]) -> Span:
    """What is claimed of the model's error."""
    return next(answer.left.span(LEVEL) for answer in answers if answer.question == "model_error")


def recalibrate_after(answers: list[Answer]) -> int | None:
    """Strokes from now until the model shall be calibrated again: 0 at once, None where nothing is claimed."""
    span = drift(answers)
    return None if span.state == "no claim" else math.floor(span.low)


def ask_again_after(answers: list[Answer]) -> int:
    """Strokes from now until the next question: half of the nearest lower bound, no more than are seen now."""
    seen = max(max((len(answer.n) for answer in answers), default=0), LEAST_STROKES)
    lows = [
        answer.left.span(LEVEL).low for answer in answers if answer.left.span(LEVEL).state not in ("no claim", "passed")
    ]
    return int(np.clip(math.floor(SOONER * min(lows, default=seen)), 1, seen))


def advice(answers: list[Answer]) -> str:
    """One sentence: when to calibrate the model again and when to ask again."""
    again = f"ask again after {strokes(ask_again_after(answers))}"
    when = recalibrate_after(answers)
    if when is None:
        return f"Advice: no reason to calibrate the model again is seen so far; {again}."
    if when == 0:
        return f"Advice: calibrate the model again now; {again}."
    if drift(answers).state == "censored":
        return f"Advice: the model need not be calibrated again within {strokes(when)}; {again}."
    return f"Advice: calibrate the model again after about {strokes(when)}; {again}."
