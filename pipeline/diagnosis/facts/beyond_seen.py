"""Loads and motions of the held-out strokes that no stroke before them reached."""

import numpy as np

from ...ground.kinematics import Array
from ..recording.working_samples import Record

ENDS = (5.0, 95.0)  # percentiles of the samples: values beyond are noise or last a moment
FARTHER = 0.1  # of the largest seen: a smaller excess counts as equal


def beyond_seen(record: Record, until_s: float) -> dict[str, list[list[float]]]:
    """Ranges before and after `until_s`, by `load` and `motion`, where the later one is wider.

    In the units of the record's load and motion; empty where the later strokes stay within what was seen.
    """
    unseen = record.time_s >= until_s
    ranges = {}
    for name, values in (("load", record.load), ("motion", record.motion)):
        seen, later = _range(values[~unseen]), _range(values[unseen])
        reach = FARTHER * max(map(abs, seen))
        if later[1] > seen[1] + reach or later[0] < seen[0] - reach:
            ranges[name] = [seen, later]
    return ranges


def _range(values: Array) -> list[float]:
    return [float(end) for end in np.percentile(values, ENDS)]
