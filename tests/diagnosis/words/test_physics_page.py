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
    mechanism = mechanisms()[id_]
    assert all(
        (mechanism.equation, mechanism.source, mechanism.told_apart_by, mechanism.confused_with, mechanism.driver)
    )
    assert "physics.md" not in mechanism.source, "a source is one that a reader can find"
    section = entry(mechanism)
    assert f"`{mechanism.equation}`" in section and f"- source: {mechanism.source}" in section
