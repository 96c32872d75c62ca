"""Questions beside their answers: each with an interval, or with the reason why it has none."""

import math
from collections.abc import Callable

import pandas as pd

from ..inside.assumed_stiffness import STIFFNESS
from ..inside.changed_together import changed_together
from ..inside.impossible import impossible
from ..inside.why import Kind, Why
from .bad_rows import reason
from .foreseen import GIVEN, MAPS
from .prediction_intervals import Intervals
from .question_points import ASKED, EITHER, Questions, by_known
from .unanswered import reasons

ASSUMED = "its stiffness is assumed, {:.4g} N/mm, the usual one of its radius and length"


def with_intervals(intervals: Intervals, points: pd.DataFrame, from_column: str, level: float) -> pd.DataFrame:
    """Value, low and high in the answer's unit, whether the question lies inside, and why not, as `Why` of each.

    Where there is no interval low and high are no numbers.
    """
    wanted = GIVEN[from_column]
    interval = getattr(intervals, MAPS[wanted])(points, level)
    why = reasons(intervals, points, wanted, interval["inside"].to_numpy(bool), level)
    interval = interval.replace([-math.inf, math.inf], math.nan)
    answered = interval.rename(columns={"value": wanted, "low": f"{wanted}_low", "high": f"{wanted}_high"})
    return answered.assign(why=why)


def beside_questions(
    questions: Questions,
    answer: Callable[[pd.DataFrame, str], pd.DataFrame],
    recorded: pd.DataFrame,
    by_equations: bool = False,
) -> pd.DataFrame:
    """The questions beside their answers; other columns, such as the load, only if the questions give them.

    `recorded` are the points that the model was fitted to: a contraction that cannot be beside them is left out, and of
    a new string it is said what changed together among them, unless the model answers `by_equations`.
    Where some rows ask for the twist and others for the contraction, the column `asked_for` says which. A row that is
    no question stays in its place, without an answer: its reason is in `why`, of which each is a `Why`.
    """
    points = questions.points
    others = [name for name in points if name not in (*EITHER, *ASKED) and name in questions.columns]
    together, strings = "" if by_equations else changed_together(recorded), set(recorded["string"].astype(str))
    tables = {}
    for from_column, rows, part in by_known(points):
        answers = (
            _possible(answer(part, from_column), part, recorded)
            if from_column == "motor_turns"
            else answer(part, from_column)
        )
        is_new = ~part["string"].astype(str).isin(strings)
        answers["why"] = [
            why.also(Kind.TOGETHER, together * new) for why, new in zip(answers["why"], is_new, strict=True)
        ]
        whys = zip(answers["why"], part[STIFFNESS], questions.is_assumed[rows], strict=True)
        answers["why"] = [
            why.also(Kind.ASSUMED, ASSUMED.format(stiffness) * bool(assumed)) for why, stiffness, assumed in whys
        ]
        tables[from_column] = pd.concat([part[[from_column, *ASKED, *others]], answers], axis=1)
        tables[from_column].index = rows
    if len(tables) == 1:
        return _with_bad(next(iter(tables.values())), questions)
    whole = pd.concat(
        [table.assign(asked_for=GIVEN[from_column]) for from_column, table in tables.items()]
    ).sort_index()
    first = ["asked_for", *EITHER, *ASKED, *others]
    last = ["inside", "why"]
    return _with_bad(whole[[*first, *(name for name in whole if name not in (*first, *last)), *last]], questions)


def _possible(answers: pd.DataFrame, points: pd.DataFrame, recorded: pd.DataFrame) -> pd.DataFrame:
    """Answers without the contractions that cannot be, each with its reason in place of the number."""
    reasons_why_not = impossible(points, answers["displacement_mm"].to_numpy(float), recorded)
    is_possible = pd.Series([not sentence for sentence in reasons_why_not], answers.index)
    numbers = [name for name in answers if str(name).startswith("displacement_mm")]
    whys = [why.also(Kind.IMPOSSIBLE, sentence) for why, sentence in zip(answers["why"], reasons_why_not, strict=True)]
    possible = answers.assign(inside=answers["inside"] & is_possible, why=whys)
    possible[numbers] = answers[numbers].where(is_possible, math.nan)
    return possible


def _with_bad(table: pd.DataFrame, questions: Questions) -> pd.DataFrame:
    """The answers in the order of the file's rows, and the reasons in the rows that are bad."""
    if not questions.bad:
        return table
    why = [Why().also(Kind.NO_QUESTION, reason(entry)) for entry in questions.bad]
    bad_cells = questions.cells[[name for name in questions.cells if name in table]]
    both = pd.concat([table.set_axis(questions.rows[table.index], axis=0), bad_cells.assign(inside=False, why=why)])
    return both[list(table.columns)].sort_index().astype({"inside": bool})
