"""Recording → samples: a run's channels in our units, checked at the door."""

import argparse
import sys
from pathlib import Path

from ..ground import schemas
from ..ground.errors import program
from ..ground.outputs import file_to_write
from ..run.folder import recording_path
from ..run.left_out import noted
from ..run.samples import questions, read_samples


@program
def main() -> None:
    """Write `samples.parquet` of one run."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("run_dir", type=Path)
    parser.add_argument("--out", type=Path, required=True, help="the file of the samples, Parquet; required")
    parser.add_argument("--note-refusals", action="store_true", help="write why the run is refused, and exit with 0")
    arguments = parser.parse_args()
    file_to_write(arguments.out)
    with noted(arguments.run_dir, arguments.out, arguments.note_refusals):
        run, samples = read_samples(arguments.run_dir)
        for question in questions(run, samples, recording_path(arguments.run_dir)):
            print(f"warning: {question}", file=sys.stderr)
        schemas.write(samples, schemas.samples(list(samples.columns)), arguments.out)
        print(f"{run.run}: {len(samples)} samples over {samples['time_s'].iloc[-1] - samples['time_s'].iloc[0]:.1f} s")


if __name__ == "__main__":
    main()
