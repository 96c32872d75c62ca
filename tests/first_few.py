"""The first few values of a test are tried in every run of the tests, the rest in those that take long."""

from collections.abc import Iterable

import pytest


def first_few(values: Iterable[object], most: int = 1) -> list[object]:
    """The values for `parametrize`, with all but the first `most` of them marked long."""
    each = list(values)
    late = [value if isinstance(value, tuple) else (value,) for value in each[most:]]
    return each[:most] + [pytest.param(*value, marks=pytest.mark.long) for value in late]
