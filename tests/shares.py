"""How much of a fuzz is done: the first tenth in every run of the tests, all of it in those that take long."""

import pytest

shares = pytest.mark.parametrize(
    "share", [pytest.param(0.1, id="a tenth"), pytest.param(1.0, id="all", marks=pytest.mark.long)]
)
