"""The two questions on a string's health: when has it lost a share of its stroke, and when is a model too wrong?"""

from dataclasses import dataclass

import numpy as np

from ...ground.kinematics import Array
from ..stroke_health.health import Health
from ..stroke_health.indicators import REFERENCE
from .futures_margin import LATER
from .strokes_left import Left, strokes_left


@dataclass(frozen=True)
class Answer:
    """An indicator that grows over strokes n, its limit, in `unit`, and when it passes; arrays of shape (strokes,)."""

    question: str
    what: str
    unit: str
    n: Array  # in strokes
    values: Array  # in the indicator's unit
    errors: Array  # standard errors, in the indicator's unit
    limit: float
    left: Left


def lived(health: Health) -> float:
    """Strokes from the first seen one to the last: both questions look ahead by the same multiple of them."""
    n = health.strokes["stroke"]
    return float(n.iloc[-1] - n.iloc[0] + 1)


def stroke_loss(health: Health, loss: float) -> Answer:
    """When the stroke has lost a share `loss` of what it was over the first strokes."""
    table = health.strokes.dropna(subset=["stroke_mm"])  # a stroke that ends short has no reading at the top
    n, stroke_mm = table["stroke"].to_numpy(float), table["stroke_mm"].to_numpy()
    first_mm = float(stroke_mm[:REFERENCE].mean())
    lost = 1.0 - stroke_mm / first_mm
    spread = float(np.median(np.abs(np.diff(lost)))) / (0.6745 * np.sqrt(2.0)) if len(lost) > 1 else 0.0
    limit_error, power = spread / np.sqrt(REFERENCE), LATER["stroke_loss"]
    forecast = strokes_left(n, lost, loss, limit_error, lived=lived(health), power=power)
    errors = table["stroke_mm_error"].to_numpy() / first_mm
    return Answer("stroke_loss", "share of the stroke lost", "1", n, lost, errors, loss, forecast)


def model_error(health: Health, drift_mm: float) -> Answer:
    """When the model calibrated on the first strokes is off by `drift_mm`; those strokes are no test of it."""
    table = health.strokes.iloc[REFERENCE:].dropna(subset=["model_error_mm"])
    before = min(REFERENCE, len(health.strokes))
    n, off_mm = table["stroke"].to_numpy(float), table["model_error_mm"].to_numpy()
    errors = table["model_error_mm_error"].to_numpy()
    return Answer(
        "model_error",
        "model error",
        "mm",
        n,
        off_mm,
        errors,
        drift_mm,
        strokes_left(n, off_mm, drift_mm, before=before, lived=lived(health), power=LATER["model_error"]),
    )


def first(answers: list[Answer]) -> Answer | None:
    """The question whose limit is passed first, by its median; None where no question has a claim."""
    spans = [(answer, answer.left.span(0.9)) for answer in answers]
    with_a_claim = [
        (span.median, span.low, answer.left.passed_at if span.state == "passed" else 0.0, at)
        for at, (answer, span) in enumerate(spans)
        if span.state != "no claim"
    ]
    return answers[min(with_a_claim)[-1]] if with_a_claim else None
