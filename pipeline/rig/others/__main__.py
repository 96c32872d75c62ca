"""Write one case as a run folder, and its truth to a file elsewhere."""

import argparse
import json
from pathlib import Path

from ...ground.errors import BadInput, program
from ...ground.files import write_text
from .cases import CASES, make
from .made import NOISES, write_run


@program
def main() -> None:
    """Write RUN_DIR, and the truth to --answer when asked."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.rig.others", description=__doc__)
    parser.add_argument("case", choices=CASES, metavar="CASE", help=f"one of {', '.join(CASES)}")
    parser.add_argument("run_dir", metavar="RUN_DIR", type=Path)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--plan", help="another motion than the case's, of the same rig")
    parser.add_argument("--noise", choices=NOISES)
    parser.add_argument("--take", type=int, default=0, help="another day of the same rig")
    parser.add_argument("--answer", type=Path, help="where the truth goes, outside RUN_DIR")
    asked = parser.parse_args()
    if asked.answer and asked.answer.resolve().is_relative_to(asked.run_dir.resolve()):
        raise BadInput(asked.answer, "--answer", "is inside the run folder", "put it where no diagnosis looks")
    try:
        made = make(asked.case, asked.seed, plan=asked.plan, noise=asked.noise, take=asked.take)
    except ValueError as error:
        raise BadInput(asked.case, "--plan", str(error), "choose one of those") from None
    if asked.run_dir.exists():
        raise BadInput(asked.run_dir, "RUN_DIR", "is there already", "choose another; runs are never overwritten")
    write_run(made, asked.run_dir)
    if asked.answer:
        write_text(asked.answer, json.dumps({"case": asked.case, **made.truth}, indent=1) + "\n")


if __name__ == "__main__":
    main()
