"""Least squares between bounds, compiled: one problem, a part of a large one, and many parts one after the other.

Source: Stark and Parker, "Bounded-variable least squares: an algorithm and applications",
Computational Statistics 10 (1995).
"""

import numpy as np
from numba import njit
from numpy.typing import NDArray

from ...ground.kinematics import Array


@njit(cache=True)
def boxed(gram: Array, moment: Array, low: Array, high: Array, start: Array) -> Array:
    """Least ½βᵀGβ − hᵀβ with low ≤ β ≤ high: active set (bounded-variable least squares), for small problems.

    G of shape (k, k); h, bounds, `start` and the answer of shape (k,), in the units of the coefficients β.
    """
    k = moment.size
    x = np.minimum(np.maximum(start, low), high)
    scale = np.sqrt(np.maximum(np.diag(gram), 1e-300))
    free = (x > low) & (x < high)
    barred = np.zeros(k, np.bool_)
    for _ in range(6 * k + 20):
        # inner: solve on the free set, walking back to the first bound that is met
        for _inner in range(3 * k + 5):
            index = np.flatnonzero(free)
            if index.size == 0:
                break
            m = index.size
            a = np.empty((m, m))
            r = np.empty(m)
            for p in range(m):
                r[p] = moment[index[p]] / scale[index[p]]
                for q in range(k):
                    if not free[q]:
                        r[p] -= gram[index[p], q] * x[q] / scale[index[p]]
                for q in range(m):
                    a[p, q] = gram[index[p], index[q]] / (scale[index[p]] * scale[index[q]])
                a[p, p] += 1e-9
            solution = np.linalg.solve(a, r)
            step, hit = 1.0, -1
            for p in range(m):
                j = index[p]
                target = solution[p] / scale[j]
                if target < low[j] or target > high[j]:
                    bound = low[j] if target < low[j] else high[j]
                    move = target - x[j]
                    share = (bound - x[j]) / move if move != 0.0 else 0.0
                    if share < step:
                        step, hit = max(share, 0.0), j
            for p in range(m):
                j = index[p]
                x[j] += step * (solution[p] / scale[j] - x[j])
            if hit < 0:
                break
            x[hit] = low[hit] if abs(x[hit] - low[hit]) <= abs(x[hit] - high[hit]) else high[hit]
            free[hit] = False
            if step == 0.0:
                barred[hit] = True
        # outer: free the bound variable whose gradient points inside most
        best, chosen = 1e-7 * (1.0 + np.max(np.abs(moment / scale))), -1
        for j in range(k):
            if free[j] or barred[j] or low[j] == high[j]:
                continue
            slope = moment[j]
            for q in range(k):
                slope -= gram[j, q] * x[q]
            slope /= scale[j]
            if x[j] >= high[j]:
                slope = -slope
            if slope > best:
                best, chosen = slope, j
        if chosen < 0:
            break
        free[chosen] = True
    return x


@njit(cache=True)
def fitted(
    gram: Array, moment: Array, columns: NDArray[np.intp], low: Array, high: Array, start: Array
) -> tuple[Array, float]:
    """Bounded solution on some columns of a large problem, and its misfit less the target's square.

    `gram` of shape (n, n), `moment` of shape (n,); `columns`, the bounds, `start` and the solution of shape (k,).

    Coefficients in their columns' units, `columns` as places among n; the misfit in the target's unit squared.
    """
    k = columns.size
    part, side = np.empty((k, k)), np.empty(k)
    for p in range(k):
        side[p] = moment[columns[p]]
        for q in range(k):
            part[p, q] = gram[columns[p], columns[q]]
    solution = boxed(part, side, low, high, start)
    misfit = 0.0
    for p in range(k):
        misfit -= 2.0 * side[p] * solution[p]
        for q in range(k):
            misfit += solution[p] * part[p, q] * solution[q]
    return solution, misfit


@njit(cache=True)
def scan(
    gram: Array,
    moment: Array,
    chosen: NDArray[np.intp],
    starts: NDArray[np.intp],
    counts: NDArray[np.intp],
    low: Array,
    high: Array,
    start: Array,
    calibrated: int,
) -> tuple[Array, NDArray[np.intp]]:
    """Misfit (less the target's square) and active columns of fits on given columns and each of several blocks.

    `gram` of shape (n, n), `moment`, the bounds and `start` of shape (n,), `starts` and `counts` of shape (blocks,), as
    both answers. Coefficients in their columns' units, misfits in the target's unit squared, the rest as counts.
    """
    misfit, active = np.empty(starts.size), np.empty(starts.size, np.intp)
    for block in range(starts.size):
        columns = np.concatenate((chosen, starts[block] + np.arange(counts[block])))
        solution, misfit[block] = fitted(gram, moment, columns, low[columns], high[columns], start[columns])
        active[block] = 0
        for p in range(calibrated, columns.size):
            if np.abs(solution[p]) * np.sqrt(gram[columns[p], columns[p]]) > 1.0:
                active[block] += 1
    return misfit, active
