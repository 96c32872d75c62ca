"""Samples of a recording in the order of their numbers, from pieces in which some samples came late."""

from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from .counters import Whole

Part = tuple[Whole, NDArray[np.void]]  # numbers of frames, rising, and what they hold; each (samples,)


def in_order(parts: Iterable[Part], firsts: Whole, sent: int) -> Iterator[Part]:
    """Samples with numbers below `sent`, rising from part to part; `firsts` has the first number of each given part.

    `firsts` has the shape (parts,), as counts.

    A sample is held until no part is to come that has one before it: memory goes by how late a sample came.
    """
    least = np.minimum.accumulate(np.append(firsts, sent)[::-1])[::-1][1:]  # after each part
    waiting: list[Part] = []
    for part, later in zip(parts, least.tolist(), strict=True):
        if part[0][0] >= sent:
            continue
        waiting.append(part)
        if min(numbers[0] for numbers, _ in waiting) >= later:
            continue
        numbers, samples = joined(waiting)
        order = np.argsort(numbers, kind="stable")
        numbers, samples = numbers[order], samples[order]
        stop = int(np.searchsorted(numbers, later))
        yield numbers[:stop], samples[:stop]
        waiting = [(numbers[stop:], samples[stop:])] if stop < len(numbers) else []


def joined(parts: list[Part]) -> Part:
    """One part of several."""
    if len(parts) == 1:
        return parts[0]
    numbers, samples = zip(*parts, strict=True)
    return np.concatenate(numbers), np.concatenate(samples)
