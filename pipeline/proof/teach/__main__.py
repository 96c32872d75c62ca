"""Teach the judge of the diagnosis on cases by authors, and score it on each author whom it was not taught by."""

import argparse
import json
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from ...ground.errors import BadInput, program
from ...ground.files import write_text
from ...ground.progress import steps
from ...rig.authors import names
from . import across, fit
from .lesson import Lesson, curriculum, learnt, read, written

AT_ONCE = 8  # lessons between two savings


def taken(path: Path, wanted: list[Lesson], jobs: int) -> list[Lesson]:
    """All lessons that are wanted: those that a file has are kept, the others are made and added to it."""
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    lessons = [read(line) for line in lines]
    known = {(lesson.author, lesson.seed, lesson.effects) for lesson in lessons}
    missing = [lesson for lesson in wanted if (lesson.author, lesson.seed, lesson.effects) not in known]
    groups = [missing[at : at + AT_ONCE] for at in range(0, len(missing), AT_ONCE)]
    with ProcessPoolExecutor(jobs) as pool:
        for group in steps(groups, f"{AT_ONCE} lessons"):
            lessons += pool.map(learnt, group)
            write_text(path, "".join(f"{written(lesson)}\n" for lesson in lessons))
    return lessons


def save(path: Path, lessons: list[Lesson]) -> None:
    """Write the judge that some lessons make."""
    write_text(path, json.dumps(fit.content(fit.fitted(lessons)), separators=(",", ":")) + "\n")


@program
def main() -> None:
    """Write the judge by all authors, one without each author, and print how those do on whom they do not know."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.proof.teach", description=__doc__)
    parser.add_argument("--lessons", type=Path, required=True, metavar="FILE", help="where lessons are kept (.jsonl)")
    parser.add_argument("--rounds", type=int, default=3, help="of all effects of all authors")
    parser.add_argument("--seed", type=int, default=50_000, help="of the first case")
    parser.add_argument("--jobs", type=int, default=1, help="lessons at a time")
    parser.add_argument(
        "--out", type=Path, required=True, metavar="FILE", help="the file of the judge (.json); required"
    )
    parser.add_argument("--apart", type=Path, metavar="DIR", help="where the judges without one author go")
    arguments = parser.parse_args()
    wanted = curriculum(list(names()), arguments.rounds, arguments.seed)
    lessons = [lesson for lesson in taken(arguments.lessons, wanted, arguments.jobs) if lesson.ids]
    if len({lesson.author for lesson in lessons}) < 2:
        problem = f"{len(lessons)} lessons with explanations are not by two authors"
        raise BadInput(arguments.lessons, "--rounds", problem, "ask for at least one round")
    save(arguments.out, lessons)
    for author in names() if arguments.apart else []:
        save(arguments.apart / f"without_{author}.json", [lesson for lesson in lessons if lesson.author != author])
    print(across.table(across.left_out(lessons)))


if __name__ == "__main__":
    main()
