"""The errors that no model of a campaign's new strings can beat: what each string's own smooth curves leave."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pandas as pd

from ...ground.errors import program
from ...ground.input.outputs import file_to_write
from ...ground.input.parser import Parser
from ...ground.stored import schemas
from ...ground.stored.given_table import opened
from ...ground.words.progress import steps
from ..floor import FLOORS, residuals
from .campaign_tables import FLOOR
from .few_shot import asked_and_shown
from .points import SCHEMA


def floors(points: pd.DataFrame) -> Iterator[tuple[str, str, float, float]]:
    """Rows of `FLOOR`: of each string that models are asked about, what an oracle that sees the answers misses."""
    for points_asked, _ in steps(asked_and_shown(points), "string"):
        missed = residuals(points_asked, FLOORS["floor"])
        forward_mm, inverse_turns = (float(np.sqrt(np.mean(np.square(errors)))) for errors in missed)
        yield str(points_asked["string"].iloc[0]), str(points_asked["material"].iloc[0]), forward_mm, inverse_turns


@program
def main() -> None:
    """Write the floor of every string that models are asked about."""
    parser = Parser(description=__doc__)
    parser.add_argument("points", type=Path)
    parser.add_argument("--out", type=Path, required=True, help="the file of the floor, Parquet; required")
    arguments = parser.parse_args()
    file_to_write(arguments.out, reads=[arguments.points])
    points = opened(arguments.points, SCHEMA, "make it: python -m pipeline.stages.campaign.points")
    table = pd.DataFrame(list(floors(points)), columns=FLOOR.names)
    schemas.write(table, FLOOR, arguments.out)
    print(table[["forward_mm", "inverse_turns"]].median().to_string(float_format="%.4f"))


if __name__ == "__main__":
    main()
