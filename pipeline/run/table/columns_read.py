"""Which column of a recording was read as what, for a person to see: a wrong unit or column shows there."""

from pathlib import Path

import numpy as np
import pandas as pd

from ...ground.complaint import key_name
from ...ground.counts import counted
from ..description import Run


def read_as(run: Run, samples: pd.DataFrame, path: Path, recorded: int | None = None) -> str:
    """How many samples, and a line each channel with its column, its unit there, and its range in our units.

    `samples` are the table with a column a channel, as `to_samples` gives it; where those that no rig can
    have read are not among them, `recorded` says how many there were.
    """
    sentences = []
    for name in samples.columns:
        channel = run.channels.get(name)
        column = key_name(channel.column) if channel and channel.column is not None else name
        parts = [f"from {column}"] if column != name else []
        parts += [f"in {channel.unit}"] if channel and channel.unit else []
        whence = f" ({' '.join(parts)})" if parts else ""
        sentences.append(f"{name} {samples[name].min():.4g} to {samples[name].max():.4g}{whence}")
    if has_no_load(run) and not np.any(samples.get("load_n", 0.0)):
        sentences.append("no load: taken as 0 N; if one hangs, name its column as load_n, or write rig.load_n")
    count = len(samples) if recorded is None else recorded
    wild = f", of which {count - len(samples)} will not count (see the warning)" if count > len(samples) else ""
    return "\n  ".join([f"{path.name} has {counted(count, 'sample')}{wild}. They are read as:", *sentences])


def has_no_load(run: Run) -> bool:
    """Whether a run of a string says nowhere which load hangs on it, other than by a column load_n."""
    return run.system.load == "load_n" and "load_n" not in run.channels and not run.rig.get("load_n")
