"""How far each two explanations that tie are apart, without a run and with it."""

from collections.abc import Sequence

from ..document.expected import Pair

Gap = tuple[float, tuple[str, ...], tuple[str, ...]]  # misfit that the second leaves of what the first makes


def closest(gaps: Sequence[Gap]) -> Gap:
    """The smallest gap, and which two explanations it is between."""
    return min(gaps, key=lambda gap: gap[0])


def pairs(now: Sequence[Gap], then: Sequence[Gap]) -> list[Pair]:
    """Each two explanations that were compared, with the smaller gap of both ways round: now, and with the run."""
    entries: dict[frozenset[tuple[str, ...]], Pair] = {}
    for (before, ids, other), (after, *_) in zip(now, then, strict=True):
        entry = entries.setdefault(
            frozenset((ids, other)), {"ids": [list(ids), list(other)], "gap_now": before, "gap_then": after}
        )
        entry["gap_now"], entry["gap_then"] = min(entry["gap_now"], before), min(entry["gap_then"], after)
    return list(entries.values())
