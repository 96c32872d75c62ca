"""Questions beside the answers of a saved model, each with whether it is inside, and why not."""

from functools import cache
from pathlib import Path

import pandas as pd

from ..models.interface import about
from ..models.parts.inside.measure import Measure, measures
from ..models.parts.questions.beside_questions import beside_questions
from ..models.parts.questions.each_string import Answer, by_string
from ..models.parts.questions.question_points import Questions
from ..models.parts.questions.strings_alike import strings_alike, with_whom
from ..models.parts.rolling_origin import last_strokes
from ..models.parts.saved_files import check_own
from .all_points import string_alone
from .asked import answers
from .interface import Source, names
from .source import Beside, opened


def model_of(file: Path) -> str:
    """The name of the model that a file holds: its folder's, as its export takes it."""
    return file.resolve().parent.name


def keeps_strings_apart(file: Path) -> bool:
    """Whether the model of a file answers for each recorded string alone."""
    return model_of(file) in names() and about(model_of(file)).each_string_apart


def saved_answers(file: Path, dataset: pd.DataFrame, questions: Questions, dataset_file: Path) -> pd.DataFrame:
    """Questions beside the answers of a file's model; a model with separate strings answers for each of them.

    `dataset` are the points of the `dataset_file`. Raises BadInput where the file was fitted to another dataset, or
    holds no model that can be asked.
    """
    check_own(file, dataset_file)
    strings, alone = questions.points["string"], string_alone(file)
    fitted = dataset[dataset["string"].astype(str) == alone] if alone else dataset
    last, is_apart = last_strokes(fitted), keeps_strings_apart(file)

    @cache
    def asked_of(string: str | None) -> tuple[Source, dict[str, Measure]]:
        source = opened(file, None, Beside(dataset=dataset_file, string=string))
        return source, measures(fitted, source.foreseen[1] if source.foreseen else 0)

    def answer_of(string: str) -> Answer:
        source, by_name = asked_of(string if is_apart else None)
        measure = by_name.get(string, by_name[""])
        return lambda part, from_column: answers(source, part, from_column, file, measure, last)

    by_equations = model_of(file) in names() and about(model_of(file)).by_equations
    table = beside_questions(questions, by_string(answer_of), fitted, by_equations)
    if is_apart:
        return table
    return with_whom(table, strings.set_axis(questions.rows, axis=0), strings_alike(fitted))
