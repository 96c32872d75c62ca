"""Questions about a string, answered with intervals by a model that is fitted to recorded points, in memory."""

from pathlib import Path

import pandas as pd

from ..ground.errors import BadInput
from ..models.interface import about, usual
from ..models.parts.configured import configured, fitting
from ..models.parts.questions.beside_questions import beside_questions, with_intervals
from ..models.parts.questions.prediction_intervals import Intervals, TooFew
from ..models.parts.questions.question_points import Questions, questions_of
from ..models.parts.thinned import thinned
from .as_arguments import as_arguments, settings_in_json

LEVEL = 0.9  # the probability that an interval holds the truth, unless told otherwise


def answers(
    points: pd.DataFrame, questions: pd.DataFrame, model: str = "", seed: int = 0, level: float = LEVEL, **more: object
) -> pd.DataFrame:
    """The contraction of each twist, or the twist of each contraction, that is asked about, with its interval.

    `points` are those of recordings, as `twistbench.points` gives them. `questions` has a row for each question:
    `motor_turns` (turns) or `displacement_mm` (mm), of which the other is the answer; `stroke` (from 1) and `direction`
    (1 winding, -1 unwinding); and what differs among the recordings, such as `load_n` (N). `model` is a name of
    `model_names()`, the usual one if none is given; `more` are its settings.

    The answer repeats the questions, and has the value, its interval of probability `level` (`displacement_mm_low`,
    `displacement_mm_high` in mm, or `motor_turns_low`, `motor_turns_high` in turns), `inside`, whether such a question
    was recorded, and `why` not; then it has no interval. The interval is of one reading: at 0.9 nine of ten measured
    points lie in it. Strings of the same sizes have one answer, but by `calibrated`. Displacements have the zero of
    `points`: `Recording.tare_mm` leads to the sensor's. Raises BadInput for columns that are missing or unknown, and
    where no row can be answered.
    """
    name = model or usual()
    settings = settings_in_json(name, more)
    with as_arguments():
        refuse(name, settings, level)
        return answered_anew(points, questions_of(questions, points), name, settings, seed, level, Path("points"))


def refuse(name: str, settings: str, level: float) -> None:
    """Raise BadInput for a model, settings in JSON or a level with which no question can be answered."""
    if not 0.0 < level < 1.0:
        raise BadInput("--level", str(level), "is no probability", "give a number between 0 and 1")
    configured(name, settings)  # complains before anything is fitted
    if about(name).needs_motion:
        problem = "answers along a whole motion, which single questions do not tell"
        raise BadInput("--model", name, problem, f"choose another, such as {usual()}")


def answered_anew(
    dataset: pd.DataFrame, questions: Questions, name: str, settings: str, seed: int, level: float, source: Path
) -> pd.DataFrame:
    """Questions beside the answers of a model of a name, with settings in JSON, that is fitted to a dataset's points.

    Raises BadInput where too few points of the `source` tell how the model errs.
    """
    intervals = Intervals(lambda: configured(name, settings))
    try:
        with fitting(name):
            intervals.fit(thinned(dataset), seed)
            return beside_questions(
                questions, lambda part, from_column: with_intervals(intervals, part, from_column, level)
            )
    except TooFew as error:
        raise BadInput(source, "points", str(error), "record more strokes, or more samples a stroke") from None
