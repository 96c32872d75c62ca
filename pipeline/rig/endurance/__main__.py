"""Work synthetic strings until they fail: a run folder for each whole life, and truth.parquet of all strokes."""

import argparse
from pathlib import Path

import numpy as np
import pandas as pd

from ...ground.errors import program
from ...ground.stored.files import whole
from ...ground.words.counts import counted
from ..synthetic_folder import whole_recordings, write_run
from .life import live
from .strings_to_wear_out import plan


@program
def main() -> None:
    """Write OUT/<run>/ for every string, and OUT/truth.parquet."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.rig.endurance", description=__doc__)
    parser.add_argument("--strings", type=int, required=True)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, required=True, help="the folder of the recordings, a new one; required")
    parser.add_argument("--rate-hz", type=float, default=10.0)
    arguments = parser.parse_args()
    if not (1 <= arguments.strings <= 1000 and arguments.seed >= 0 and 10 <= arguments.rate_hz <= 1000):
        parser.error("--strings must be 1 to 1000, --seed 0 or more, --rate-hz 10 to 1000")
    truths = []
    with whole_recordings(arguments.out) as folder:
        for planned in plan(arguments.seed, arguments.strings):
            life = live(planned, arguments.rate_hz)
            write_run(planned.specimen.described(planned.run), life.samples, folder / planned.run)
            life.truth.insert(0, "run", planned.run)
            truths.append(life.truth)
        with whole(folder / "truth.parquet") as temporary:
            pd.concat(truths, ignore_index=True).to_parquet(temporary, index=False)
    strokes = [len(truth) for truth in truths]
    print(
        f"{arguments.out}: {counted(arguments.strings, 'string')} of {min(strokes)} to {max(strokes)} strokes, "
        f"{np.sum(strokes)} in all"
    )


if __name__ == "__main__":
    main()
