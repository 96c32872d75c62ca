"""Ask the diagnosis again about what was tied: the recording and the one made after it, together."""

import argparse
import json
from pathlib import Path

from ..ground.errors import program
from ..ground.stored.files import write_text
from .verdicts import ask


@program
def main() -> None:
    """Write OUT/<run>/<way>/diagnosis.json for every continued run, and OUT/settled.json."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.proof.settle", description=__doc__)
    parser.add_argument("--runs", type=Path, required=True, help="folder of the first run folders")
    parser.add_argument("--more", type=Path, required=True, help="folder of <run>/<way>/<run>-more/")
    parser.add_argument("--out", type=Path, required=True, help="the folder of what is asked; required")
    parser.add_argument("--without", default="", metavar="ID", help="the mechanism that the library loses")
    arguments = parser.parse_args()
    questions = {}
    for more in sorted(arguments.more.glob("*/*/*-more")):
        run, way = more.parts[-3:-1]
        out = arguments.out / run / way
        out.mkdir(parents=True, exist_ok=True)  # what is refused leaves it empty, and is scored as refused
        questions[f"{run}/{way}"] = ask([arguments.runs / run, more], out, arguments.without, together=True)
    write_text(arguments.out / "settled.json", json.dumps(questions, indent=1) + "\n")


if __name__ == "__main__":
    main()
