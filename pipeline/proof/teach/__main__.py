"""Teach the judge of the diagnosis on cases by authors, and score it on each author whom it was not taught by."""

import argparse
import json
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from ...diagnosis.numerics import judge as judge_file
from ...diagnosis.numerics.judge import Judge, judge
from ...ground.errors import BadInput, program
from ...ground.stored.files import write_text
from ...ground.words.progress import steps
from ...rig.authors import names
from . import across, fitted_judge
from .lesson import Lesson, curriculum, learnt, read, sighted, written

AT_ONCE = 8  # lessons between two savings
JUDGES = Path(__file__).parent / "judges"
LIBRARY = Path(judge_file.__file__).parent / "judge.json"
SIGHTED = 500_000  # the seed of the first sighting, beyond that of the first lesson


def taken(path: Path, wanted: list[Lesson], jobs: int, make: Callable[[Lesson], Lesson]) -> list[Lesson]:
    """All lessons that are wanted: those that a file has are kept, the others are made and added to it."""
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    lessons = [read(line) for line in lines]
    lesson_keys = {(lesson.author, lesson.seed, lesson.effects) for lesson in lessons}
    missing = [lesson for lesson in wanted if (lesson.author, lesson.seed, lesson.effects) not in lesson_keys]
    groups = [missing[at : at + AT_ONCE] for at in range(0, len(missing), AT_ONCE)]
    with ProcessPoolExecutor(jobs) as pool:
        for group in steps(groups, f"{AT_ONCE} lessons"):
            lessons += pool.map(make, group)
            write_text(path, "".join(f"{written(lesson)}\n" for lesson in lessons))
    return lessons


def judge_of(lessons: list[Lesson], onwards: Path | None) -> Judge:
    """The judge that some lessons make, or that goes on from one of a file."""
    before = judge(onwards) if onwards else None
    return fitted_judge.listening(fitted_judge.fitted([lesson for lesson in lessons if lesson.ids], before), lessons)


def save(path: Path, new_judge: Judge) -> Judge:
    """Write a judge; the same judge."""
    write_text(path, json.dumps(fitted_judge.content(new_judge), separators=(",", ":")) + "\n")
    return new_judge


@program
def main() -> None:
    """Write the judge by all authors, one without each author, and print how those do on whom they do not know."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.proof.teach", description=__doc__)
    parser.add_argument("--lessons", type=Path, required=True, metavar="FILE", help="where lessons are kept (.jsonl)")
    parser.add_argument("--rounds", type=int, default=3, help="of all effects of all authors")
    parser.add_argument("--seed", type=int, default=50_000, help="of the first case")
    parser.add_argument(
        "--sightings", type=int, default=0, metavar="ROUNDS", help="of which the signature is taken alone"
    )
    parser.add_argument(
        "--onwards",
        action="store_true",
        help="go on from the judges that are there",
    )
    parser.add_argument("--jobs", type=int, default=1, help="lessons at a time")
    parser.add_argument(
        "--out", type=Path, required=True, metavar="FILE", help="the file of the judge (.json); required"
    )
    parser.add_argument("--apart", type=Path, metavar="DIR", help="where the judges without one author go")
    arguments = parser.parse_args()
    wanted = curriculum(list(names()), arguments.rounds, arguments.seed)
    lessons = taken(arguments.lessons, wanted, arguments.jobs, learnt)
    if arguments.sightings:
        more = curriculum(list(names()), arguments.sightings, arguments.seed + SIGHTED)
        lessons = taken(arguments.lessons, more, arguments.jobs, sighted)
    if len({lesson.author for lesson in lessons if lesson.ids}) < 2:
        count = sum(bool(lesson.ids) for lesson in lessons)
        problem = f"{count} lessons with explanations are not by two authors"
        raise BadInput(arguments.lessons, "--rounds", problem, "ask for at least one round")
    save(arguments.out, judge_of(lessons, LIBRARY if arguments.onwards else None))
    apart = {}
    for author in names():
        others = [lesson for lesson in lessons if lesson.author != author]
        apart[author] = judge_of(others, JUDGES / f"without_{author}.json" if arguments.onwards else None)
        if arguments.apart:
            save(arguments.apart / f"without_{author}.json", apart[author])
    print(across.table(across.left_out(lessons, apart)))


if __name__ == "__main__":
    main()
