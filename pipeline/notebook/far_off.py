"""Answers that may be far off, in sentences below the answers, and the model to compare them with: the equations."""

import numpy as np
import pandas as pd

from ..ground.kinematics import knows_load
from ..ground.model_names import EQUATIONS, NOMINAL
from ..models.interface import about
from ..models.parts.inside.unrecorded_loads import at_unrecorded_loads, beyond_all_loads, in_unrecorded_strokes
from ..models.parts.inside.why import Kind
from ..models.parts.questions.bad_rows import numbered
from ..models.parts.questions.question_points import Questions
from .better_source import Beside

FAR_OFF = "the string was not recorded under this load{there}, and the numbers of {model} may be far off."
NO_LOAD = "The equation of a twisted pair knows no load: record the string under it."
BEYOND = "no string was recorded under such a load, and the numbers of {model} may be far off. Record one under it."
TOGETHER = (
    "what sets a new string apart changed together among the recorded ones, and the numbers of {model} may be far off. "
    "The column `why` names it, and what to record."
)
COMPARE = " To compare, what the equations answer:"


def far_off(
    questions: Questions,
    dataset: pd.DataFrame,
    table: pd.DataFrame,
    model: str,
    beside: Beside,
) -> list[tuple[str, str]]:
    """Which rows have answers that may be far off, by the model that answered, each with the one to compare them with.

    `table` are the answers beside the questions about a dataset. The model to compare with, whose command belongs below
    the sentence, is empty where there is none.
    """
    points, by_equations = questions.points, about(model).by_equations
    is_outside = ~table["inside"].to_numpy()[questions.rows]
    has_load, sentences = knows_load(points), list[tuple[str, str]]()
    strokes_apart = in_unrecorded_strokes(points, dataset) & is_outside
    for is_apart, where in ((at_unrecorded_loads(points, dataset), ""), (strokes_apart, " in such a stroke")):
        words = FAR_OFF.format(there=where, model=model)
        if rows := (questions.rows[is_apart & is_outside & has_load & (not by_equations)] + 1).tolist():
            equations = beside.of_equations(model, EQUATIONS)
            sentences.append((f"{numbered(rows).capitalize()}: {words} {equations}{COMPARE}", EQUATIONS))
        if rows := (questions.rows[is_apart & ~has_load & (is_outside | by_equations)] + 1).tolist():
            sentences.append((f"{numbered(rows).capitalize()}: {words} {NO_LOAD}", ""))
    if any(compare == EQUATIONS for _, compare in sentences):
        sentences.append((beside.of_simulator, ""))
    is_together = np.array([why.tells(Kind.TOGETHER) for why in table["why"]], bool)[questions.rows]
    new = [(is_together, TOGETHER), (beyond_all_loads(points, dataset), BEYOND)]
    of_new = [
        f"{numbered((questions.rows[where] + 1).tolist()).capitalize()}: {words}" for where, words in new if where.any()
    ]
    last = len(of_new) - 1
    for place, words in enumerate(of_new):
        compare = "" if by_equations or place < last else NOMINAL
        equations = f" {beside.of_equations(model, NOMINAL)}" * bool(
            compare and words.endswith(BEYOND) and has_load.all()
        )
        sentences.append((words.format(model=model) + equations + COMPARE * bool(compare), compare))
    return sentences
