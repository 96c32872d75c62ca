"""MATLAB files are read in forks of the tests, which have the imports; what a bare start shows, two tests look at."""

import pytest
from forked import fork_the_reader

BARE = (
    "test_a_matlab_file_gives_its_vectors_in_our_units",
    "test_a_byte_that_crashes_the_reader_of_matlab_files_is_refused_in_words",
)


@pytest.fixture(autouse=True)
def forked(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    if request.node.name not in BARE:
        fork_the_reader(monkeypatch)
