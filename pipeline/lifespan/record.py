"""What is said of a string's life: as JSON, with units in the names, and as sentences."""

from typing import Any

import numpy as np
import pandas as pd

from pipeline.lifespan.ask import Answer, first
from pipeline.lifespan.choose import Choice
from pipeline.lifespan.health import INDICATORS, Health
from pipeline.lifespan.indicators import REFERENCE
from pipeline.lifespan.left import LEAST_STROKES
from pipeline.lifespan.percent import percent
from pipeline.zero import Jump

UNFORESEEN = (
    "An end that has not begun, such as a fibre that breaks or wear that sets in late, cannot be foreseen: the "
    "interval gives it a chance that is the same for every string."
)
STIFFNESS_ABSENT = "the load varies too little within a stroke, or the length does not follow it"
SYNTHETIC = (
    "The synthetic rig takes a new string for each recording: let it do more strokes in one, by `--strokes 24` of "
    "python -m pipeline.rig."
)
SHOWN_WEIGHT = 0.005
LAST = 3  # strokes that tell how far a limit is


def finite(value: float, digits: int = 6) -> float | None:
    """A number for JSON: rounded, None for NaN and infinity."""
    return float(f"{value:.{digits}g}") if np.isfinite(value) else None


def laws(choice: Choice | None) -> list[dict[str, Any]]:
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


def answer(one: Answer, level: float) -> dict[str, Any]:
    """One question's answer; strokes are counted from the last one seen, None means beyond the horizon."""
    left, span = one.left, one.left.span(level)
    spans = {"low": span.low, "median": span.median, "high": span.high}
    last = float(one.n[-1]) if len(one.n) else np.nan
    return {
        "limit": one.limit,
        "unit": one.unit,
        "state": span.state,
        "reason": left.reason,
        "strokes_left": {name: finite(value) for name, value in spans.items()},
        "at_stroke": {name: finite(last + value) for name, value in spans.items()},
        "passed_at_stroke": finite(left.passed_at),
        "horizon_strokes": finite(left.horizon),
        "chance_within_horizon": finite(float(np.isfinite(left.when).mean()), 3) if len(left.when) else None,
        "origins": left.choice.origins if left.choice else 0,
        "laws": laws(left.choice),
    }


def lifespan(health: Health, answers: list[Answer], level: float) -> dict[str, Any]:
    """Content of lifespan.json."""
    table = health.strokes
    columns = ["stroke", *(name + end for name in INDICATORS for end in ("", "_error"))]
    told = {
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
        "zero_jumps": [
            {"run": jump.run, "jump_mm": finite(jump.jump_mm), "taken_off": not jump.may_be_wear}
            for jump in health.jumps
        ],
        "starts_anew": health.anew,
        "level": level,
        "first": earliest.question if earliest else None,
        "questions": {one.question: answer(one, level) for one in answers},
        "limits_of_this": UNFORESEEN,
        "absent": {} if "stiffness_n_per_mm" in told else {"stiffness_n_per_mm": STIFFNESS_ABSENT},
        "indicators": told,
    }


def few(strokes: int) -> bool:
    """Whether so many strokes are too few for a forecast."""
    return strokes < LEAST_STROKES


def so_far(one: Answer) -> list[str]:
    """What the last strokes show, where nothing can be said of those to come."""
    after = len(one.n) - (REFERENCE if one.unit == "1" else 0)
    if after <= 0:
        first = f"The first {REFERENCE} strokes are what the later ones are compared with"
        return [f"{first}: from stroke {REFERENCE + 1} on it shows."]
    last = one.values[-min(after, LAST) :]
    of, middle = f"the last {len(last)} strokes" if len(last) > 1 else "the last stroke", float(np.median(last))
    if one.unit != "1":
        return [f"So far it is off by {middle:.2g} {one.unit} ({of}, median)."]
    way = "shorter" if middle > 0.0 else "longer"
    return [f"So far the stroke is {100.0 * abs(middle):.2g} % {way} than over the first {REFERENCE} ({of}, median)."]


def seen(health: Health) -> list[str]:
    """How many strokes were seen; where they are too few, how many are needed and how to get them."""
    table = health.strokes
    strokes = f"{len(table)} stroke{'s' if len(table) != 1 else ''} seen"
    if not few(len(table)):
        return [f"{health.string}: {strokes}, the last one stroke {int(table['stroke'].iloc[-1])}."]
    more = LEAST_STROKES - len(table)
    needed = f"at least {LEAST_STROKES} are needed, {more} more than there are"
    return [
        f"{health.string}: no forecast yet: {strokes}; {needed}.",
        f"  Record {more} or more further strokes of this very string as a new run with the same --string-id "
        f"({health.string}), then name all runs of it in this command.",
        f"  {SYNTHETIC}",
    ]


def sentence(one: Answer, level: float, told: bool = True) -> str:
    """One question's answer in words; unless `told`, without the reason why there is none, which was said before."""
    left, span = one.left, one.left.span(level)
    limit = f"the model calibrated on the first strokes is off by {one.limit:g} {one.unit}"
    limit = f"{percent(one.limit)} of the stroke is lost" if one.unit == "1" else limit
    sure = f"{percent(level)} sure"
    if span.state == "no claim":
        why = f"no claim: {left.reason}" if told else "no forecast yet"
        return " ".join([f"until {limit}: {why}.", *so_far(one)])
    if span.state == "passed":
        return f"until {limit}: passed already at stroke {left.passed_at:.0f}."
    if span.state == "censored" or left.choice is None:
        return f"until {limit}: more than {left.horizon:.0f} strokes left ({sure}), which is as far as is asked."
    law = f"The law of most weight: {left.choice.best.law.name} ({percent(left.choice.weights.max())})."
    if span.state == "interval":
        between = f"{span.low:.0f} to {span.high:.0f} strokes left ({sure})"
        return f"until {limit}: {between}; half of the futures last longer than {span.median:.0f}. {law}"
    asked = f"{left.horizon:.0f}, which is as far as is asked"
    half = f"at least half of the futures last beyond {asked}"
    if np.isfinite(span.median):
        half = f"half of the futures last longer than {span.median:.0f}, some beyond {asked}"
    return f"until {limit}: at least {span.low:.0f} strokes left ({sure}); {half}. {law}"


def zero(jump: Jump) -> str:
    """What is said of a jump of the zero: a mend while there is one to make, and what is done with it here."""
    if jump.taken_off:
        return f"{jump.run} has `tare: run`: the {abs(jump.jump_mm):.2g} mm by which its zero was moved are taken off."
    done = "It may be theirs, and counts as wear" if jump.may_be_wear else "Here it is taken off: it is no wear"
    return f"{jump.advice} {done}."


def young(run: str) -> str:
    """What is said of a run that begins as the string began."""
    return (
        f"{run} begins as this string began: its first strokes and their loops are those of strokes 1 to {REFERENCE} "
        f"again. If {run} is of a new string, what follows is wrong: give it a string.id of its own in its run.yaml "
        "(--string-id of pipeline.new_run)."
    )


def sentences(health: Health, answers: list[Answer], level: float) -> str:
    """All answers in words, a few lines."""
    lines = seen(health)
    if health.left_out:
        lines.append(
            f"  {len(health.left_out)} strokes wind over another range than most of the first three and are left out."
        )
    lines += [f"  {young(run)}" for run in health.anew]
    lines += [f"  {zero(jump)}" for jump in health.jumps]
    lines += [f"  {sentence(one, level, not few(len(health.strokes)))}" for one in answers]
    if any(len(one.left.when) for one in answers):
        lines.append(f"  {UNFORESEEN}")
    return "\n".join(lines)
