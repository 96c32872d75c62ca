"""One lesson: a concealed case by an author, the explanations that the search weighs, and which one is right."""

import json
import random
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path

import pandas as pd

from ...diagnosis.choice.weigh import weighed
from ...diagnosis.fit import calibrate
from ...diagnosis.fit.problem import Problem
from ...diagnosis.mechanisms.interface import physics
from ...diagnosis.numerics.judge import Weighed
from ...diagnosis.recording.recorded_run import RecordedRun
from ...diagnosis.signature.signature import signature_of
from ...diagnosis.study.engine import make_problem, study
from ...ground.outside_library import is_outside
from ...rig.authors import authors
from ...rig.authors.interface import Asked, OutOfReach, Protocol
from ...run.description import parse_run
from ...run.run_yaml import RunYaml
from ...run.samples import check
from ...run.table.recorded_table import to_samples
from ..authored import described

PROTOCOLS: tuple[Protocol, ...] = ("rich", "rich", "usual", "poor")
SINGLES, PAIRS, OPEN = (0.5, 12.0), (0.7, 10.0), (0.7, 12.0)  # sizes in noise floors, drawn evenly in their logarithm
PAIRS_EACH, OPEN_EACH = 12, 8  # for every round of all single effects
DIGITS = 5
TRIES, APART = 6, 1000  # seeds that are tried where an author's rig cannot show an effect


@dataclass(frozen=True)
class Lesson:
    """A case and its explanations: their ids, their signs, and whether each names exactly the hidden effects."""

    author: str
    seed: int
    effects: tuple[str, ...]
    kappas: tuple[float, ...]
    protocol: Protocol
    ids: tuple[tuple[str, ...], ...] = ()
    signs: tuple[dict[str, float], ...] = ()
    right: tuple[bool, ...] = ()
    signature: dict[str, float] = field(default_factory=dict)  # of the mismatch

    @property
    def answers(self) -> tuple[bool, ...]:
        """The explanations that a judge should choose: the right ones; else those without physics of the library."""
        return self.right if any(self.right) else tuple(not physics(ids) for ids in self.ids)


def curriculum(who: list[str], rounds: int, seed: int) -> list[Lesson]:
    """The lessons to make: in every round each author's effects one by one, some pairs, and some outside the library.

    Their order is drawn, so that any first part of them is a fair sample.
    """
    lessons = []
    for author in who:
        draw = random.Random(f"{author} {seed}")
        law_names = sorted(authors()[author].laws)
        inside = [name for name in law_names if not is_outside(name)]
        outside = [name for name in law_names if is_outside(name)]
        wanted: list[tuple[tuple[str, ...], tuple[float, float]]] = []
        for _ in range(rounds):
            wanted += [((name,), SINGLES) for name in inside]
            wanted += [(tuple(draw.sample(inside, 2)), PAIRS) for _ in range(PAIRS_EACH)]
            wanted += [((draw.choice(outside),), OPEN) for _ in range(OPEN_EACH)]
        for number, (effects, (low, high)) in enumerate(wanted):
            kappas = tuple(round(low * (high / low) ** draw.random(), 3) for _ in effects)
            lessons.append(Lesson(author, seed + number, effects, kappas, draw.choice(PROTOCOLS)))
    random.Random(seed).shuffle(lessons)
    return lessons


def recorded(content: RunYaml, table: pd.DataFrame) -> RecordedRun:
    """A recording in the form that a diagnosis takes, from the content of `run.yaml` and a table; raises BadInput.

    Under one load that nobody recorded, the load is what `run.yaml` says.
    """
    folder = Path(content["run"])
    run = parse_run(content, folder / "run.yaml")
    path = folder / "recording.parquet"
    return RecordedRun(run, *check(run, to_samples(run, table, path, folder / "run.yaml"), path))


def problem_of(lesson: Lesson) -> Problem | None:
    """The problem of a lesson's recording; none where its author's rig cannot show the effect."""
    for number in range(TRIES):
        request = Asked(lesson.seed + APART * number, lesson.effects, lesson.kappas, lesson.protocol)
        try:
            authored_case = authors()[lesson.author].make(request)
        except OutOfReach:
            continue
        return make_problem([recorded(described("lesson", authored_case), authored_case.table)])
    return None


def sighted(lesson: Lesson) -> Lesson:
    """A lesson with only the signature of its mismatch; unchanged where its recording cannot be made."""
    problem = problem_of(lesson)
    if problem is None:
        return lesson
    problem, _ = calibrate.without_outliers(problem, calibrate.base(problem))
    return replace(lesson, signature=rounded(signature_of(problem, calibrate.base(problem))))


def learnt(lesson: Lesson) -> Lesson:
    """A lesson with its signature and the search's explanations of its recording; no sets where nothing was seen."""
    problem = problem_of(lesson)
    if problem is None:
        return lesson
    studied = study(problem)
    lesson = replace(lesson, signature=rounded(signature_of(studied.problem, studied.base)))
    if not studied.judged.likely:
        return lesson
    return of(lesson, weighed(studied.search, studied.base, studied.noise.floor), tuple(studied.random))


def rounded(number_by_name: dict[str, float]) -> dict[str, float]:
    """The same numbers with as many digits as a lesson keeps."""
    return {name: round(number, DIGITS) for name, number in number_by_name.items()}


def of(lesson: Lesson, weighed_sets: list[Weighed], jerks: tuple[str, ...]) -> Lesson:
    """A lesson with explanations; effects that jerk at random are named beside each of them."""
    truth = {name for name in lesson.effects if not is_outside(name)}
    right = tuple({*explanation.ids, *jerks} == truth for explanation in weighed_sets)
    signs = tuple(rounded(explanation.signs) for explanation in weighed_sets)
    content = {"ids": tuple(explanation.ids for explanation in weighed_sets), "signs": signs, "right": right}
    return Lesson(**{**asdict(lesson), **content})


def written(lesson: Lesson) -> str:
    """A lesson as a line of JSON."""
    return json.dumps(asdict(lesson), separators=(",", ":"))


def read(line: str) -> Lesson:
    """A lesson from a line."""
    content = json.loads(line)
    lists = {name: tuple(content[name]) for name in ("effects", "kappas", "signs", "right")}
    return Lesson(**{**content, **lists, "ids": tuple(tuple(ids) for ids in content["ids"])})
