"""Every method and every law says whom to read: an author or a standard, and the year."""

import ast
import re
from pathlib import Path

import pytest

import pipeline

PIPELINE = Path(pipeline.__file__).parent


def those_with(pattern: str, *folders: str) -> list[Path]:
    """The modules of some folders that hold a line of a kind."""
    paths = [path for folder in folders for path in (PIPELINE / folder).glob("*.py")]
    return sorted(path for path in paths if re.search(pattern, path.read_text(encoding="utf-8"), re.M))


def named(folder: str, *stems: str) -> list[Path]:
    return [PIPELINE / folder / f"{stem}.py" for stem in stems]


MODELS, COMPARED = those_with(r"^MODEL\b", "models"), those_with(r"^def learn\(", "proof/baselines", "real/black_boxes")
LAWS = [*those_with(r"^class Hidden\(", "rig/effects"), *those_with(r"^SYSTEMS\b", "systems")]
METHODS = [
    *named("diagnosis/numerics", "bounded", "judge", "noise", "recursions"),
    *named(
        "diagnosis/fit", "calibrate", "discrepancy", "flexible", "gauss_newton", "generic", "intervals", "uncertainty"
    ),
    *named("diagnosis/choice", "compare", "cross_validation", "search"),
    *named("diagnosis/proposal", "design", "next_runs"),
    *named("lifespan/forecast", "fitted_law", "law_choice", "laws", "strokes_left"),
    *named("models/parts", "growth", "marquardt"),
    *named("models/parts/questions", "prediction_intervals"),
    *named("models/parts/networks", "coupling", "rational", "training"),
    *named("stages/campaign", "adapt"),
]


def source(path: Path) -> str:
    """What a module says of its source, in one line."""
    match = re.search(r"\nSource: (.+)", ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or "", re.S)
    return " ".join(match[1].split()) if match else ""


@pytest.mark.parametrize("path", [*MODELS, *COMPARED], ids=lambda path: path.stem)
def test_a_model_and_a_compared_method_name_their_published_source(path: Path) -> None:
    """Whom to read: a person or a paper, after `Source:` at the end of the module's docstring."""
    assert re.search(r"[A-Z][a-z]+", source(path)) and re.search(r'\b(1[89]|20)\d\d\b|"', source(path))


@pytest.mark.parametrize("path", [*LAWS, *METHODS], ids=lambda path: f"{path.parent.name}-{path.stem}")
def test_a_law_and_a_method_name_author_and_year(path: Path) -> None:
    assert re.search(r"[A-Z][a-zé]+.*\b(1[6-9]|20)\d\d\b", source(path)), source(path) or "no Source: at all"
