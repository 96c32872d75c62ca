"""Which loads were recorded around which size of a string: a load that only another string was under was not.

The recorded pairs of a size and the load count, with all that lies between them, their convex hull, and with the room
that each range has, as those of a condition and the twist do (`recorded_pairs.py`).
"""

import pandas as pd

from ..box import SIZES, room
from ..conditions import Conditions
from .assumed_stiffness import STIFFNESS
from .recorded_pairs import Paired, upper
from .recorded_strokes import LOAD


def loads_of(points: pd.DataFrame) -> tuple[Paired, ...]:
    """The recorded pairs of each size that differs among recorded points, and the load in N; none under one load.

    A stiffness follows the radius, and has none of its own.
    """
    names = Conditions.of(points, (*SIZES, LOAD)).names
    loads = points[LOAD].astype(float)
    if LOAD not in names or loads.isna().any():
        return ()
    wide_n, pairs = room(LOAD, float(loads.min()), float(loads.max())), []
    for name in names:
        if name in (LOAD, STIFFNESS) or points[name].isna().any():
            continue
        by_size = loads.groupby(points[name].astype(float), sort=True)
        least_n, most_n = by_size.min(), by_size.max()
        sizes = least_n.index.to_numpy(float)
        wide = room(name, float(sizes[0]), float(sizes[-1]))
        below = upper(sizes, wide, wide_n - least_n.to_numpy(float)) * (1.0, -1.0)
        pairs.append(Paired(name, sizes, wide, (below, upper(sizes, wide, most_n.to_numpy(float) + wide_n))))
    return tuple(pairs)
