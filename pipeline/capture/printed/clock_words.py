"""The printed time: which column run.yaml says that it is, and what becomes of one that stands or falls back."""

import io
from contextlib import redirect_stderr
from pathlib import Path

from ...ground.errors import BadInput
from ...ground.words.counts import mends
from ...run.capture_json import CaptureJson
from ...run.description import Channel, Run
from ...run.folder import read_run


def clock_in(folder: Path) -> str | int | None:
    """The column that the run in a folder reads as its time, by name or index; None where no run.yaml says it."""
    try:
        run = read_run(folder)
    except BadInput:
        return None
    return run.channels.get("time_s", Channel.model_validate({})).column


def tell_clock(run: Run, folder: Path, info: CaptureJson) -> None:
    """Say how the time of printed lines is mended; raises BadInput where it cannot be."""
    if not info["lines"]["time_backward"]:
        return
    from ...run.table.recorded_table import printed_samples  # it needs pandas, for which no rig should wait

    with redirect_stderr(io.StringIO()):  # which column is read as what is said when the run is used
        mended = printed_samples(run, folder).counted
    if mended:
        print(f"{folder}: its clock gave {' and '.join(mends(mended))}, mended when the run is read")
