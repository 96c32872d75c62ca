"""Percentiles of numbers that are too many to hold: exact, in a few passes over pieces of them.

The first pass counts how many numbers share their leading bits; each later one looks only at those that share the bits
of the number that is sought, until these few are sorted.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..kinematics import Array

HELD = 1 << 21  # numbers that are sorted in memory
DIGITS = (22, 21, 21)  # bits of a number that are looked at in each pass; together all 64
SIGN = np.uint64(1 << 63)
Pieces = Callable[[], Iterable[Array]]
Keys = NDArray[np.uint64]


@dataclass(frozen=True)
class _Target:
    """A target: the first number at which the weights add up to `rest`, among the keys that begin with `first`.

    So many bits of the keys are known that `shift` are left; `inside` numbers begin so.
    """

    rest: float
    first: int = 0
    shift: int = 64
    inside: int = 0


def _keys(values: Array) -> Keys:
    """Whole numbers in the order of finite numbers."""
    bits = (values + 0.0).view(np.uint64)  # +0.0 makes of -0.0 the 0 that it equals
    return np.where(bits & SIGN, ~bits, bits | SIGN)


def _number(key: int) -> float:
    """The number that a key stands for."""
    bits = np.uint64(key)
    return float(np.array([bits & ~SIGN if bits & SIGN else ~bits]).view(np.float64)[0])


def _begin(keys: Keys, target: _Target) -> NDArray[np.bool_] | slice:
    """Which keys have the beginning of a target."""
    return slice(None) if target.shift == 64 else keys >> np.uint64(target.shift) == target.first


def _narrowed(pieces: Pieces, targets: list[_Target], digit: int, weigh: bool) -> list[_Target]:
    """Targets with that many more known bits, after a pass."""
    shift, size = targets[0].shift - digit, 1 << digit
    places = {target.first: target for target in targets}
    count = {first: np.zeros(size, np.int64) for first in places}
    weight = {first: np.zeros(size if weigh else 0) for first in places}
    for piece in pieces():
        keys = _keys(piece)
        for first, target in places.items():
            begin = _begin(keys, target)
            place = (keys[begin] >> np.uint64(shift) & np.uint64(size - 1)).astype(np.int64)
            count[first] += np.bincount(place, minlength=size)
            if weigh:
                weight[first] += np.bincount(place, piece[begin], size)
    narrowed = []
    for target in targets:
        sums = np.cumsum(weight[target.first] if weigh else count[target.first])
        at = min(int(np.searchsorted(sums, target.rest)), int(np.flatnonzero(count[target.first])[-1]))
        before = sums[at - 1] if at else 0
        narrowed.append(_Target(target.rest - before, target.first << digit | at, shift, int(count[target.first][at])))
    return narrowed


def _found(pieces: Pieces, targets: list[_Target], weigh: bool) -> list[float]:
    """The numbers sought, by sorting those with the right beginnings."""
    places = {target.first: target for target in targets}
    parts_by_first: dict[int, list[Array]] = {first: [] for first in places}
    for piece in pieces():
        keys = _keys(piece) if targets[0].shift < 64 else np.zeros(0, np.uint64)
        for first, target in places.items():
            parts_by_first[first].append(piece[_begin(keys, target)])
    numbers = []
    orders = {first: np.sort(np.concatenate(parts)) for first, parts in parts_by_first.items()}
    for target in targets:
        order = orders[target.first]
        at = np.searchsorted(np.cumsum(order), target.rest) if weigh else round(target.rest) - 1
        numbers.append(float(order[min(int(at), len(order) - 1)]))
    return numbers


def _sought(pieces: Pieces, targets: list[_Target], weigh: bool = False) -> list[float]:
    """The numbers of some targets, in as many passes as they need."""
    for digit in DIGITS:
        if sum({target.first: target.inside for target in targets}.values()) <= HELD:
            return _found(pieces, targets, weigh)
        targets = _narrowed(pieces, targets, digit, weigh)
    return [_number(target.first) for target in targets]


def ordered(pieces: Pieces, count: int, ranks: Sequence[int]) -> list[float]:
    """The numbers at some ranks, from 0, among `count` finite numbers in order."""
    return _sought(pieces, [_Target(rank + 1, inside=count) for rank in ranks])


def percentiles(pieces: Pieces, count: int, q: Sequence[float]) -> Array:
    """Percentiles `q` of `count` finite numbers, between two of them by their distance, as numpy's are.

    Shape (q,), in the numbers' unit.
    """
    if count <= HELD:
        return np.asarray(np.percentile(np.concatenate(list(pieces())), q))
    place = (count - 1) * (np.array(q) / 100.0)
    ranks = [min(max(int(np.floor(rank)) + step, 0), count - 1) for rank in place for step in (0, 1)]
    low, high = np.array(ordered(pieces, count, ranks)).reshape(-1, 2).T
    share, apart = place - np.floor(place), high - low
    return np.asarray(np.where(share >= 0.5, high - apart * (1.0 - share), low + apart * share))


def median(pieces: Pieces, count: int) -> float:
    """Median of `count` finite numbers."""
    if count <= HELD:
        return float(np.median(np.concatenate(list(pieces()))))
    low, high = ordered(pieces, count, [(count - 1) // 2, count // 2])
    return (low + high) / 2.0


def half_of_sum(pieces: Pieces, count: int) -> float:
    """The first of `count` numbers from 0 up, in order, at which they add up to half of their sum."""
    total = 0.0
    if count <= HELD:
        order = np.sort(np.concatenate(list(pieces())))
        sums = np.cumsum(order)
        return float(order[np.searchsorted(sums, sums[-1] / 2)])
    for piece in pieces():
        total += float(piece.sum())
    return _sought(pieces, [_Target(total / 2, inside=count)], weigh=True)[0] if total else 0.0
