"""Metrics of all materials → reports/metrics.csv, one tidy table, and what its columns are."""

import argparse
from pathlib import Path

import pandas as pd

from ..ground.errors import program
from ..ground.input.words_by_file import SIGN
from ..ground.stored import schemas
from ..ground.stored.files import write_text
from .layout.sidecar import Column, describe
from .web.marks import add_mark, mark_from

COLUMNS: list[Column] = [
    ("material", "string", "the string's material"),
    ("model", "string", "file of the model; floor and floor_blind are what no model beats, with and without direction"),
    ("split", "string", "what was held out: blocks within strokes, or whole later strokes"),
    ("map", "string", "forward: displacement from twist; inverse: twist from displacement"),
    ("stroke", "string", "the stroke's number since the string was new, or all"),
    ("phase", "string", "winding, unwinding or all"),
    ("angle_band", "string", "quarter of the material's range of twist, or all"),
    ("seed", "integer", "of the fit"),
    ("metric", "string", "average: mean of the size; maximum: largest size; rmse: root of the mean square"),
    ("unit", "string", "of the value"),
    ("value", "number", "the error on held-out points"),
]


@program
def main() -> None:
    """Write `metrics.csv`."""
    parser = argparse.ArgumentParser(
        prog="python -m pipeline.report.metrics", description=__doc__, fromfile_prefix_chars=SIGN
    )
    parser.add_argument("metrics", type=Path, nargs="*")
    parser.add_argument("--out", type=Path, required=True, help="the file of the errors, csv; required")
    add_mark(parser)
    arguments = parser.parse_args()
    parts = [schemas.read(path, schemas.METRICS) for path in arguments.metrics]
    table = pd.concat(parts) if parts else pd.DataFrame(columns=schemas.METRICS.names)
    write_text(arguments.out, table.to_csv(index=False, float_format="%.9g"))
    describe(arguments.out, "Every error of every model", COLUMNS, mark_from(arguments.made_by))


if __name__ == "__main__":
    main()
