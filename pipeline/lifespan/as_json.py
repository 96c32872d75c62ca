"""The statements on a string's life as JSON, with units in the names."""

from typing import TypedDict

import numpy as np
import pandas as pd

from .forecast.law_choice import Choice
from .forecast.life_questions import Answer, first
from .json_recovery import RecoverySaid, finite, recovered
from .stroke_health.health import INDICATORS, Health
from .stroke_health.reading_jump import JUMPING, steps
from .words.calibration_advice import ask_again_after, recalibrate_after
from .words.sentences import UNFORESEEN, zero

STIFFNESS_ABSENT = "the load varies too little within a stroke, or the length does not follow it"
SHOWN_WEIGHT = 0.005


class LawSaid(TypedDict):
    """One law of lifespan.json; errors in the unit of what is asked about."""

    name: str
    formula: str
    weight: float | None
    left_out_rms: float | None
    parameters: dict[str, float | None]


class AnswerSaid(TypedDict):
    """One question of lifespan.json; `strokes_left` and `at_stroke` hold low, median and high."""

    limit: float
    unit: str
    state: str
    reason: str
    within_noise: bool
    strokes_left: dict[str, float | None]
    at_stroke: dict[str, float | None]
    passed_at_stroke: float | None
    horizon_strokes: float | None
    chance_within_horizon: float | None
    origins: int
    laws: list[LawSaid]


class JumpSaid(TypedDict):
    """A jump of the zero between two runs: before which run, how far, and whether it was subtracted."""

    run: str
    jump_mm: float | None
    taken_off: bool


class StepSaid(TypedDict):
    """A jump of an indicator within a run: after which stroke, and how far."""

    indicator: str
    run: str
    after_stroke: int
    jump_mm: float | None


class LifespanSaid(TypedDict):
    """All of lifespan.json; what is counted in strokes says so in its name."""

    string: str
    runs: list[str]
    strokes_seen: int
    last_stroke: int
    strokes_of_another_range: list[int]
    load_n: float | None
    strokes_of_another_load: list[int]
    zero_jumps: list[JumpSaid]
    jumps: list[StepSaid]
    recovery: RecoverySaid
    tares: list[str]
    zeros_not_compared: list[str]
    starts_anew: list[str]
    level: float
    first: str | None
    questions: dict[str, AnswerSaid]
    recalibrate_after_strokes: int | None
    ask_again_after_strokes: int | None
    limits_of_this: str
    absent: dict[str, str]  # by the indicator: why it is not there
    indicators: dict[str, list[float | None]]  # a value a stroke, by its name with its unit


def laws(choice: Choice | None) -> list[LawSaid]:
    """The laws by falling weight: formula, weight, error of their forecasts of left-out strokes, best parameters."""
    if choice is None:
        return []
    order = np.argsort(-choice.weights)
    return [
        {
            "name": choice.fits[at].law.name,
            "formula": choice.fits[at].law.formula,
            "weight": finite(choice.weights[at], 3),
            "left_out_rms": finite(choice.errors[at], 4),
            "parameters": {name: finite(value, 5) for name, value in choice.fits[at].parameters().items()},
        }
        for at in order
        if choice.weights[at] > SHOWN_WEIGHT
    ]


def answer(question: Answer, level: float) -> AnswerSaid:
    """One question's answer; strokes are counted from the last one seen, None means beyond the horizon."""
    forecast, span = question.left, question.left.span(level)
    spans = {"low": span.low, "median": span.median, "high": span.high}
    last = float(question.n[-1]) if len(question.n) else np.nan
    return {
        "limit": question.limit,
        "unit": question.unit,
        "state": span.state,
        "reason": forecast.reason,
        "within_noise": not forecast.drifts,
        "strokes_left": {name: finite(value) for name, value in spans.items()},
        "at_stroke": {name: finite(last + value) for name, value in spans.items()},
        "passed_at_stroke": finite(forecast.passed_at),
        "horizon_strokes": finite(forecast.horizon),
        "chance_within_horizon": finite(float(np.isfinite(forecast.when).mean()), 3) if len(forecast.when) else None,
        "origins": forecast.choice.origins if forecast.choice else 0,
        "laws": laws(forecast.choice),
    }


def lifespan(health: Health, answers: list[Answer], level: float) -> LifespanSaid:
    """Content of lifespan.json."""
    table = health.strokes
    columns = ["stroke", *(name + end for name in INDICATORS for end in ("", "_error"))]
    indicators = {
        name: table[name].astype(int).tolist() if name == "stroke" else [finite(v) for v in table[name]]
        for name in columns
        if pd.notna(table[name]).any()
    }
    earliest = first(answers)
    return {
        "string": health.string,
        "runs": health.runs,
        "strokes_seen": len(table),
        "last_stroke": int(table["stroke"].iloc[-1]),
        "strokes_of_another_range": health.left_out,
        "load_n": finite(health.loads.load_n),
        "strokes_of_another_load": sorted(number for _, numbers in health.loads.others for number in numbers),
        "zero_jumps": [
            {"run": jump.run, "jump_mm": finite(jump.jump_mm), "taken_off": not jump.may_be_wear}
            for jump in health.jumps
            if not jump.checked
        ],
        "jumps": [
            {"indicator": name, "run": step.run, "after_stroke": step.stroke, "jump_mm": finite(step.moved_mm)}
            for name in JUMPING
            for step in steps(table, name)
        ],
        "recovery": recovered(next(answer.recovery for answer in answers if answer.question == "model_error")),
        "tares": [*health.tares, *(zero(jump) for jump in health.jumps if jump.checked)],
        "zeros_not_compared": health.uncompared,
        "starts_anew": health.anew,
        "level": level,
        "first": earliest.question if earliest else None,
        "questions": {question.question: answer(question, level) for question in answers},
        "recalibrate_after_strokes": recalibrate_after(answers),
        "ask_again_after_strokes": ask_again_after(answers),
        "limits_of_this": UNFORESEEN,
        "absent": {} if "stiffness_n_per_mm" in indicators else {"stiffness_n_per_mm": STIFFNESS_ABSENT},
        "indicators": indicators,
    }
