"""The strokes of each run of a string, and the runs that were re-zeroed, in words."""

from collections.abc import Collection, Sequence
from pathlib import Path

import pandas as pd

from ...ground.input.strict_yaml import read_yaml
from ...ground.words.counts import counted
from .shown_strokes import listed, ranges

NAMED = 8  # runs that a sentence names


def tared_runs(folders: Sequence[Path]) -> set[str]:
    """The runs in `raw/` whose run.yaml says `tare: run`; raises BadInput for one that is none."""
    files = [folder / "run.yaml" for folder in folders]
    return {path.parent.name for path in files if path.is_file() and (read_yaml(path) or {}).get("tare") == "run"}


def strokes_of_runs(own: pd.DataFrame, tared: Collection[str] | None) -> str:
    """A sentence on the strokes of each run of one string, by `run` and `stroke`; empty for one run.

    `tared` names the runs that were tared anew, None where that is not known.
    """
    numbers: dict[str, list[int]] = {}
    pairs = zip(own.index.get_level_values("run"), own.index.get_level_values("stroke"), strict=True)
    for run, stroke in sorted(pairs, key=lambda pair: int(pair[1])):
        numbers.setdefault(str(run), []).append(int(stroke))
    if len(numbers) < 2:
        return ""
    first, *later = numbers
    named = [f"{ranges(sorted(set(strokes)))} of {run}" for run, strokes in numbers.items()]
    more = f" and {counted(len(named) - NAMED, 'more run')}" if len(named) > NAMED else ""
    stand = f"Strokes {', '.join(named[:NAMED])}{more}"
    if tared is None:
        return f"{stand}."
    again = [run for run in later if run in tared]
    zero = f"no later run says `tare: run`, so all are tared as {first} is"
    if again:
        zero = f"the zero was set anew at {listed(again[:NAMED])} (`tare: run`)"
        zero += f" and {len(again) - NAMED} more" if len(again) > NAMED else ""
    return f"{stand}; {zero}."
