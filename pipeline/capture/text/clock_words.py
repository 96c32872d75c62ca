"""Printed times that stand or fall back: they are mended on reading, or the run is refused."""

import io
from contextlib import redirect_stderr
from pathlib import Path

from ...ground.words.counts import mends
from ...run.capture_json import CaptureJson
from ...run.description import Run


def tell_clock(run: Run, folder: Path, info: CaptureJson) -> None:
    """Say how the time of printed lines is mended; raises BadInput where it cannot be."""
    if not info["lines"]["time_backward"]:
        return
    from ...run.table.recorded_table import printed_samples  # it needs pandas, for which no rig should wait

    with redirect_stderr(io.StringIO()):  # which column is read as what is said when the run is used
        mended = printed_samples(run, folder).counted
    if mended:
        print(f"{folder}: its clock gave {' and '.join(mends(mended))}, mended when the run is read")
