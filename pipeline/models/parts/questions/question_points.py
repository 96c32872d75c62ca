"""Questions as points of a dataset: each row gives the twist or the contraction, and asks for the other."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ....ground.command import command
from ....ground.errors import BadInput
from ....ground.input.cell_numbers import cell_numbers
from ....ground.kinematics import Mask
from ...interface import names_for_new_strings
from ..box import COLUMNS
from ..conditions import Conditions
from ..settings import shown
from .bad_rows import BadRow, first_of_each, of_mask, refusal
from .even_rows import EvenRows
from .own_sizes import NEW, own_sizes, told_by, with_own_sizes
from .question_table import bad_cells, known_columns, missing_columns, question_table, recorded_values, string_meant

ASKED = ("stroke", "direction")  # every question must tell
WAYS = {1: "winding", -1: "unwinding"}
MOST_STROKE = 10**9  # that a question may be about: any number that a person means
EITHER = ("motor_turns", "displacement_mm")  # one of which a question tells, to be answered the other
LABELS = ("actuator", "string", "material", "phase")  # columns of words that are read


@dataclass(frozen=True)
class Questions:
    """The questions of a file: `points` are those that can be answered, with the dataset's columns; numbered anew.

    In each point the wanted one of twist and contraction is NaN.
    """

    points: pd.DataFrame
    columns: list[str]  # that the file has
    rows: NDArray[np.intp]  # (points,): their places in the file, from 0, without unit
    bad: list[BadRow]  # the other rows, each by the first thing that is wrong with it
    cells: pd.DataFrame  # what stands in the bad rows, numbers alone; the index is the row, from 0
    is_assumed: Mask  # (points,): whether nobody told or measured the stiffness, without unit


def read_questions(path: Path, dataset: pd.DataFrame, each_string: bool = False) -> Questions:
    """Questions of a csv or a workbook about a dataset. What does not vary in it need not be told, nor what the
    recordings of the string say of its sizes.

    With `each_string` a row about a string that was not recorded is no question. Raises BadInput naming all columns
    that are missing, or all rows where none can be answered.
    """
    return _questions(question_table(path, _known(dataset), LABELS), path, dataset, each_string)


def questions_of(table: pd.DataFrame, dataset: pd.DataFrame, each_string: bool = False) -> Questions:
    """Questions of a table about a dataset, a row each, as those of a csv; raises BadInput as for a csv.

    Its complaints name a row by its label in the table's index.
    """
    source = Path("questions")
    known_table = known_columns(table.reset_index(drop=True), source, _known(dataset))
    return _questions(EvenRows(known_table, [], []), source, dataset, each_string, table.index)


def _known(dataset: pd.DataFrame) -> list[str]:
    """The columns that questions about a dataset may have."""
    return [name for name in (*COLUMNS, *LABELS) if name in dataset]


def _questions(
    rows: EvenRows, path: Path, dataset: pd.DataFrame, each_string: bool, index: pd.Index | None = None
) -> Questions:  # fmt: skip
    """Questions of rows whose columns are known; `path` is where they are from, `index` theirs, for complaints."""
    labels = {name: rows.table[name].map(_bare) for name in LABELS if name in rows.table}
    questions = rows.table.assign(**labels)
    from_columns = [name for name in EITHER if name in questions.columns]
    if not from_columns:
        problem = f"are {', '.join(map(repr, questions.columns))}: neither of {' and '.join(EITHER)}"
        raise BadInput(path, "columns", problem, "tell one of the two, and the other is answered; commas part columns")
    if questions.empty:
        raise BadInput(path, "rows", "there are none", "write one question a line")
    columns = list(questions.columns)
    questions, wrong, is_assumed = with_own_sizes(questions, dataset)
    own = own_sizes(dataset).columns
    points, missing = pd.DataFrame(index=range(len(questions))), list[str]()
    for name in dataset.columns:
        if name in questions.columns:
            may_be_empty = len(from_columns) == len(EITHER) and name in EITHER
            numeric = name in (*COLUMNS, *ASKED)
            wrong += bad_cells(questions[name], dataset[name], numeric, may_be_empty)
            in_numbers = cell_numbers(questions[name]) if numeric else questions[name]
            points[name] = in_numbers.to_numpy()
        elif name in EITHER:
            points[name] = np.nan
        elif name == "load_n" and not Conditions.of(dataset, ("load_n",)).names:
            points[name] = dataset[name].median()  # what little it varies is its cell's noise
        elif name in own and "string" in missing:
            points[name] = np.nan  # a recorded string brings it
        elif name in (*COLUMNS, "actuator", "string") and dataset[name].nunique(dropna=False) > 1:
            missing.append(name)
        else:
            points[name] = dataset[name].iloc[0]
    if missing:
        raise missing_columns(path, dataset[missing], dataset[told_by(dataset)])
    strange = _unrecorded(points["string"], dataset) if each_string else []
    wrong += [*strange, *_bad_rows(path, questions, points, dataset)]
    wrong_rows = {entry.row for entry in wrong}
    lacking = [entry for entry in rows.shorter if entry.row in wrong_rows]  # others leave out what may be empty
    bad = first_of_each([*rows.longer, *lacking, *wrong])
    if len(bad) == len(points):
        raise refusal(path, bad, answered=0, index=index)
    is_bad = np.isin(np.arange(len(points)), [entry.row - 1 for entry in bad])
    good = points[~is_bad].reset_index(drop=True)
    good["stroke"] = good["stroke"].astype(np.int64)
    kept = [name for name in points if name in columns]
    return Questions(good, columns, np.flatnonzero(~is_bad), bad, points.loc[is_bad, kept], is_assumed[~is_bad])


def _bare(cell: object) -> object:
    """A cell without the white space around a word."""
    return cell.strip() if isinstance(cell, str) else cell


def by_known(points: pd.DataFrame) -> Iterator[tuple[str, NDArray[np.intp], pd.DataFrame]]:
    """For twist and contraction, if some rows give it: the places of these rows, and the rows, numbered anew.

    Places have the shape (rows,), without unit.
    """
    for name in EITHER:
        rows = np.flatnonzero(points[name].notna())
        if len(rows):
            yield name, rows, points.iloc[rows].reset_index(drop=True)


def _bad_rows(path: Path, questions: pd.DataFrame, points: pd.DataFrame, dataset: pd.DataFrame) -> list[BadRow]:
    """The rows that ask nothing, two things, or something impossible; raises BadInput for another actuator."""
    given_by = [points[name].notna().to_numpy() for name in EITHER]
    both, neither = " and ".join(EITHER), " nor ".join(EITHER)
    strange = (points["actuator"].notna() & ~points["actuator"].isin(set(dataset["actuator"]))).to_numpy()
    if strange.any():
        actuator = points["actuator"].astype(str)[strange].iloc[0]
        problem = f"is {shown(actuator)}, and the recordings are of {' and '.join(sorted(set(dataset['actuator'])))}"
        raise BadInput(path, "actuator", problem, "ask a dataset of that actuator")
    mend = "leave the cell empty that is to be answered"
    bad = of_mask(given_by[0] & given_by[1], "", f"tells both {both}", "", mend)
    mend = "fill in the one that is known; the other is answered"
    bad += of_mask(~(given_by[0] | given_by[1]), "", f"tells neither {neither}", "", mend)
    strokes = points["stroke"].to_numpy(float)
    strange = ~((strokes == np.floor(strokes)) & (strokes >= 1.0) & (strokes <= MOST_STROKE))
    each = [f"is {stroke:g}" for stroke in strokes[strange]]
    bad += of_mask(strange, "stroke", each, ", no whole number from 1", "the first stroke of a new string is 1")
    strange = ~points["direction"].isin(WAYS).to_numpy()
    each = [f"is {way:g}" for way in points["direction"][strange].astype(float)]
    bad += of_mask(strange, "direction", each, ", neither 1 nor -1", "1 is winding, -1 unwinding")
    if "phase" in questions:
        strange = (points["phase"].astype(str) != points["direction"].map(WAYS)).to_numpy()
        each = [f"is {shown(str(phase))}" for phase in points["phase"][strange]]
        holds = f"what a hold or a rest adds: {command('simulate')} --motion"
        mend = f"leave the column out: a question is of a motor that turns; {holds}"
        bad += of_mask(strange, "phase", each, "", mend)
    return bad


def _unrecorded(strings: pd.Series, dataset: pd.DataFrame) -> list[BadRow]:
    """The rows about a string without a recording, where no model answers for that string alone."""
    strange = (strings.notna() & ~strings.astype(str).isin(set(dataset["string"].astype(str)))).to_numpy()
    is_untold, takers = (strings == NEW).to_numpy(bool), ", ".join(names_for_new_strings())
    mend = f"{recorded_values(dataset['string'])}; a new string is answered by the models {takers}"
    names = sorted(set(dataset["string"].astype(str)))
    others = [str(string) for string in strings[strange & ~is_untold]]
    each = [f"is {shown(string)}" for string in others]
    bad = [
        entry._replace(instead=f"{entry.instead}{string_meant(string, names)}")
        for entry, string in zip(
            of_mask(strange & ~is_untold, "string", each, ", which has no recording", mend), others, strict=True
        )
    ]
    return bad + of_mask(strange & is_untold, "string", "is not told", ", and no recorded one has these sizes", mend)
