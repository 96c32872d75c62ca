"""Datasets that the model tests share; read-only: a test that changes one copies it first."""

import pandas as pd
import pytest
from made_dataset import made_dataset, pair_dataset


@pytest.fixture(scope="session")
def points() -> pd.DataFrame:
    """A small made dataset of one string with separator, 9 strokes."""
    return made_dataset(per_phase=60)


@pytest.fixture(scope="session")
def pair_points() -> pd.DataFrame:
    """A small made dataset of a twisted pair, whose separator and torsion zone are NaN."""
    return pair_dataset()
