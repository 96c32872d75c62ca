"""Spans of a long series, each from a first place to a last one that is left out: joined, cut, reduced in blocks."""

from collections.abc import Callable, Iterable

import numpy as np
from numpy.typing import NDArray

from ..kinematics import Array, Places

Spans = NDArray[np.intp]  # shape (spans, 2), rising, none of them empty
Read = Callable[[int, int], Array]  # values of a series from a first place until one that is left out


def blocks(first: int, stop: int, length: int) -> list[tuple[int, int]]:
    """The range from `first` until `stop`, cut into blocks of a length."""
    return [(at, min(at + length, stop)) for at in range(first, stop, length)]


def of_mask(mask: NDArray[np.bool_], first: int = 0) -> Spans:
    """Spans of every stretch of True in a mask that stands at `first`; indices of shape (spans, 2)."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]])))
    return (edges + first).reshape(-1, 2)


def joined(parts: Iterable[Spans]) -> Spans:
    """Spans of all parts in order, those that touch as one; shape (spans, 2), as places."""
    every = np.concatenate([np.zeros((0, 2), np.intp), *parts])
    every = every[np.argsort(every[:, 0], kind="stable")]
    apart = np.flatnonzero(every[1:, 0] > every[:-1, 1])
    if not len(every):
        return every
    return np.column_stack([every[np.append(0, apart + 1), 0], every[np.append(apart, len(every) - 1), 1]])


def between(spans: Spans, length: int) -> Spans:
    """The parts of a series of a length that lie in none of the spans; shape (spans, 2), as places."""
    edges = np.concatenate([[0], spans.ravel(), [length]]).reshape(-1, 2)
    return edges[edges[:, 1] > edges[:, 0]]


def cut(spans: Spans, places: Places) -> Spans:
    """The spans, cut at the places that lie inside one; shape (spans, 2), as places."""
    at = np.searchsorted(spans[:, 0], places, side="right") - 1
    inside = places[(at >= 0) & (places > spans[at, 0]) & (places < spans[at, 1])] if len(spans) else places[:0]
    return np.column_stack([np.sort(np.concatenate([spans[:, end], inside])) for end in (0, 1)])


def reduced(read: Read, spans: Spans, length: int, by: np.ufunc, start: float) -> Array:
    """Values of each span taken together by np.add, np.minimum or np.maximum from `start`; (spans,), in their unit.

    They are read in blocks of a length, whatever the spans'.
    """
    results = np.full(len(spans), start)
    if not len(spans):
        return results
    for first, stop in blocks(int(spans[0, 0]), int(spans[-1, 1]), length):
        begin, end = np.searchsorted(spans[:, 1], first, side="right"), np.searchsorted(spans[:, 0], stop)
        if begin >= end:
            continue
        edges = (np.clip(spans[begin:end], first, stop) - first).ravel()
        values = read(first, stop)
        edges = edges[:-1] if edges[-1] == len(values) else edges
        results[begin:end] = by(results[begin:end], by.reduceat(values, edges)[::2])
    return results
