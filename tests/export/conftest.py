"""Exported models that the tests share: fitted, written and compiled once."""

from collections.abc import Callable
from functools import cache

import pytest
from compiled import Compiled, compiled
from made_models import saved

from pipeline.export.interface import Source
from pipeline.export.source import Beside, opened


@pytest.fixture(scope="session")
def source(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str, str], Source]:
    """The source of a model by its name and its dataset's."""

    @cache
    def source_of(name: str, kind: str) -> Source:
        string = "s2" if (name, kind) == ("calibrated", "campaign") else None
        return opened(saved(name, kind, tmp_path_factory.mktemp(kind)), None, Beside(string=string))

    return source_of


@pytest.fixture(scope="session")
def program(
    source: Callable[[str, str], Source], tmp_path_factory: pytest.TempPathFactory
) -> Callable[[str, str, str], Compiled]:
    """The compiled header of a model by its name, its dataset's and the type of its numbers."""

    @cache
    def compiled_header(name: str, kind: str, real: str) -> Compiled:
        return compiled(source(name, kind), tmp_path_factory.mktemp("c"), real)

    return compiled_header
