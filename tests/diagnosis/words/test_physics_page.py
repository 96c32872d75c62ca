"""docs/physics.md says what the library's own data say."""

from pathlib import Path

import pytest

from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.words.physics_page import entry, page

PAGE = Path(__file__).parents[3] / "docs" / "physics.md"


def test_the_page_is_what_the_library_makes() -> None:
    mend = "python -m pipeline.diagnosis.words.physics_page > docs/physics.md"
    assert PAGE.read_text(encoding="utf-8") == page(), mend


@pytest.mark.parametrize("id_", sorted(mechanisms()))
def test_each_mechanism_has_an_equation_a_source_and_what_tells_it_apart(id_: str) -> None:
    one = mechanisms()[id_]
    assert all((one.equation, one.source, one.told_apart_by, one.confused_with, one.driver))
    assert "physics.md" not in one.source, "a source is one that a reader can find"
    said = entry(one)
    assert f"`{one.equation}`" in said and f"- source: {one.source}" in said
