"""The sizes of the string that a question is about: a recorded string has its own, a new one those that are told."""

from typing import NamedTuple

import numpy as np
import pandas as pd

from ....ground.input.cell_numbers import cell_numbers
from ....ground.kinematics import Mask, usual_stiffness
from ..box import SIZES
from ..inside.assumed_stiffness import STIFFNESS, is_never_measured
from .bad_rows import BadRow, of_mask
from .question_table import recorded_values, string_meant

ALIKE = 1e-3  # relative: a size that is told so near to the recorded one is that one, rounded
NEW = "of these sizes"  # the name of a string that a question tells by its sizes alone, where no recorded one has them


class Sized(NamedTuple):
    """Questions with the sizes of their strings, the rows that are wrong, and where the stiffness is assumed."""

    questions: pd.DataFrame
    wrong: list[BadRow]
    is_assumed: Mask  # (rows,), without unit


def with_own_sizes(questions: pd.DataFrame, dataset: pd.DataFrame) -> Sized:
    """Questions with the sizes of their strings filled in, and the rows that tell a recorded string another size.

    Only sizes that vary between strings and never within one are filled in. Where no string is told, a row is about the
    string that alone has its sizes, and about a new one where none has them. A new string has the usual stiffness if
    none is told and none of the recorded strings' was measured.
    """
    own, wrong = own_sizes(dataset), list[BadRow]()
    nowhere = np.zeros(len(questions), bool)
    if "string" not in questions.columns:
        questions, wrong = _with_strings(questions, own)
    if own.columns.empty or "string" not in questions.columns:
        return Sized(questions, wrong, nowhere)
    sized, strings = questions.copy(), questions["string"].astype("string")
    for name in own.columns:
        recorded = strings.map(own[name]).astype(float)
        if name not in questions.columns:
            sized[name] = recorded
            continue
        sizes = cell_numbers(questions[name])
        is_other = (sizes.notna() & recorded.notna() & ~_alike(sizes, recorded)).to_numpy(bool)
        each = [f"is {size:g}" for size in sizes[is_other]]
        for entry, string in zip(of_mask(is_other, name, each, "", ""), strings[is_other], strict=True):
            of_string = f", and string {string} has {own.loc[string, name]:g}"
            mend = f"leave {name} out of questions about recorded strings, which have their own"
            wrong.append(entry._replace(instead=of_string, mend=mend))
        sized[name] = questions[name].where(questions[name].notna(), recorded)
    is_new = (strings.notna() & ~strings.isin(own.index)).to_numpy(bool)
    is_assumed = nowhere
    if STIFFNESS in own.columns and is_never_measured(dataset):
        is_assumed = is_new & sized[STIFFNESS].isna().to_numpy()
        usual = _usual_stiffness(sized, dataset)
        sized[STIFFNESS] = sized[STIFFNESS].where(~is_assumed, usual)
    untold = sized[list(own.columns)].isna() & np.column_stack([is_new] * len(own.columns))
    if is_assumed.any():
        untold[STIFFNESS] = False  # it follows from the others
    return Sized(sized, [*wrong, *_untold(questions, strings, untold, dataset)], is_assumed)


def told_by(dataset: pd.DataFrame) -> list[str]:
    """The columns by which a new string is told: the sizes that differ, but for a stiffness that nobody measured."""
    own = own_sizes(dataset).columns
    return [name for name in own if name != STIFFNESS or not is_never_measured(dataset)]


def _untold(questions: pd.DataFrame, strings: pd.Series, untold: pd.DataFrame, dataset: pd.DataFrame) -> list[BadRow]:
    """The rows about a new string of which a size is not told, each with all of them."""
    wrong = []
    for row in np.flatnonzero(untold.any(axis=1)):
        names = [name for name in untold if untold[name].iloc[row]]
        meant = string_meant(str(strings.iloc[row]), sorted(set(dataset["string"].astype(str))))
        empty = [name for name in names if name in questions.columns]
        if empty:
            what = "are empty" if len(empty) > 1 else "is empty"
            mend = f"a new string needs {' and '.join(names)}; {recorded_values(dataset['string'])}{meant}"
            wrong.append(BadRow(int(row) + 1, " and ".join(empty), what, "", mend))
            continue
        are = "are" if len(names) > 1 else "is"
        strange = f", which has no recording{meant}, and its {' and '.join(names)} {are} not told"
        columns = f"column{'s' * (len(names) > 1)} {' and '.join(names)}"
        mend = f"{recorded_values(dataset['string'])}; of a new string add the {columns}"
        wrong.append(BadRow(int(row) + 1, "string", f"is {strings.iloc[row]}", strange, mend))
    return wrong


def _usual_stiffness(sized: pd.DataFrame, dataset: pd.DataFrame) -> pd.Series:
    """The usual stiffness of each question's string, in N/mm; NaN where its sizes are not told."""
    radius_mm, length_mm = (
        cell_numbers(sized[name]) if name in sized else dataset[name].iloc[0] for name in ("radius_mm", "length_mm")
    )
    return pd.Series(usual_stiffness(radius_mm, length_mm), index=sized.index)


def own_sizes(dataset: pd.DataFrame) -> pd.DataFrame:
    """By string, the sizes that vary between strings and never within one."""
    varying = [name for name in SIZES if name in dataset and dataset[name].nunique(dropna=False) > 1]
    by_string = dataset.groupby(dataset["string"].astype(str))[varying]
    constant = by_string.nunique(dropna=False).eq(1).all()
    return by_string.first()[[name for name in varying if constant[name]]]


def _with_strings(questions: pd.DataFrame, own: pd.DataFrame) -> tuple[pd.DataFrame, list[BadRow]]:
    """Questions with the string whose sizes each row tells, a new one where none has them; as they are without sizes.

    A row with sizes of several strings is wrong.
    """
    told_sizes = [name for name in own.columns if name in questions.columns]
    if not told_sizes:
        return questions, []
    sizes = questions[told_sizes].apply(cell_numbers)
    fits = pd.DataFrame({string: _fits(sizes, own.loc[string, told_sizes]) for string in own.index})
    count = fits.sum(axis=1).to_numpy()
    names = fits.idxmax(axis=1).where(count == 1, NEW)
    having = [" and ".join(fits.columns[row]) for row in fits[count > 1].to_numpy()]
    several = of_mask(count > 1, "string", "is not told", "", "add the column string")
    wrong = [
        entry._replace(instead=f", and these are sizes of {strings}")
        for entry, strings in zip(several, having, strict=True)
    ]
    return questions.assign(string=names), wrong


def _fits(sizes: pd.DataFrame, recorded: pd.Series) -> pd.Series:
    """Whether each row of sizes, some of which may be empty, is of a recorded string; of shape (rows,)."""
    return (_alike(sizes, recorded) | sizes.isna()).all(axis=1) & sizes.notna().any(axis=1)


def _alike(sizes: pd.DataFrame | pd.Series, recorded: pd.Series) -> pd.DataFrame | pd.Series:
    """Whether sizes are the recorded ones, but for how they are rounded; of the shape of `sizes`, without unit."""
    return (sizes - recorded).abs() <= ALIKE * recorded.abs()
