"""Samples → strokes: where the motor winds, holds, unwinds and rests, and which stroke that is."""

import argparse
from pathlib import Path

from ..ground import schemas
from ..ground.errors import program
from ..ground.outputs import file_to_write
from ..ground.rows import Stored
from ..run.left_out import noted
from ..run.strokes import segment


@program
def main() -> None:
    """Write `strokes.parquet` of one run."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("samples", type=Path)
    parser.add_argument("--out", type=Path, required=True, help="the file of the strokes, Parquet; required")
    parser.add_argument("--note-refusals", action="store_true", help="write why the run is refused, and exit with 0")
    arguments = parser.parse_args()
    file_to_write(arguments.out, reads=[arguments.samples])
    with noted(arguments.samples, arguments.out, arguments.note_refusals):
        samples = Stored(arguments.samples)
        strokes = segment(samples, samples.columns[1], arguments.samples)
        schemas.write(strokes, schemas.STROKES, arguments.out)
        print(f"{arguments.samples.parent.name}: {strokes['stroke'].max()} strokes in {len(strokes)} stretches")


if __name__ == "__main__":
    main()
