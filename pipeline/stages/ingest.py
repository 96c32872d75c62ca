"""Recording → samples: a run's channels in our units, checked at the door."""

import argparse
import sys
from pathlib import Path

import numpy as np

from ..ground.errors import program
from ..ground.files import whole
from ..ground.outputs import file_to_write
from ..run.folder import recording_path
from ..run.left_out import noted
from ..run.samples import questions, stored_samples


@program
def main() -> None:
    """Write `samples.parquet` of one run."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("run_dir", type=Path)
    parser.add_argument("--out", type=Path, required=True, help="the file of the samples, Parquet; required")
    parser.add_argument("--note-refusals", action="store_true", help="write why the run is refused, and exit with 0")
    arguments = parser.parse_args()
    file_to_write(arguments.out)
    with noted(arguments.run_dir, arguments.out, arguments.note_refusals), whole(arguments.out) as temporary:
        run, samples = stored_samples(arguments.run_dir, temporary)
        for question in questions(run, samples, recording_path(arguments.run_dir)):
            print(f"warning: {question}", file=sys.stderr)
        begin_s, end_s = samples.at("time_s", np.array([0, len(samples) - 1]))
        print(f"{run.run}: {len(samples)} samples over {end_s - begin_s:.1f} s")


if __name__ == "__main__":
    main()
