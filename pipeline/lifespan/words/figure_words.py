"""The words of the page of a string's life: the meaning of its lines, shades, bars and arrows."""

from textwrap import fill

import pandas as pd

from ..forecast.life_questions import Answer
from ..forecast.strokes_left import FUTURES, LEAST_STROKES, Span
from ..stroke_health.indicators import REFERENCE
from .percent import tail
from .stroke_counts import at_least

WHAT = {"stroke_loss": "stroke lost", "model_error": "error of the model"}
HEADS = {
    "stroke_loss": f"How much of the stroke is lost since the first {REFERENCE} strokes (below 0: the stroke grew)",
    "model_error": f"How far a model is off that was calibrated on the first {REFERENCE} strokes (rms over a stroke)",
}
NAMED = 4  # recordings whose strokes are listed; of more the foot would grow long
WIDE = 128  # characters of a line at the foot of the page
NEGATIVE_LOOP = "below 0: at equal twist the string is\nshorter while it unwinds"
POINTS = "Blue: each stroke as measured, ± 1 standard error. Loop: displacement winding minus unwinding at equal twist."
FUTURE = (
    f"Green: the law fitted to the strokes. Orange: {FUTURES:,} ways in which it may go on (futures), half of them "
    "above the line. Each counts by its highest value so far; one that ends suddenly counts as above the limit."
)
BAR = (
    "Black bar: where the limit is passed. {0} of the futures pass it before the bar begins (upper edge of the "
    "shade), {0} after it ends (lower edge). Futures are drawn until there."
)
ARROW = (
    "Black arrow: at most {0} of the futures pass the limit before it begins, so {2} stay below it until then. The "
    "shade leaves out {0} above and {0} below: the middle {3}. The forecast looks {1} strokes ahead."
)


def tail_of(span: Span, level: float) -> float:
    """The share of the futures above the shade, or below it, that the claim leaves out."""
    return (1.0 - level) / (2.0 if span.state == "interval" else 1.0)


def which_run(strokes: pd.DataFrame) -> str:
    """The strokes of each recording, between dotted lines; empty where one holds them all.

    `strokes` has a row a stroke, with its `stroke` and its `run`.
    """
    spans = strokes.groupby("run", sort=False)["stroke"].agg(["min", "max"])
    if len(spans) < 2:
        return ""
    dotted = "Dotted: a further recording begins."
    if len(spans) > NAMED:
        return f"{dotted} The upper panel names it."
    parts = [
        f"{low:g} to {high:g}: {run}" if low < high else f"{low:g}: {run}" for run, low, high in spans.itertuples()
    ]
    return f"{dotted} Strokes {'; '.join(parts)}."


def footnote(answers: list[Answer], level: float, which: str = "") -> str:
    """The meaning of the points, and of each line, shade, bar and arrow where futures are drawn.

    `which` says which strokes are of which recording.
    """
    drawn = [answer.left for answer in answers if answer.left.band is not None]
    lines = [POINTS, *filter(None, [which])]
    if not drawn:
        return "\n".join(fill(line, WIDE) for line in lines)
    spans = [forecast.span(level) for forecast in drawn]
    lines.append(FUTURE)
    if any(span.state == "interval" for span in spans):
        lines.append(BAR.format(tail((1.0 - level) / 2.0)))
    if any(span.state != "interval" for span in spans):
        out = 1.0 - level
        lines.append(ARROW.format(tail(out), at_least(drawn[0].horizon), tail(level), tail(1.0 - 2.0 * out)))
    return "\n".join(fill(line, WIDE) for line in lines)


def left_out(of_range: int, of_load: int) -> str:
    """How many strokes are left out, for the title; empty where none is."""
    range_of_twist = f", {of_range} left out (another range of twist)" if of_range else ""
    return f"{range_of_twist}, {of_load} left out (another load)" if of_load else range_of_twist


def no_claim(reason: str) -> str:
    """Why there is no forecast, in a few words."""
    why = reason.split(":")[0].split(". ")[0]
    if "too few" not in why:
        return f"no claim: {why}"
    return f"no forecast yet: {' '.join(why.split()[:2])}, {LEAST_STROKES} needed"
