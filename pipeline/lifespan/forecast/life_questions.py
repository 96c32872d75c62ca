"""The two questions on a string's health: when has it lost a share of its stroke, and when is a model too wrong?"""

from dataclasses import dataclass, replace

import numpy as np

from ...ground.kinematics import Array
from ..stroke_health.health import Health
from ..stroke_health.indicators import REFERENCE
from ..stroke_health.reading_jump import JUMPING, LEFT, Step, steps
from ..stroke_health.recovery import NO_BREAK, Recovery, recovery
from .futures_margin import LATER
from .strokes_left import LEAST_STROKES, Left, strokes_left


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
    recovery: Recovery = NO_BREAK  # the breaks that took back a part of it


def lived(health: Health) -> float:
    """Strokes from the first seen one to the last: both questions look ahead by the same multiple of them."""
    n = health.strokes["stroke"]
    return float(n.iloc[-1] - n.iloc[0] + 1)


def through_no_jump(forecast: Left, jumps: list[Step]) -> Left:
    """The forecast, or why there is none: a law that goes through a jump foretells more of what happened once.

    That a limit was passed stays.
    """
    if not jumps or forecast.reason:
        return forecast
    if np.isfinite(forecast.passed_at):
        return replace(forecast, jumped=True)
    strokes = [str(number) for number in sorted({step.stroke for step in jumps})]
    at = f"a jump at stroke {strokes[0]}" if len(strokes) == 1 else f"jumps at strokes {' and '.join(strokes)}"
    why = f"most of its change came by {at}, and a jump follows no law"
    record = f"For a forecast record {LEAST_STROKES} strokes as a new run, and name only the runs since the jump"
    return Left(f"{why}. {record}", jumped=True)


def stroke_loss(health: Health, loss: float) -> Answer:
    """When the stroke has lost a share `loss` of what it was over the first strokes."""
    table = health.strokes.dropna(subset=["stroke_mm"])  # a stroke that ends short has no reading at the top
    n, stroke_mm = table["stroke"].to_numpy(float), table["stroke_mm"].to_numpy()
    first_mm = float(stroke_mm[:REFERENCE].mean())
    lost = 1.0 - stroke_mm / first_mm
    spread = float(np.median(np.abs(np.diff(lost)))) / (0.6745 * np.sqrt(2.0)) if len(lost) > 1 else 0.0
    limit_error, power = spread / np.sqrt(REFERENCE), LATER["stroke_loss"]
    forecast = strokes_left(n, lost, loss, limit_error, lived=lived(health), power=power)
    forecast = through_no_jump(forecast, steps(table, "stroke_mm"))
    errors = table["stroke_mm_error"].to_numpy() / first_mm
    return Answer("stroke_loss", "share of the stroke lost", "1", n, lost, errors, loss, forecast)


def model_error(health: Health, drift_mm: float) -> Answer:
    """When the model calibrated on the first strokes is off by `drift_mm`; those strokes are no test of it."""
    table = health.strokes.iloc[REFERENCE:].dropna(subset=["model_error_mm"])
    before = min(REFERENCE, len(health.strokes))
    n, off_mm = table["stroke"].to_numpy(float), table["model_error_mm"].to_numpy()
    errors = table["model_error_mm_error"].to_numpy()
    came_back = recovery(health.strokes)
    since = came_back.since[-len(n) :] if came_back.is_known else None
    power = LATER["model_error"]
    forecast = strokes_left(n, off_mm, drift_mm, before=before, lived=lived(health), power=power, since=since)
    if not forecast.reason:
        jumps = [step for name in JUMPING for step in steps(health.strokes, name)]
        is_most = sum(abs(step.moved_mm) for step in jumps) > LEFT * float(np.median(off_mm[-REFERENCE:]))
        forecast = through_no_jump(forecast, jumps if is_most else [])
    return Answer(
        "model_error",
        "model error",
        "mm",
        n,
        off_mm,
        errors,
        drift_mm,
        forecast,
        came_back,
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
