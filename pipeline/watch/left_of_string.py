"""The strokes left of a string by its newest forecast, in the terminal's words: rounded down."""

import json
import math
from pathlib import Path
from typing import TypedDict

from ..ground.words.counts import counted
from .page_content import Left
from .reports_of_run import newest_first, text_of

LIMITS = {  # by the question of a forecast
    "stroke_loss": "{limit:.3g} % of the stroke is lost",
    "model_error": "a model calibrated on the first strokes is off by {limit:g} mm",
}


class Question(TypedDict, total=False):
    """The parts of one question of a lifespan.json that the page reads; `strokes_left` holds low, median and high."""

    limit: float
    unit: str
    strokes_left: dict[str, float | None]


def _limit(question: str, content: Question) -> str:
    """The question's limit, in words."""
    limit = float(content["limit"]) * (100.0 if content["unit"] == "1" else 1.0)
    return LIMITS.get(question, f"{question} passes {{limit:g}}").format(limit=limit)


def _count(least: str, median: float | None, low: float | None) -> str:
    """Median and lower end, each rounded down; the median is the stroke that half of the futures reach."""
    words = [] if median is None else [f"{math.floor(median)} (median)"]
    return ", ".join([*words, *([] if low is None else [f"at least {math.floor(low)} in {least}"])])


def _beside(questions: dict[str, Question], first: str, least: str) -> list[str]:
    """The strokes left by the other limits, each with its limit."""
    others = []
    for name, question in questions.items():
        strokes_span = question["strokes_left"]
        if (
            name != first
            and "limit" in question
            and (words := _count(least, strokes_span["median"], strokes_span["low"]))
        ):
            others.append(f"{words}, until {_limit(name, question)}")
    return others


def strokes_left(reports: Path, string: str) -> Left | None:
    """Low, median and high of the earliest question of a string's newest lifespan.json, and its path below reports/.

    `words` say how many in how many of the futures, `until` which limit is passed, `rests` on how many strokes of
    which runs, `beside` what the other limits leave. None where there is none.
    """
    for path in newest_first(reports, string, "lifespan.json"):
        try:
            content = json.loads(text_of(path))
            question = content["questions"][content["first"]]
            strokes_span = question["strokes_left"]
            numbers = {
                name: None if strokes_span[name] is None else float(strokes_span[name])
                for name in ("low", "median", "high")
            }
            least = f"{100.0 * float(content.get('level', 0.9)):.0f} % of the futures"
            seen, runs = content.get("strokes_seen"), [str(run) for run in content.get("runs", [])]
            return {
                "low": numbers["low"],
                "median": numbers["median"],
                "high": numbers["high"],
                "words": _count(least, numbers["median"], numbers["low"]),
                "beside": _beside(content["questions"], str(content["first"]), least),
                "until": _limit(str(content["first"]), question) if "limit" in question else "",
                "rests": f"{counted(int(seen), 'stroke')} of {' and '.join(runs)}" if seen and runs else "",
                "file": path.relative_to(reports).as_posix(),
            }
        except (ValueError, KeyError, TypeError, RecursionError):
            continue
    return None
