"""Questions beside the answers of a saved model, each with whether it is inside, and why not."""

from dataclasses import replace
from functools import cache
from pathlib import Path

import pandas as pd

from ..models.interface import about
from ..models.parts.fitted_to import Apart, apart
from ..models.parts.inside.measure import Measure, measures
from ..models.parts.inside.why import Kind
from ..models.parts.questions.beside_questions import beside_questions
from ..models.parts.questions.each_string import Answer, by_string
from ..models.parts.questions.question_points import Questions
from ..models.parts.questions.strings_alike import strings_alike, with_whom
from ..models.parts.rolling_origin import last_strokes, most_ahead
from ..models.parts.saved_files import check_own
from .all_points import string_alone
from .asked import answers
from .interface import Source, names
from .source import Beside, opened

CHANGED = "the dataset has other points than the model was fitted to: fit it anew"


def model_of(file: Path) -> str:
    """The name of the model that a file holds: its folder's, as its export takes it."""
    return file.resolve().parent.name


def keeps_strings_apart(file: Path) -> bool:
    """Whether the model of a file answers for each recorded string alone."""
    return model_of(file) in names() and about(model_of(file)).each_string_apart


def seen_points(older: Apart | None, dataset: pd.DataFrame) -> pd.DataFrame:
    """The points of a dataset that has grown which an older model was fitted to or tested on; all of any other."""
    return dataset[dataset["run"].astype(str).isin(older.same)] if older and older.has_grown else dataset


def saved_answers(file: Path, dataset: pd.DataFrame, questions: Questions, dataset_file: Path) -> pd.DataFrame:
    """Questions beside the answers of a file's model; a model with separate strings answers for each of them.

    `dataset` are the points of the `dataset_file`. Inside is what the model was fitted to: where the dataset has grown
    since, what was recorded is that of its older runs; where older points changed, nothing is inside. Raises BadInput
    where the file was fitted to another dataset, or holds no model that can be asked.
    """
    check_own(file, dataset_file)
    strings, alone = questions.points["string"], string_alone(file)
    older = apart(file, dataset_file)
    fitted = seen_points(older, dataset)
    fitted = fitted[fitted["string"].astype(str) == alone] if alone else fitted
    last, is_apart = last_strokes(fitted), keeps_strings_apart(file)

    @cache
    def asked_of(string: str | None) -> tuple[Source, dict[str, Measure]]:
        source = opened(file, None, Beside(dataset=dataset_file, string=string))
        of_string = fitted[fitted["string"].astype(str) == string] if string else fitted
        if older and older.has_grown and len(of_string):
            strokes = int(of_string.groupby("string")["stroke"].nunique().max())
            source = replace(source, foreseen=(strokes, most_ahead(strokes)))
        return source, measures(fitted, source.foreseen[1] if source.foreseen else 0)

    def answer_of(string: str) -> Answer:
        source, by_name = asked_of(string if is_apart else None)
        measure = by_name.get(string, by_name[""])
        if older and not older.has_grown:
            box_alone = Measure(measure.box, (), None, measure.never_measured)
            return lambda part, from_column: _outside(answers(source, part, from_column, file, box_alone, last))
        return lambda part, from_column: answers(source, part, from_column, file, measure, last)

    by_equations = older is not None and not older.has_grown
    by_equations |= model_of(file) in names() and about(model_of(file)).by_equations
    table = beside_questions(questions, by_string(answer_of), fitted, by_equations)
    if is_apart:
        return table
    return with_whom(table, strings.set_axis(questions.rows, axis=0), strings_alike(fitted))


def _outside(table: pd.DataFrame) -> pd.DataFrame:
    """Answers of which none is inside, for nobody knows what was recorded of what the model was fitted to."""
    return table.assign(inside=False, why=[why.also(Kind.OUTSIDE, CHANGED) for why in table["why"]])
