"""The scores of a judge on an author whose laws it was not taught."""

from collections import Counter
from dataclasses import dataclass

import numpy as np

from ...diagnosis.choice.judged import UNKNOWN, held, helpers_share
from ...diagnosis.numerics.judge import Judge
from ...ground.outside_library import is_outside
from .fitted_judge import explanations
from .lesson import Lesson

STRATA = {1: "single", 2: "pair"}


@dataclass(frozen=True)
class Judged:
    """A lesson and a judge's answer: the sets that it holds, the likeliest first; no sets mean unknown."""

    lesson: Lesson
    sets: tuple[tuple[str, ...], ...]
    places: tuple[int, ...]

    @property
    def stratum(self) -> str:
        """The stratum of the hidden effects: a single effect, a pair, or one that no library has."""
        return "open" if is_outside(self.lesson.effects[0]) else STRATA[len(self.lesson.effects)]

    @property
    def outcome(self) -> str:
        """How the sets compare with the hidden effects."""
        if not self.sets:
            return "unknown"
        right = any(self.lesson.right[place] for place in self.places)
        if len(self.sets) == 1:
            return "exact" if right else "firm and wrong"
        return "in the set" if right else "not in the set"


def judged(judge: Judge, lesson: Lesson) -> Judged:
    """A judge's answer on a lesson."""
    weighed = explanations(lesson, judge.recogniser)
    *shares, none = judge.probabilities(weighed).tolist()
    named = np.array(shares)
    places = held(named) if none + helpers_share(weighed, named) < UNKNOWN else []
    return Judged(lesson, tuple(weighed[place].ids for place in places), tuple(places))


def left_out(lessons: list[Lesson], judge_by_author: dict[str, Judge]) -> list[Judged]:
    """Every lesson with explanations, judged by a judge that only the other authors taught."""
    judgements = []
    for author in sorted({lesson.author for lesson in lessons}):
        judge = judge_by_author[author]
        judgements += [judged(judge, lesson) for lesson in lessons if lesson.author == author and lesson.ids]
    return judgements


def table(judgements: list[Judged]) -> str:
    """Outcomes by stratum and author, one line each, with the mean size of the sets."""
    lines = []
    for stratum in (*STRATA.values(), "open"):
        for author in [*sorted({judgement.lesson.author for judgement in judgements}), "all"]:
            selected = [
                judgement
                for judgement in judgements
                if judgement.stratum == stratum and author in (judgement.lesson.author, "all")
            ]
            count = Counter(judgement.outcome for judgement in selected)
            sizes = [len(judgement.sets) for judgement in selected if judgement.sets]
            outcomes = ", ".join(f"{name} {number}" for name, number in sorted(count.items()))
            lines.append(f"{stratum:7}{author:10}{len(selected):5}: {outcomes}; mean set {np.mean(sizes or [0]):.2f}")
    return "\n".join(lines)
