"""Make one recording by one author: a run folder that tells nothing, and the sealed answer elsewhere."""

import argparse
import json
from pathlib import Path

import yaml

from ...ground.errors import BadInput, program
from ...ground.stored.files import write_text
from ...ground.stored.whole_folder import whole_folder
from ...run.description import RUN_NAME
from . import Author, authors, names
from .interface import PROTOCOLS, Asked, Made, OutOfReach


def check_places(run: str, raw: Path, answer: Path) -> None:
    """Raise BadInput for a run's name that cannot be one, and for an answer inside `raw` or there already."""
    if not RUN_NAME.fullmatch(run):
        raise BadInput("--run", run, "is not a run's name", "use lower-case letters, digits and -")
    if answer.resolve().is_relative_to(raw.resolve()):
        raise BadInput(answer, "--answer", f"lies inside {raw}, beside what it gives away", "put it elsewhere")
    if answer.exists():
        raise BadInput(answer, "--answer", "is there already", "remove it or choose another file")


def made_by(author: Author, request: Asked) -> Made:
    """The recording that was asked of an author; raises BadInput for an unknown effect or one out of reach."""
    for effect in request.effects:
        if effect not in author.laws:
            known = ", ".join(author.laws)
            raise BadInput(author.name, "--effect", f"{effect!r} is not known", f"use one of {known}")
    try:
        return author.make(request)
    except OutOfReach as error:
        raise BadInput(author.name, "--kappa", f"is out of reach: {error}", "ask for less, or another seed") from None


def write(made: Made, run: str, raw: Path, answer: Path, sealed: str) -> None:
    """Write the run folder and the answer, both or none."""
    with whole_folder(raw / run, "--run", "choose another name") as temporary:
        text = yaml.safe_dump({"run": run, **made.content}, sort_keys=False, allow_unicode=True)
        (temporary / "run.yaml").write_text(text, encoding="utf-8")
        made.table.to_parquet(temporary / "recording.parquet", index=False)
        write_text(answer, sealed)


@program
def main() -> None:
    """Make one recording by one author."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.rig.authors", description=__doc__)
    parser.add_argument("author", choices=names())
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--effect", nargs="*", default=[], metavar="ID", help="the hidden effects; none: a control")
    parser.add_argument("--kappa", nargs="*", type=float, default=[], metavar="K", help="size of each, in noise floors")
    parser.add_argument("--protocol", choices=PROTOCOLS, required=True)
    parser.add_argument("--run", required=True, metavar="NAME")
    parser.add_argument("--raw", type=Path, required=True, metavar="DIR", help="where the run folder goes")
    parser.add_argument("--answer", type=Path, required=True, metavar="FILE", help="the sealed answer, not in DIR")
    given = parser.parse_args()
    check_places(given.run, given.raw, given.answer)
    try:
        request = Asked(given.seed, tuple(given.effect), tuple(given.kappa), given.protocol)
    except ValueError as error:
        raise BadInput(given.author, "--effect, --kappa", str(error), "correct the command") from None
    made = made_by(authors()[given.author], request)
    answer = {"run": given.run, "author": given.author, "seed": request.seed, "protocol": request.protocol}
    sealed = json.dumps({**answer, **made.truth}, indent=1, allow_nan=False) + "\n"
    write(made, given.run, given.raw, given.answer, sealed)
    print(f"written: {given.raw / given.run} (what is hidden: {given.answer})")


if __name__ == "__main__":
    main()
