"""docs/numbers.md says what the modules' own constants are, and each of them says what it means."""

from pathlib import Path

import pytest

from pipeline.diagnosis.choice import judged, search
from pipeline.diagnosis.words import numbers_page
from pipeline.diagnosis.words.numbers_page import DECIDE_NOTHING, ROOM, Number, by_module, numbers, page

PAGE = Path(__file__).parents[3] / "docs" / "numbers.md"
LISTED = by_module()  # once for all modules: every source of the diagnosis is parsed for it


def test_the_page_is_what_the_modules_make() -> None:
    mend = "python -m pipeline.diagnosis.words.numbers_page > docs/numbers.md"
    assert PAGE.read_text(encoding="utf-8") == page(), mend


@pytest.mark.parametrize("module", sorted(LISTED))
def test_each_number_that_decides_says_what_it_means(module: str) -> None:
    for number in LISTED[module]:
        assert len(number.meaning) > 5, f"{module}: write behind {number.names} what it means"


def test_numbers_are_there_as_they_are_and_modules_that_decide_nothing_are_modules() -> None:
    listed = {
        module: {number.names: number.value for number in module_numbers} for module, module_numbers in LISTED.items()
    }
    constants = listed["choice/judged.py"]
    assert constants["HELD"] == str(judged.HELD) and constants["UNKNOWN"] == str(judged.UNKNOWN)
    assert listed["choice/search.py"]["LEAST_GAIN, EXPLAINED"] == f"{search.LEAST_GAIN}, {search.EXPLAINED}"
    assert sum(map(len, listed.values())) > 100 and any(module.startswith("mechanisms/") for module in listed)
    assert set(DECIDE_NOTHING) <= {path.stem for path in ROOM.rglob("*.py")}


def test_a_number_is_read_with_the_comment_beside_or_above_it() -> None:
    text = (
        "# above\nA = -1.5\n\nB, C = 2, (0.1, 0.2)  # beside\nD = np.linspace(0.0, 1.0, 3)\nE = 'word'  # no number\n"
        "F = True\nlower = 3\nG = (\n    1.0,\n    2.0,\n)  # of two\n"
    )
    assert list(numbers(text)) == [
        Number("A", "-1.5", "above"),
        Number("B, C", "2, (0.1, 0.2)", "beside"),
        Number("D", "np.linspace(0.0, 1.0, 3)", ""),
        Number("G", "1.0, 2.0", "of two"),
    ]


def test_a_changed_number_is_another_page(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    (tmp_path / "mechanisms").mkdir()
    (tmp_path / "judged.py").write_text((ROOM / "choice" / "judged.py").read_text().replace("HELD = 0.8", "HELD = 0.7"))
    monkeypatch.setattr(numbers_page, "ROOM", tmp_path)
    assert "| `HELD` | `0.7` |" in page()
