"""Write one case as a run folder, and its truth to a file elsewhere."""

import argparse
import json
from pathlib import Path

from ...ground.errors import BadInput, program
from ...ground.stored.files import write_text
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
    arguments = parser.parse_args()
    if arguments.answer and arguments.answer.resolve().is_relative_to(arguments.run_dir.resolve()):
        raise BadInput(arguments.answer, "--answer", "is inside the run folder", "put it where no diagnosis looks")
    try:
        case = make(arguments.case, arguments.seed, plan=arguments.plan, noise=arguments.noise, take=arguments.take)
    except ValueError as error:
        raise BadInput(arguments.case, "--plan", str(error), "choose one of those") from None
    if arguments.run_dir.exists():
        raise BadInput(arguments.run_dir, "RUN_DIR", "is there already", "choose another; runs are never overwritten")
    write_run(case, arguments.run_dir)
    if arguments.answer:
        write_text(arguments.answer, json.dumps({"case": arguments.case, **case.truth}, indent=1) + "\n")
    hidden = f"what is hidden: {arguments.answer}" if arguments.answer else "--answer FILE keeps what is hidden"
    print(f"written: {arguments.run_dir} ({hidden})")


if __name__ == "__main__":
    main()
