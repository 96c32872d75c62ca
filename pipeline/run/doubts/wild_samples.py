"""Single samples that no rig can have read: their neighbours show it; they do not count, and a sentence tells them."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from scipy.ndimage import median_filter

from ...ground.errors import BadInput
from ...ground.kinematics import Array, Places
from ...ground.numbers import quantiles
from ...ground.stored.rows import Rows
from ...ground.words.counts import are, counted
from ..description import Run
from ..table.file_lines import Where, by_row

BESIDE = 5  # neighbours on either side, by whose median a sample is judged
RANGES = 3.0  # of the channel's whole range: a sample further from its neighbours was never measured
INSIDE = (0.5, 99.5)  # percentiles of that range
MOST = 0.01  # of a recording's samples, and one in any case: what is wild more often is no accident
LEAST_LOAD = 1.0  # in the load's unit: noise about a load of 0 is no range


def _beside(values: Rows, name: str, first: int, stop: int) -> Array:
    """The value that the neighbours of samples `first` until `stop` suggest, in its unit; shape (stop - first,)."""
    others = np.ones(2 * BESIDE + 1, bool)
    others[BESIDE] = False
    begin = max(first - BESIDE, 0)
    about = values.read(name, begin, min(stop + BESIDE, len(values)))
    return np.asarray(median_filter(about, footprint=others, mode="mirror")[first - begin : stop - begin])


def _wild(samples: Rows, name: str, is_load: bool) -> Places:
    """Samples whose value stands alone and impossibly far; shape (wild samples,)."""

    def pieces() -> Iterator[Array]:
        return (_beside(samples, name, *span) for span in samples.spans)

    with np.errstate(over="ignore", invalid="ignore"):
        low, high = quantiles.percentiles(pieces, len(samples), INSIDE)
        size = quantiles.median(lambda: map(np.abs, pieces()), len(samples))
        reach = max(high - low, size, LEAST_LOAD) if is_load else (high - low) or size or 1.0
        places = [
            first + np.flatnonzero(np.abs(samples.read(name, first, stop) - beside) > RANGES * reach)
            for (first, stop), beside in zip(samples.spans, pieces(), strict=True)
        ]
    return np.concatenate(places)


def wild_samples(run: Run, samples: Rows, path: Path, where: Where = by_row) -> tuple[Places, list[str]]:
    """Rows of finite samples that motion, reading or load make impossible, rising; and a sentence for each channel.

    The rows are given as places, shape (rows,).

    An ordinary outlier stays: a sample goes only where its value is further from its neighbours' median than three
    times the channel's whole range (of a load: or its size). `where` a row stands in `path` is said. Raises BadInput
    where that is over 1 % of all samples.
    """
    gone, warnings = np.zeros(0, np.intp), []
    for name in (run.system.driver, run.system.channel, run.system.load):
        if name is None or name not in samples.columns:
            continue
        wild = _wild(samples, name, name == run.system.load)
        if not len(wild):
            continue
        row, count = int(wild[0]), len(wild)
        value, beside = samples.read(name, row, row + 1)[0], _beside(samples, name, row, row + 1)[0]
        reads = f"{name} reads {value:.3g} in {where(row)}, where its neighbours read {beside:.3g}"
        gone = np.union1d(gone, wild)
        if len(gone) > max(1, MOST * len(samples)):
            problem = f"{len(gone)} of {len(samples)} samples {are(len(gone))} impossible, over 1 %: {reads}"
            raise BadInput(
                path, name, problem, "check the sensor and its cable, then remove these rows or record again"
            )
        keeps = f"will not count; the recording keeps {'them' if count > 1 else 'it'}"
        warnings.append(f"{path}: {counted(count, 'sample')} {keeps}: {reads}")
    return gone, warnings
