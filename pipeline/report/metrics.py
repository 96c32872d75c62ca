"""Metrics of all materials → reports/metrics.csv, one tidy table."""

import argparse
from pathlib import Path

import pandas as pd

from pipeline import schemas
from pipeline.errors import program
from pipeline.files import write_text


@program
def main() -> None:
    """Write `metrics.csv`."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("metrics", type=Path, nargs="*")
    parser.add_argument("--out", type=Path, required=True)
    arguments = parser.parse_args()
    parts = [schemas.read(path, schemas.METRICS) for path in arguments.metrics]
    table = pd.concat(parts) if parts else pd.DataFrame(columns=schemas.METRICS.names)
    write_text(arguments.out, table.to_csv(index=False, float_format="%.9g"))


if __name__ == "__main__":
    main()
