"""Record a synthetic campaign: a run folder for each of many strings, whose dimensions, load and material vary."""

import argparse
from pathlib import Path

from ...ground.errors import program
from ...ground.words.counts import counted
from ..synthetic_folder import whole_recordings, write_run
from .strings_to_record import plan


@program
def main() -> None:
    """Write OUT/<run>/ for every string."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.rig.campaign", description=__doc__)
    parser.add_argument("--strings", type=int, required=True)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, required=True, help="the folder of the recordings, a new one; required")
    parser.add_argument("--strokes", type=int, default=9)
    parser.add_argument("--rate-hz", type=float, default=10.0)
    arguments = parser.parse_args()
    if not (
        1 <= arguments.strings <= 1000
        and arguments.strokes >= 1
        and arguments.seed >= 0
        and 10 <= arguments.rate_hz <= 1000
    ):
        parser.error("--strings must be 1 to 1000, --strokes 1 or more, --seed 0 or more, --rate-hz 10 to 1000")
    with whole_recordings(arguments.out) as folder:
        for planned in plan(arguments.seed, arguments.strings, arguments.strokes):
            write_run(planned.specimen.described(planned.run), planned.recorded(arguments.rate_hz).samples,
                      folder / planned.run)  # fmt: skip
    print(f"{arguments.out}: {counted(arguments.strings, 'string')}, {counted(arguments.strokes, 'stroke')} each")


if __name__ == "__main__":
    main()
