"""What a recording covers: the loads that hung, how fast it moved, how long it stood, wound and at rest."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .record import PHASES, Record

ENDS = (1.0, 99.0)  # per cent of the samples: what is beyond is noise or a moment


def covered(record: Record) -> dict[str, Any]:
    """Lowest and highest load, slowest and fastest stroke, longest hold and rest; as `diagnosis.json` holds them.

    Loads in the load channel's unit, speeds in the motion's unit per second, times in s. `temperature_c`, where one was
    logged, is its lowest and highest in °C.
    """
    moving = np.isin(record.phase, [PHASES.index("winding"), PHASES.index("unwinding")])
    speeds = [
        float(np.median(np.abs(record.velocity[moving & (record.stroke == stroke)])))
        for stroke in np.unique(record.stroke[moving])
    ]
    logged = record.temperature_c
    warm = {} if logged is None else {"temperature_c": [float(end) for end in np.percentile(logged, ENDS)]}
    return warm | {
        "load": [float(end) for end in np.percentile(record.load, ENDS)],
        "speed_per_s": [min(speeds, default=0.0), max(speeds, default=0.0)],
        "longest_hold_s": longest(record, record.phase == PHASES.index("hold")),
        "longest_rest_s": longest(record, record.phase == PHASES.index("rest")),
    }


def longest(record: Record, inside: NDArray[np.bool_]) -> float:
    """The longest time without a break, in s, of the samples in a mask of shape (samples,); of one run at a time."""
    edges = np.flatnonzero(np.diff(inside.astype(int)) | (np.diff(record.run_index) != 0)) + 1
    parts = np.split(np.arange(len(inside)), edges)
    return max((float(np.ptp(record.time_s[part])) for part in parts if len(part) and inside[part[0]]), default=0.0)
