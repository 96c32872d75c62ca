"""Whether samples before an early end can be used, by one reading of the run for all who report on it."""

import io
from contextlib import redirect_stderr
from functools import cache
from pathlib import Path

import numpy as np

from ..ground.errors import BadInput
from ..ground.numbers.unwound import HOME
from ..ground.words.counts import counted
from ..string.from_raw import read
from ..string.history import Recorded
from ..string.jumps_beside import Reader


def once(folder: Path) -> Reader:
    """A reader of runs that reads and cuts the run in `folder` once, refused or not; it stores no other run."""

    @cache
    def own() -> Recorded | BadInput:
        try:
            return read(folder)
        except BadInput as error:
            return error

    def reader(place: Path) -> Recorded:
        if place != folder:
            return read(place)
        outcome = own()
        if isinstance(outcome, BadInput):
            raise outcome
        return outcome

    return reader


def strokes_of_use(folder: Path, reader: Reader, ends: str = "") -> int:
    """Say what of a run that a fault ended can be used, and how the program `ends`; the number of its strokes.

    Raises BadInput if it cannot be used.
    """
    with redirect_stderr(io.StringIO()):  # what is read as what is said when the run is used
        recorded = reader(folder)
    count = int(recorded.strokes["stroke"].max())
    kept = f"{counted(len(recorded.table), 'sample')} in {counted(count, 'stroke')}"
    print(f"{folder}: what came before the fault can be used: {kept}{ends}")
    return count


def strokes_unwound(folder: Path, reader: Reader) -> int:
    """How many strokes of a run that ended on request unwound; raises BadInput where the run cannot be used."""
    with redirect_stderr(io.StringIO()):
        strokes = reader(folder).strokes
    unwound = set(strokes.loc[strokes["complete"] & (strokes["stroke"] > 0), "stroke"])
    turns, last = strokes[["start_turns", "end_turns"]].to_numpy(), strokes.iloc[-1]
    if last["phase"] == "unwinding" and last["end_turns"] > turns.min() + HOME * np.ptp(turns):
        unwound.discard(last["stroke"])  # it was cut off
    return len(unwound)
