"""Explanations that are likely enough to be kept but are no names, in words: which, how likely, and by which rule."""

from ...choice.recalibration import DIMENSIONS, IDLE, OUTSIDE
from ...document.content import Verdict
from ...document.explanations import LeftOut, share_of
from ..language.quantity import listing, percent

WORTH = 0.01  # a probability from which on one is worth a word
BECAUSE = {
    DIMENSIONS: "what {of} would do here, moved dimensions do as well but for a thousandth of it, so this recording "
    "cannot tell it from dimensions that were measured wrong",
    OUTSIDE: "what this recording would show of {of} is only a shift or a straight line, as moved dimensions make",
    IDLE: "once everything is fitted together, no effect of the library is left in it",
    "cancels": "its effects are far larger than what they do together: they cancel each other",
}


def entries(content: Verdict) -> list[LeftOut]:
    """The explanations that are left out and worth a mention, the likeliest first."""
    out = [entry for entry in content["evidence"].get("left_out", []) if share_of(entry) >= WORTH]
    return sorted(out, key=lambda entry: -share_of(entry))


def together(content: Verdict) -> float:
    """The joint probability of the explanations that are left out."""
    return float(sum(share_of(entry) for entry in content["evidence"].get("left_out", [])))


def likelier(content: Verdict, share: float | None) -> bool:
    """Whether an explanation that is left out is more probable than the best one's `share`."""
    return share is not None and any(share_of(entry) > share for entry in entries(content))


def reason(entry: LeftOut) -> str:
    """Why an explanation is left out, without a full stop."""
    return BECAUSE[entry["because"]].format(of=listing(entry["of"]))


def reason_of(content: Verdict, ids: list[str]) -> str:
    """Why an explanation is left out, as a sentence; nothing where it is not."""
    entry = next((entry for entry in content["evidence"].get("left_out", []) if entry["ids"] == ids), None)
    return f"It is left out: {reason(entry)}." if entry else ""


def lines(content: Verdict) -> list[str]:
    """A sentence for each reason, with the explanations that it leaves out."""
    names_by_reason: dict[str, list[str]] = {}
    for entry in entries(content):
        names_by_reason.setdefault(reason(entry), []).append(f"{' + '.join(entry['ids'])} ({percent(share_of(entry))})")
    return [
        f"Left out, however probable: {listing(names)}. The reason: {why}." for why, names in names_by_reason.items()
    ]
