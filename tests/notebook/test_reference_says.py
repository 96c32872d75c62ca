"""What a person reads in the reference names every field of what is given, and every column of its tables."""

import dataclasses
import inspect
import re
from pathlib import Path
from typing import get_args, get_type_hints

import pytest

import pipeline as tb
from pipeline.diagnosis.document.content import VerdictWord
from pipeline.ground.stored import schemas
from pipeline.report.parts.diagnoses import VERDICTS

API = Path(__file__).parents[2] / "docs" / "api.md"


def named(text: str | None) -> set[str]:
    return set(re.findall(r"`(\w+)`", text or ""))


@pytest.mark.parametrize("kind", [tb.Mechanism, tb.Interval], ids=lambda kind: kind.__name__)
def test_a_class_names_its_fields(kind: type) -> None:
    fields = {field.name for field in dataclasses.fields(kind)}  # type: ignore[arg-type]
    assert fields <= named(kind.__doc__), fields - named(kind.__doc__)
    entry = re.search(rf"^- `twistbench\.{kind.__name__}`:(.+?)(?=^- |^$)", API.read_text("utf-8"), re.M | re.S)
    assert entry and fields <= named(entry[1]), "the page of the reference names them too"


def test_bad_input_names_what_it_holds() -> None:
    assert set(vars(tb.BadInput("a", "b", "c", "d"))) <= named(tb.BadInput.__doc__)


@pytest.mark.parametrize(
    ("documented", "schema"),
    [(tb.Recording.strokes, schemas.STROKES), (tb.points, schemas.DATASET)],
    ids=["strokes", "points"],
)
def test_a_table_names_its_columns(documented: object, schema: object) -> None:
    columns = set(schema.names)  # type: ignore[attr-defined]
    assert columns <= named(documented.__doc__), columns - named(documented.__doc__)


def test_the_reference_shows_no_insides() -> None:
    """What only programs of the package need are functions beside the classes."""
    assert list(inspect.signature(tb.Diagnosis.of).parameters) == ["recordings", "without", "say"]
    assert {"read", "of", "strokes", "simulate"} <= set(vars(tb.Recording))
    assert not {"of_run", "recorded"} & set(vars(tb.Recording)) and not hasattr(tb.Diagnosis, "study")
    assert "recorded" not in named(tb.Diagnosis.__doc__)


def test_a_verdict_has_the_words_of_its_type() -> None:
    kinds = get_args(get_type_hints(tb.Diagnosis.verdict.fget)["return"])  # type: ignore[attr-defined]
    assert kinds == get_args(VerdictWord) == VERDICTS
    documented = re.findall(r"\w+", (tb.Diagnosis.verdict.__doc__ or "").replace(" or ", " "))
    assert tuple(documented) == kinds


def test_a_diagnosis_that_was_read_has_no_figure_and_says_so() -> None:
    content = {"run": "a-1", "verdict": "consistent", "parameters": {}, "simulation": []}
    diagnosis = tb.Diagnosis(content, "separator")  # type: ignore[arg-type]
    with pytest.raises(tb.BadInput, match=r"was read from a file\. Mend: diagnose the recording"):
        diagnosis.figure()
    assert "Raises BadInput for a diagnosis that was read" in (tb.Diagnosis.figure.__doc__ or "")
