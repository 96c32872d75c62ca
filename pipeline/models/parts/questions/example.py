"""One question about a dataset that can be answered, for a person to begin with: a point that was recorded."""

from pathlib import Path

import pyarrow.parquet as pq

from ....ground.stored.regular_file import open_regular
from ..conditions import Conditions

ASKED = ["stroke", "direction", "motor_turns"]  # every question tells stroke and direction, and this one the twist
DIFFERING = ["string", "actuator"]  # that a question tells where the recordings differ in them


def example(dataset: Path) -> list[str]:
    """The header and the row of a csv that asks about the middle point of a dataset's file."""
    with open_regular(dataset) as file:
        points = pq.read_table(file, columns=[*ASKED, *DIFFERING, "load_n"]).to_pandas()
    differing = [name for name in DIFFERING if points[name].nunique() > 1]
    columns = [*ASKED, *differing, *Conditions.of(points, ("load_n",)).names]
    middle = points.iloc[len(points) // 2]
    return [",".join(columns), ",".join(_cell(middle[name]) for name in columns)]


def _cell(value: object) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)
