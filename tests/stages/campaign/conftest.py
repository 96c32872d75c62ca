"""A made campaign that the campaign's tests share; read-only: a test that changes one copies it first."""

import pandas as pd
import pytest
from made_strings import made_campaign


@pytest.fixture(scope="session")
def campaign() -> pd.DataFrame:
    """Thirty made strings of two materials: 12 to learn on, 6 to tune on, 12 to ask about."""
    return made_campaign(30)
