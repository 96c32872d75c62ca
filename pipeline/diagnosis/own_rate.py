"""A recording at its own rate: what is simulated, what an error is scored on, what an explanation is refitted to."""

import pandas as pd

from ..run.description import Run
from .engine import make_problem
from .problem import Problem

POLISHED_SAMPLES = 100_000  # that an explanation is refitted to: a longer recording is averaged to so many
SCORED_SAMPLES = 1_000_000  # that an error is told from


def at_own_rate(runs: list[Run], tables: list[pd.DataFrame], thin: bool = True, to_fit: bool = True) -> Problem:
    """The problem at the recording's own rate, for simulation only; `thin`: at most at the system's working rate.

    Unless `to_fit`, the motion may be too short to be diagnosed: one stroke will do.
    """
    return make_problem(runs, tables, most=sum(map(len, tables)), thin=thin, to_fit=to_fit)


def to_score(runs: list[Run], tables: list[pd.DataFrame]) -> Problem:
    """What an error is scored on: the recording's own samples, of a very long one each second, third, … sample.

    Where a system follows derivatives the samples are averaged to its working rate anyway, and none is passed over.
    """
    each = 1 if runs[0].system.differentiates else -(-sum(map(len, tables)) // SCORED_SAMPLES)
    return at_own_rate(runs, tables if each < 2 else [table.iloc[::each].reset_index(drop=True) for table in tables])


def to_polish(runs: list[Run], tables: list[pd.DataFrame], fine: Problem) -> Problem:
    """What an explanation is refitted to: `fine`, at the recording's own rate, or averages where it is long."""
    return fine if len(fine.record) <= POLISHED_SAMPLES else make_problem(runs, tables, most=POLISHED_SAMPLES)
