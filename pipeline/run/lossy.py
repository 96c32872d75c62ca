"""Strokes with lost samples in their movement, by the capture's account."""

import numpy as np
import pandas as pd

from ..ground.command import INSTALLED
from ..ground.errors import BadInput
from .capture_json import CaptureJson

LOSSES_LISTED = 1000  # capture.json lists no more: what comes after the last one may be touched too
MOVING = ("winding", "unwinding")


def touched(strokes: pd.DataFrame, info: CaptureJson) -> frozenset[int]:
    """The numbers of a run's strokes with samples missing in their movement, by its capture.json."""
    gaps = [*info.get("gaps", []), *info.get("holes", [])]
    after = np.array([gap["after_samples"] for gap in gaps], np.int64)
    moving = strokes[strokes["phase"].isin(MOVING) & (strokes["stroke"] > 0)]
    lossy = [
        int(stroke)
        for stroke, first, last in zip(moving["stroke"], moving["first_sample"], moving["last_sample"], strict=True)
        if ((first <= after) & (after <= last + 1)).any() or (len(gaps) >= LOSSES_LISTED and last >= after.max())
    ]
    return frozenset(lossy)


def moving_strokes(strokes: pd.DataFrame) -> frozenset[int]:
    """The numbers of a run's strokes in which anything moves."""
    return frozenset(strokes.loc[strokes["phase"].isin(MOVING) & (strokes["stroke"] > 0), "stroke"])


def all_lossy(run: str) -> BadInput:
    """The message for a run without any usable stroke."""
    configured = "" if INSTALLED else "set keep_lossy: true in the configuration, or "
    mend = f"record it again, leave it out, or keep these strokes: {configured}add --keep-lossy"
    return BadInput(run, "strokes", "samples are missing in every one", mend)
