"""The words of the page of a string's life: what its lines, shades, bars and arrows are."""

from .indicators import REFERENCE
from .percent import tail
from .questions import Answer
from .stroke_counts import at_least
from .strokes_left import FUTURES, LEAST_STROKES, Span

WHAT = {
    "stroke_loss": "share of the stroke lost",
    "model_error": f"error of a model calibrated\non strokes 1 to {REFERENCE}",
}
NEGATIVE_LOOP = "below 0: at equal twist the string\nis shorter while it unwinds"
POINTS = (
    "Blue: each stroke as measured, ± 1 standard error. Green: the law fitted to it. Loop: the displacement while\n"
    "winding minus that while unwinding, at equal twist."
)
FUTURE = (
    f"Orange: {FUTURES:,} futures, which go on as the laws allow. Each counts by the highest value it has reached. A\n"
    "string that ends suddenly counts as above the limit from then on. The line: half of the futures lie above it."
)
BAR = (
    "Black bar: the strokes at which the limit is passed. {0} of the futures pass it before the bar begins, where the\n"
    "upper edge of the shade meets the limit; {0} pass it after the bar ends, where the lower edge does."
)
ARROW = (
    "Black arrow: it begins where {0} of the futures have passed the limit, at the upper edge of the shade, or where\n"
    "the forecast ends. It has no end of its own: the forecast does not look further than {1} strokes."
)


def tail_of(span: Span, level: float) -> float:
    """The share of the futures above the shade, and of those below it: the share that the claim leaves out."""
    return (1.0 - level) / (2.0 if span.state == "interval" else 1.0)


def footnote(answers: list[Answer], level: float) -> str:
    """What each line, shade, bar and arrow is, where any future is drawn."""
    drawn = [answer.left for answer in answers if answer.left.band is not None]
    if not drawn:
        return ""
    spans = [left.span(level) for left in drawn]
    lines = [POINTS, FUTURE]
    if any(span.state == "interval" for span in spans):
        lines.append(BAR.format(tail((1.0 - level) / 2.0)))
    if any(span.state != "interval" for span in spans):
        lines.append(ARROW.format(tail(1.0 - level), at_least(drawn[0].horizon)))
    return "\n".join(lines)


def no_claim(reason: str) -> str:
    """Why nothing is foretold, in a few words."""
    why = reason.split(":")[0]
    if "too few" not in why:
        return f"no claim: {why}"
    return f"no forecast yet: {' '.join(why.split()[:2])}, {LEAST_STROKES} needed"
