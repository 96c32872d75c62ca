"""The words on the noise where an error lies below it: then it is no least error, but an estimate that is too large."""

from collections.abc import Iterable, Sequence

BELOW = 0.9  # times the noise: an error below is no chance of many samples
LEAST = "noise: about the least possible"
ESTIMATED = "noise: an estimate, too large here"
REMARK = (
    "An error below the noise: the noise was estimated too large, or these samples have less of it. Read such an error "
    "as about the noise."
)


def is_below(columns: Iterable[tuple[Sequence[float | None], float]]) -> bool:
    """Whether an error of a column of the table lies below the noise of that column, both in the reading's unit."""
    return any(error is not None and error < BELOW * noise for errors, noise in columns for error in errors)
