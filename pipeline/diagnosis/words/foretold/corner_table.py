"""The answer of a planned motion where it turns or stops, as a table that a person reads at a glance."""

import numpy as np
import pandas as pd

from ..language.quantity import percent, to_the_band
from ..language.text_table import aligned
from .prediction import OUTSIDE

BEND, CORNERS = 1e-3, 16  # of the highest speed: what changes it by more is a corner; of so many no table is printed
INSIDE = "inside"


def corners(table: pd.DataFrame, driver: str, channel: str) -> list[str]:
    """The answer at each turn or stop of a drawn plan, a line each; for many corners only their number.

    `driver` and `channel` are the columns of motion and reading; those of the band and the others go by their names,
    and may lack.
    """
    ending = channel.rpartition("_")[2]
    low, high, bare = f"low_{ending}", f"high_{ending}", f"without_effects_{ending}"
    slope = np.diff(table[driver].to_numpy()) / np.diff(table["time_s"].to_numpy())
    bend = np.abs(np.diff(slope)) > BEND * max(float(np.abs(slope).max(initial=0.0)), 1e-12)
    leaves = _leaves(table)
    places = [0, *(np.flatnonzero(bend) + 1).tolist(), len(table) - 1]
    if len(places) > CORNERS:
        return [f"the plan turns or stops {len(places)} times, too often for a table: the file has each row", *leaves]
    out = table[OUTSIDE].to_numpy() == 1.0 if OUTSIDE in table else None
    shown = [name for name in (bare,) if name in table]
    rows = [
        ["time_s", driver, channel, *shown, "nine of ten readings", *(["the way there"] if out is not None else [])]
    ]
    whole = 0.5 * float((table[high] - table[low]).max()) if low in table else np.nan  # the widest band gives decimals
    for before, place in zip([0, *places], places, strict=False):
        row = table.iloc[place]
        within = low in table and bool(np.isfinite(row[[low, high]].to_numpy(float)).all())
        way = _way(out[before : place + 1]) if out is not None and place else ""
        none = "no band" if out is None or not out[place] else f"{OUTSIDE} from here on" if way == INSIDE else OUTSIDE
        cells = [f"{row['time_s']:.4g}", f"{row[driver]:.4g}"]
        cells += [to_the_band(float(row[name]), whole) for name in (channel, *shown)]
        cells.append(f"{to_the_band(row[low], whole)} to {to_the_band(row[high], whole)}" if within else none)
        if out is not None:
            cells.append(way)
        rows.append(cells)
    return [*aligned(rows), *leaves]


def _leaves(table: pd.DataFrame) -> list[str]:
    """The time when a plan first leaves the recorded range; nothing where it never does."""
    if OUTSIDE not in table or not table[OUTSIDE].any():
        return []
    first = int(table[OUTSIDE].to_numpy().argmax())
    return [f"the plan first leaves what was recorded at {table['time_s'].iloc[first]:.4g} s"]


def _way(out: np.ndarray) -> str:
    """How much of a way is outside; `out`, of shape (samples,), is a mask over its rows from corner to corner."""
    share = float(out[1:-1].mean()) if len(out) > 2 else float(out.mean())
    return OUTSIDE if share == 1.0 else f"{percent(share)} {OUTSIDE}" if share else INSIDE
