"""What a person reads in the reference names every field of what is given, and every column of its tables."""

import dataclasses
import re
from pathlib import Path

import pytest

import pipeline as tb
from pipeline.ground.stored import schemas

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
