"""Questions about a string, answered with intervals by a model that is fitted to recorded points, in memory."""

from dataclasses import dataclass, replace
from pathlib import Path

import pandas as pd

from ..ground.errors import BadInput
from ..ground.model_names import USUAL
from ..models.interface import about
from ..models.parts.configured import configured, fitting
from ..models.parts.questions.beside_questions import beside_questions, with_intervals
from ..models.parts.questions.each_string import Answer, by_string
from ..models.parts.questions.prediction_intervals import Intervals, TooFew
from ..models.parts.questions.question_points import Questions, questions_of
from ..models.parts.questions.strings_alike import strings_alike, with_whom
from ..models.parts.thinned import thinned
from .as_arguments import as_arguments, settings_in_json

LEVEL = 0.9  # the probability that an interval holds the truth, unless told otherwise


def answers(
    points: pd.DataFrame, questions: pd.DataFrame, model: str = "", seed: int = 0, level: float = LEVEL,
    each_string: bool = False, **more: object,
) -> pd.DataFrame:  # fmt: skip
    """The contraction of each twist, or the twist of each contraction, that is asked about, with its interval.

    `points` are those of recordings, as `twistbench.points` gives them. `questions` has a row for each question:
    `motor_turns` (turns) or `displacement_mm` (mm), of which the other is the answer; `stroke` (from 1) and `direction`
    (1 winding, -1 unwinding); and what differs among the recordings, such as `load_n` (N). `model` is a name of
    `model_names()`, the usual one if none is given; `more` are its settings.

    The answer repeats the questions, and has the value, its interval of probability `level` (`displacement_mm_low`,
    `displacement_mm_high` in mm, or `motor_turns_low`, `motor_turns_high` in turns), `inside`, whether such a question
    was recorded, and `why` not; then it has no interval. The interval is of one reading: at 0.9 nine of ten measured
    points lie in it. Strings of the same sizes have one answer, and `answer_of` names them; `calibrated` tells them
    apart, and so does any model with `each_string`, which is fitted to the points of each string alone. Displacements
    have the zero of `points`: `Recording.tare_mm` leads to the sensor's. Raises BadInput for columns that are missing
    or unknown, and where no row can be answered.
    """
    name = model or USUAL
    settings = settings_in_json(name, more)
    with as_arguments():
        refuse(name, settings, level)
        fitted = Fitted(points, name, settings, seed, level, each_string, Path("points"))
        table = fitted.answered(questions_of(questions, points, fitted.apart))
    return table.assign(why=table["why"].map(str))


def refuse(name: str, settings: str, level: float) -> None:
    """Raise BadInput for a model, settings in JSON or a level with which no question can be answered."""
    if not 0.0 < level < 1.0:
        raise BadInput("--level", str(level), "is no probability", "give a number between 0 and 1")
    configured(name, settings)  # complains before anything is fitted
    if about(name).needs_motion:
        problem = "answers along a whole motion, which single questions do not tell"
        raise BadInput("--model", name, problem, f"choose another, such as {USUAL}")


@dataclass(frozen=True)
class Fitted:
    """A model of a name, with settings in JSON, that is fitted to a dataset's points; `source` is their file.

    With `each_string` it is fitted to the points of each string that is asked about alone, and so is a model that has
    numbers of its own for every string.
    """

    dataset: pd.DataFrame
    name: str
    settings: str
    seed: int
    level: float
    each_string: bool
    source: Path

    @property
    def apart(self) -> bool:
        """Whether each string is answered by a fit to its own points, so that it must be a recorded one."""
        return self.each_string or about(self.name).each_string_apart

    def answered(self, questions: Questions) -> pd.DataFrame:
        """Questions beside their answers, with a `Why` each; raises BadInput where too few points tell how it errs."""
        recorded = self.dataset, about(self.name).by_equations
        if self.apart:
            answer = by_string(lambda string: self._answer(self._fitted_to(string)))
            return beside_questions(questions, answer, *recorded)
        intervals = self._fitted_to()
        answer = by_string(lambda string: self._answer(intervals.of_string(string)))
        answers = beside_questions(questions, answer, *recorded)
        strings = questions.points["string"].set_axis(questions.rows, axis=0)
        return with_whom(answers, strings, strings_alike(self.dataset))

    def _fitted_to(self, string: str = "") -> Intervals:
        """A fit to the points of one string, or of all where none is named."""
        points = self.dataset[self.dataset["string"].astype(str) == string] if string else self.dataset
        intervals = Intervals(lambda: configured(self.name, self.settings))
        try:
            with fitting(self.name):
                intervals.fit(thinned(points), self.seed)
        except TooFew as error:
            of = f"points of {string}" if string else "points"
            raise BadInput(self.source, of, str(error), "record more strokes, or more samples a stroke") from None
        if string and len(points) < len(self.dataset):
            intervals.measure = replace(intervals.measure, string=string)  # others were recorded otherwise
        return intervals

    def _answer(self, intervals: Intervals) -> Answer:
        """What answers questions by a fit."""

        def answer(part: pd.DataFrame, from_column: str) -> pd.DataFrame:
            with fitting(self.name):  # between recorded loads more is fitted
                return with_intervals(intervals, part, from_column, self.level)

        return answer
