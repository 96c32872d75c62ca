"""The sizes of the string that a question is about: a recorded string has its own, and no question gives it others."""

import numpy as np
import pandas as pd

from ....ground.input.cell_numbers import cell_numbers
from ....ground.kinematics import usual_stiffness
from ..box import SIZES
from .bad_rows import BadRow, of_mask
from .question_table import recorded_values

STIFFNESS = "stiffness_n_per_mm"
ALIKE = 1e-3  # relative: a size that is told so near to the recorded one is that one, rounded


def with_own_sizes(questions: pd.DataFrame, dataset: pd.DataFrame) -> tuple[pd.DataFrame, list[BadRow]]:
    """Questions with the sizes of their strings filled in, and the rows that tell a recorded string another size.

    Only sizes that vary between strings and never within one are filled in. Where no string is told and the sizes of
    each row are those of one string alone, that string is filled in. A new string has the usual stiffness if none is
    told and none of the recorded strings' was measured.
    """
    own = _own_sizes(dataset)
    if own.empty or own.columns.empty:
        return questions, []
    questions = questions if "string" in questions.columns else _with_strings(questions, own)
    if "string" not in questions.columns:
        return questions, []
    sized, wrong = questions.copy(), list[BadRow]()
    strings = questions["string"].astype("string")
    is_strange = (strings.notna() & ~strings.isin(own.index)).to_numpy(bool)
    for name in own.columns:
        recorded = strings.map(own[name]).astype(float)
        if name not in questions.columns:
            sized[name] = recorded.fillna(_usual_stiffness(sized, dataset)) if name == STIFFNESS else recorded
            is_unknown = is_strange & sized[name].isna().to_numpy()
            each = [f"is {string}" for string in strings[is_unknown]]
            strange = f", which has no recording, and its {name} is not told"
            mend = f"{recorded_values(dataset['string'])}; of a new string add the column {name}"
            wrong += of_mask(is_unknown, "string", each, strange, mend)
            continue
        sizes = cell_numbers(questions[name])
        is_other = (sizes.notna() & recorded.notna() & ~_alike(sizes, recorded)).to_numpy(bool)
        each = [f"is {size:g}" for size in sizes[is_other]]
        for entry, string in zip(of_mask(is_other, name, each, "", ""), strings[is_other], strict=True):
            of_string = f", and string {string} has {own.loc[string, name]:g}"
            mend = f"leave {name} out of questions about recorded strings, which have their own"
            wrong.append(entry._replace(instead=of_string, mend=mend))
        sized[name] = questions[name].where(questions[name].notna(), recorded)
    return sized, wrong


def _usual_stiffness(sized: pd.DataFrame, dataset: pd.DataFrame) -> pd.Series:
    """The usual stiffness of each question's string, in N/mm; NaN if that of a recorded string was measured."""
    radius_mm, length_mm = (
        cell_numbers(sized[name]) if name in sized else dataset[name].iloc[0] for name in ("radius_mm", "length_mm")
    )
    is_assumed = np.allclose(dataset[STIFFNESS], usual_stiffness(dataset["radius_mm"], dataset["length_mm"]), rtol=1e-6)
    usual = usual_stiffness(radius_mm, length_mm) if is_assumed else np.nan
    return pd.Series(usual, index=sized.index)


def _own_sizes(dataset: pd.DataFrame) -> pd.DataFrame:
    """By string, the sizes that vary between strings and never within one."""
    varying = [name for name in SIZES if name in dataset and dataset[name].nunique(dropna=False) > 1]
    by_string = dataset.groupby(dataset["string"].astype(str))[varying]
    constant = by_string.nunique(dropna=False).eq(1).all()
    return by_string.first()[[name for name in varying if constant[name]]]


def _with_strings(questions: pd.DataFrame, own: pd.DataFrame) -> pd.DataFrame:
    """Questions with the string whose sizes each row tells; as they are where a row fits none or several."""
    told_sizes = [name for name in own.columns if name in questions.columns]
    if not told_sizes:
        return questions
    sizes = questions[told_sizes].apply(cell_numbers)
    fits = [_alike(sizes, own.loc[string, told_sizes]).all(axis=1) for string in own.index]
    if not (sum(fit.astype(int) for fit in fits) == 1).all():
        return questions
    string = np.select([fit.to_numpy() for fit in fits], list(own.index), default="")
    return questions.assign(string=string)


def _alike(sizes: pd.DataFrame | pd.Series, recorded: pd.Series) -> pd.DataFrame | pd.Series:
    """Whether sizes are the recorded ones, but for how they are rounded; of the shape of `sizes`, without unit."""
    return (sizes - recorded).abs() <= ALIKE * recorded.abs()
