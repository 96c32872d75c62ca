"""Recording → samples and strokes: a run's channels in our units, checked at the door, and cut into strokes there."""

import sys
from pathlib import Path

import numpy as np
import pandas as pd

from ..ground.errors import program
from ..ground.input.outputs import file_to_write
from ..ground.input.parser import Parser
from ..ground.stored import schemas
from ..ground.stored.files import whole
from ..ground.stored.rows import Rows
from ..ground.words.counts import counted
from ..ground.words.left_out import noted
from ..run.description import Run
from ..run.doubts.plausible_dimensions import dimension_questions
from ..run.folder import recording_path
from ..run.made_from import note_run
from ..run.mend_command import with_command
from ..run.read_ahead import forget, taken_over
from ..run.samples import questions, stored_strokes


def warn(run: Run, samples: pd.DataFrame | Rows, folder: Path) -> None:
    """Print likely mistakes in the description and in the checked samples of the run in a folder, with their mends."""
    odd = dimension_questions(run, folder / "run.yaml")
    for question in [*odd, *questions(run, samples, recording_path(folder))]:
        print(f"warning: {with_command(question, folder)}", file=sys.stderr)


@program
def main() -> None:
    """Write `samples.parquet` and `strokes.parquet` of one run."""
    parser = Parser(description=__doc__)
    parser.add_argument("run_dir", type=Path)
    parser.add_argument("--out", type=Path, required=True, help="the file of the samples, Parquet; required")
    parser.add_argument("--out-strokes", type=Path, help="the file of the strokes, Parquet; default: none is written")
    parser.add_argument("--out-read-from", type=Path, help="where to note, as JSON, the run's files by content")
    parser.add_argument("--read-ahead", type=Path, help="where a plan keeps what it has read; default: nowhere")
    of = "digests of the run's files and of the code that reads them, to which what is kept must be bound"
    parser.add_argument("--of", nargs="+", default=[], metavar="DIGEST", help=of)
    parser.add_argument("--note-refusals", action="store_true", help="write why the run is refused, and exit with 0")
    arguments = parser.parse_args()
    files = [path for path in (arguments.out, arguments.out_strokes) if path]
    if arguments.out_read_from:  # of a refused run too: when its files change it is asked again
        file_to_write(arguments.out_read_from, "--out-read-from")
        note_run(arguments.run_dir, arguments.out_read_from)
    for path, option in zip(files, ("--out", "--out-strokes"), strict=False):
        file_to_write(path, option)
    with noted(arguments.run_dir, files, arguments.note_refusals), whole(arguments.out) as temporary:
        ahead, bound_to = arguments.read_ahead, " ".join(arguments.of)
        kept = ahead and taken_over(arguments.run_dir, ahead, bound_to, temporary)
        run, samples, strokes = kept or stored_strokes(arguments.run_dir, temporary)
        warn(run, samples, arguments.run_dir)
        begin_s, end_s = samples.at("time_s", np.array([0, len(samples) - 1]))
        if arguments.out_strokes:
            schemas.write(strokes, schemas.STROKES, arguments.out_strokes)
        cut = f"{counted(strokes['stroke'].max(), 'stroke')} in {len(strokes)} stretch{'es' * (len(strokes) != 1)}"
        print(f"{run.run}: {len(samples)} samples over {end_s - begin_s:.1f} s, {cut}")
    if arguments.read_ahead:
        forget(arguments.run_dir, arguments.read_ahead)


if __name__ == "__main__":
    main()
