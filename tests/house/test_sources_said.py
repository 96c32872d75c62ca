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
# what an estimator is made of: a module that has some is a method
ESTIMATES = re.compile(
    r"^ *from (sklearn\.(?!exceptions)|scipy\.(optimize|interpolate|stats|special import ndtr))"
    r"|\bnp\.linalg\.(lstsq|pinv)\b|\bnp\.polyfit\b|\b1\.4826\b",
    re.M,
)
# where none is asked for here: a law of a mechanism says it by `source`, one of a rig is asked above or is its author's
# own; reports and exports draw and write what others estimated
OF_LAWS = ("rig", "diagnosis/mechanisms", "systems", "report", "export")
MORE_METHODS = [  # methods in plain arithmetic, which nothing tells
    *named("diagnosis/numerics", "bounded", "judge", "noise", "recogniser", "recursions"),
    *named("diagnosis/fit", "calibrate", "discrepancy", "flexible", "gauss_newton", "generic", "intervals"),
    *named("diagnosis/fit", "uncertainty"),
    *named("diagnosis/choice", "chance", "compare", "cross_validation", "search"),
    *named("diagnosis/proposal", "design", "foretold_spread", "next_runs"),
    *named("diagnosis/study", "tempered"),
    *named("lifespan/forecast", "fitted_law", "law_choice", "laws", "strokes_left"),
    *named("models/parts", "growth", "marquardt", "rolling_origin"),
    *named("models/parts/questions", "prediction_intervals", "scatter", "stroke_errors"),
    *named("models/parts/networks", "coupling", "rational", "training"),
    *named("stages/campaign", "adapt"),
    *named("string", "recovered"),
]


def estimating() -> list[Path]:
    """Every module that estimates something, by what its code is made of."""
    paths = [path for path in sorted(PIPELINE.rglob("*.py")) if ESTIMATES.search(path.read_text(encoding="utf-8"))]
    return [path for path in paths if not path.relative_to(PIPELINE).as_posix().startswith(OF_LAWS)]


METHODS = sorted({*MORE_METHODS, *estimating()} - {*MODELS, *COMPARED})


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
    """Or that the method is our own, and on which page of docs/ it stands."""
    own = re.match(r"our own\b.*\bdocs/(\w+\.md)", source(path))
    assert (own and (PIPELINE.parent / "docs" / own[1]).is_file()) or re.search(
        r"[A-Z][a-zéö]+.*\b(1[6-9]|20)\d\d\b", source(path)
    ), source(path) or "no Source: at all"


def test_methods_are_found_by_what_they_are_made_of() -> None:
    found_by_itself = {path.relative_to(PIPELINE).as_posix() for path in estimating()}
    fresh = {"stages/floor.py", "run/spikes.py", "ground/numbers/regression.py", "diagnosis/choice/excursions.py"}
    assert fresh <= found_by_itself and len(found_by_itself) >= 30
