"""Conditions that changed together among the recorded strings: what each of them does no fit can tell.

Where the thin string was under the low load alone, and the thick one under the high load alone, a fit shares out what
differs between them as it likes. A condition is told apart where recordings differ in it alone, or but for conditions
that are told apart already: a string under two loads tells the load apart. So is one that the others hardly follow, as
in a campaign of many strings that differ in everything. A stiffness follows the radius, and no recording parts the two.

Source: Belsley, Kuh and Welsch, Regression Diagnostics, 1980 (columns of a fit that others nearly follow).
"""

import numpy as np
import pandas as pd

from ....ground.kinematics import Array
from ....ground.units import unit_of
from ....ground.words.counts import listing
from ..conditions import Conditions
from .beyond_range import WORDS
from .recorded_strokes import LOAD

CONDITIONS = ("radius_mm", "length_mm", "separator_mm", "torsion_zone_mm", LOAD)  # in the order in which they are named
SAME = 0.05  # of a condition's range: values as near as that are one, as the room of a load is
FOLLOWED = 0.9  # of a condition's variance that the others explain: it cannot be told from them


def changed_together(points: pd.DataFrame) -> str:
    """Which conditions changed together among recorded points, and the recordings that tell them apart, in words.

    Empty where each is told apart. The points have the columns of `schemas.DATASET`.
    """
    levels = _levels(points)
    names = _together(levels)
    if not names:
        return ""
    ordered = levels.sort_values(names[0], kind="stable")
    least, most = ordered.iloc[0], ordered.iloc[-1]
    ends = ", ".join(f"{listing([_amount(end, name) for name in names])} of {end.name}" for end in (least, most))
    mends = [f"string {least.name} under {most[name]:.3g} N too" for name in names if name == LOAD]
    sizes = [WORDS[name] for name in names if name != LOAD]
    mends += [f"a string that differs from {least.name} in {size} alone" for size in sizes[:-1]]
    return (
        f"among the recorded strings {listing([WORDS[name] for name in names])} changed together ({ends}), so their "
        f"effects cannot be told apart and the answer may be far off: record {listing(mends)}"
    )


def _amount(level: pd.Series, name: str) -> str:
    """The value of a condition with its unit."""
    return f"{level[name]:.3g} {unit_of(name)}"


def _levels(points: pd.DataFrame) -> pd.DataFrame:
    """The recorded values of all conditions that vary, a row each time they differ; the index is the string's name."""
    names = list(Conditions.of(points, CONDITIONS).names)
    rows, strings = [], []
    least_gap_n = SAME * float(np.ptp(points[LOAD].to_numpy(float)))
    for string, own in points.groupby(points["string"].astype(str), sort=True):
        loads_n = np.unique(own[LOAD].to_numpy(float))
        groups = np.split(loads_n, 1 + np.flatnonzero(np.diff(loads_n) > least_gap_n))
        ends = [[group[0], group[-1]] if np.ptp(group) > 2.0 * least_gap_n else [group.mean()] for group in groups]
        for load_n in np.concatenate(ends):
            rows.append({**own.iloc[0][names], LOAD: load_n})
            strings.append(str(string))
    return pd.DataFrame(rows, index=strings)[names].astype(float)


def _together(levels: pd.DataFrame) -> list[str]:
    """The conditions that no recording tells apart; none, or two and more."""
    unknown = list(levels.columns)
    scaled = ((levels - levels.min()) / (levels.max() - levels.min())).fillna(0.0)
    differs = {name: np.abs(np.subtract.outer(*[scaled[name].to_numpy()] * 2)) > SAME for name in unknown}
    while True:
        in_how_many = np.sum([differs[name] for name in unknown], axis=0) if unknown else np.zeros((1, 1))
        apart = [name for name in unknown if (differs[name] & (in_how_many == 1)).any()]
        if not apart:
            break
        unknown = [name for name in unknown if name not in apart]
    return [name for name in unknown if _share(scaled[name].to_numpy(), scaled[unknown].drop(columns=name)) > FOLLOWED]


def _share(values: Array, others: pd.DataFrame) -> float:
    """The share of the variance of values, of shape (levels,), that other columns explain; all without unit."""
    table = np.column_stack([np.ones(len(others)), others.to_numpy(float)])
    rest = values - table @ np.linalg.lstsq(table, values, rcond=None)[0]
    return 1.0 - float(np.var(rest) / np.var(values))
