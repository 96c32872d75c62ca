"""Run folders of many strings → one dataset in which dimensions, load and material vary, parted by whole strings.

The split `strings` labels each string "train", "tune" or "test", so that no string is in two of them: models learn on
the first, what an adaptation to a new string may expect is learnt on the second, and the third is asked about.
"""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pandas as pd
import pyarrow as pa

from ...ground.errors import BadInput, program
from ...ground.input.outputs import file_to_write
from ...ground.input.parser import Parser
from ...ground.stored import schemas
from ...ground.words.progress import steps
from ...run.folder import find_runs, read_run
from ...string.from_raw import read
from ..dataset import make_dataset

SCHEMA = pa.unify_schemas(
    [schemas.DATASET, pa.schema([pa.field(n, pa.string(), nullable=False) for n in ("material", "strings")])]
)
PARTS = ("train", "train", "tune", "test", "test")  # of every five strings of a material, in the order of their names
MOST_POINTS = 40  # of one winding or unwinding; more tell no more about a string


def string_points(folders: Sequence[Path]) -> pd.DataFrame:
    """Moving points of one string's runs, tared, evenly thinned, with its material; raises BadInput as reading does.

    The runs continue each other's stroke numbers and share the string's tare.
    """
    recorded = [read(folder) for folder in folders]
    points = make_dataset(recorded)
    passage = points.groupby(["stroke", "phase"])
    place, count = passage.cumcount(), passage["stroke"].transform("size")
    step = np.maximum(count / MOST_POINTS, 1.0)
    kept = points[np.floor(place / step) != np.floor((place - 1) / step)]
    materials = sorted(
        {recorded_run.run.string.material for recorded_run in recorded if recorded_run.run.string is not None}
    )
    if len(materials) > 1:
        problem = f"is of {' and of '.join(materials)}"
        raise BadInput(folders[0] / "run.yaml", "string", problem, "correct its runs, or give one another string.id")
    return kept.assign(material=materials[0])


def labelled(points: pd.DataFrame) -> pd.DataFrame:
    """The points with each string's part of the campaign; every material has its strings in all parts."""
    names = points[["string", "material"]].drop_duplicates().sort_values("string")
    place = names.groupby("material").cumcount().to_numpy()
    part = dict(zip(names["string"], np.array(PARTS)[place % len(PARTS)], strict=True))
    return points.assign(strings=points["string"].map(part), within="", later="")


def campaign_points(folder: Path) -> pd.DataFrame:
    """Points of every run in a folder, with the columns of `SCHEMA`; raises BadInput when there is none."""
    folders = list(find_runs(folder))
    if not folders:
        raise BadInput(folder, "runs", "there is none", "make some: python -m pipeline.rig.campaign")
    strings: dict[str, list[Path]] = {}
    for run_folder in folders:
        run = read_run(run_folder)
        if run.string is None:
            raise BadInput(run_folder / "run.yaml", "string", "is missing", "a campaign is of strings")
        strings.setdefault(run.string_id, []).append(run_folder)
    points = pd.concat([string_points(runs) for runs in steps(strings.values(), "string")], ignore_index=True)
    return labelled(points)[SCHEMA.names]


@program
def main() -> None:
    """Write `dataset.parquet` of a campaign."""
    parser = Parser(description=__doc__)
    parser.add_argument("folder", type=Path, help="a folder of run folders")
    parser.add_argument("--out", type=Path, required=True, help="the file of the points, Parquet; required")
    arguments = parser.parse_args()
    file_to_write(arguments.out)
    points = campaign_points(arguments.folder)
    schemas.write(points, SCHEMA, arguments.out)
    for part, rows in points.groupby("strings"):
        print(f"{part}: {rows['string'].nunique()} strings, {len(rows)} points")


if __name__ == "__main__":
    main()
