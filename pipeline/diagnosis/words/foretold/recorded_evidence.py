"""The explanations that the recorded loop already excludes, so that nobody needs to wait for the next stroke."""

from ...document.content import Verdict
from ...document.expected import ExpectedExplanation
from ..language.quantity import listing, plus_minus, size
from ..language.vocabulary import Vocabulary
from .foretold_numbers import Number, apart, compared, of_explanation, tells

LOOP = "loop_as_before"


def excluded(content: Verdict, words: Vocabulary) -> list[ExpectedExplanation]:
    """The rivals whose loop differs from the recorded one beyond both intervals, while the best one's does not."""
    shown, explanations = recorded(content, words), compared(content)
    if shown is None or not explanations:
        return []
    first, *others = explanations
    own = _loop(first, content, words)
    if own is None or abs(own.value - shown) > own.half_width:
        return []
    cells = [_loop(other, content, words) for other in others]
    measured = Number(shown, own.half_width, own.known)
    return [
        other for other, cell in zip(others, cells, strict=True) if cell and (tells([cell, measured]) or 0.0) >= 1.0
    ]


def recorded(content: Verdict, words: Vocabulary) -> float | None:
    """The loop that the recording shows, in the unit of the reading; None where it shows none, or an older file."""
    expected = content["evidence"].get("expected") or {}
    shown = expected.get("recorded", {}).get(f"loop_{words.ending}")
    return None if shown is None else float(shown)


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """That the recording shows a loop that some rivals do not make; nothing where it excludes none."""
    out, shown = excluded(content, words), recorded(content, words)
    if not out or shown is None:
        return []
    first = compared(content)[0]
    own = _cell(first, content, words)
    names = [f"{apart(first, other)[1]} alone ({_cell(other, content, words)})" for other in out]
    return [
        f"This recording itself shows a loop of {size(shown, words.unit)}. {apart(first, out[0])[0]} makes it ({own}); "
        f"{listing(names)} {'do' if len(names) > 1 else 'does'} not, so the loop excludes that already."
    ]


def _loop(explanation: ExpectedExplanation, content: Verdict, words: Vocabulary) -> Number | None:
    """The loop of an explanation in the recorded strokes, with the accuracy of its loop in the next stroke."""
    ahead, loops = of_explanation(explanation, LOOP, content, words), explanation.get("recorded", {})
    value = loops.get(f"loop_{words.ending}")
    return None if ahead is None or value is None else Number(float(value), ahead.half_width, ahead.known)


def _cell(explanation: ExpectedExplanation, content: Verdict, words: Vocabulary) -> str:
    cell = _loop(explanation, content, words)
    return plus_minus(abs(cell.value), cell.half_width, words.unit) if cell else ""
