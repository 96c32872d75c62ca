"""The campaign's page says what its tables say: who is best from how many strokes, what was held, what is not told."""

import json
import re

import matplotlib.pyplot as plt
import pandas as pd
import pytest

from pipeline.ground.stored import schemas
from pipeline.report.campaign import figures, page
from pipeline.report.campaign.error_sentences import CALLED, leaders, nearest, untold, without_others
from pipeline.report.campaign.results import pooled
from pipeline.stages.campaign.campaign_tables import COVERAGE, FEW_SHOT, FLOOR
from pipeline.stages.campaign.points import SCHEMA

TITLES = {"inn": "INN model", "spline": "Spline model", "calibrated": "Calibrated model"}
STRINGS = ["a", "b", "c", "d"]
KNOWN = {  # forward error in mm by way to learn and strokes shown
    ("inn", "transfer"): {0: 0.4, 1: 0.30, 2: 0.28, 5: 0.25},
    ("spline", "transfer"): {0: 0.5, 1: 0.20, 2: 0.12, 5: 0.09},
    ("spline", "alone"): {1: 0.9, 2: 0.30, 5: 0.06},
    ("calibrated", "alone"): {0: 2.0, 1: 0.8, 2: 0.7, 5: 0.6},
}
READS = {
    "inn": "stroke separator_mm length_mm radius_mm",
    "spline": " ".join(CALLED),
    "calibrated": "separator_mm length_mm radius_mm torsion_zone_mm stiffness_n_per_mm load_n",
}


@pytest.fixture
def few_shot():
    rows = [
        (model, string, ("silk", "hemp")[place % 2], how, READS[model], shots, error * (1.0 + 0.1 * place), 3.0 * error)
        for (model, how), errors in KNOWN.items()
        for shots, error in errors.items()
        for place, string in enumerate(STRINGS)
    ]
    return pd.DataFrame(rows, columns=FEW_SHOT.names)


@pytest.fixture
def floor():
    return pd.DataFrame({"string": STRINGS, "material": ["silk", "hemp"] * 2, "forward_mm": 0.05, "inverse_turns": 0.1})


@pytest.fixture
def coverage():
    """Forward as it should be; inverse ten points short at every level; a tenth of the forward points flagged."""
    rows = [
        (string, ("silk", "hemp")[place % 2], map_, ahead, level, level + by + (0.01, -0.01)[place % 2], width * ahead,
         90.0, 10.0 if map_ == "forward" else 0.0)
        for place, string in enumerate(STRINGS)
        for map_, by, width in (("forward", 0.0, 0.1), ("inverse", -0.1, 0.4))
        for ahead in (1, 2)
        for level in (0.5, 0.9)
    ]  # fmt: skip
    return pd.DataFrame(rows, columns=COVERAGE.names)


def test_the_best_are_named_with_their_medians_and_the_strings_they_win(few_shot):
    sentence = leaders(few_shot, "forward_mm", "mm", TITLES)
    assert sentence.startswith(
        "From 0 strokes INN model is best (0.460 mm median); from 1 to 2 strokes Spline model is best"
    )
    assert "from 5 strokes Spline model, alone is best (0.0690 mm median)" in sentence
    assert (
        "With 5 strokes shown Spline model, alone errs less than the second, Spline model, on 4 of 4 strings."
        in sentence
    )


def test_who_first_comes_near_the_floor_or_that_none_does(few_shot):
    sentence = nearest(few_shot, "forward_mm", "mm", 0.05, TITLES)
    assert sentence == (
        "The first to come within 2 times the floor is Spline model, alone, from 5 strokes (0.0690 mm, 1.38 times)."
    )
    assert nearest(few_shot, "forward_mm", "mm", 0.01, TITLES).startswith(
        "None comes within 2 times the floor; the nearest is Spline model, alone from 5 strokes (0.0690 mm, 6.90 times)"
    )


def test_whether_learning_from_others_pays(few_shot):
    assert "with 5 strokes shown (0.0690 against 0.104 mm)" in without_others(few_shot, "forward_mm", "mm", TITLES)
    early = few_shot[few_shot["shots"] < 5]
    assert "is never better" in without_others(early, "forward_mm", "mm", TITLES)


def test_what_a_model_cannot_tell_follows_from_what_it_reads(few_shot):
    text = "\n".join(untold(few_shot, TITLES))
    assert "INN model: cannot tell direction of motion, torsion zone d, stiffness, load, material." in text
    assert "Rank with no stroke shown, among those that learnt from others: forward 1 of 2, inverse 1 of 2." in text
    assert "Spline model: reads all of them." in text
    blind = few_shot.assign(reads="stroke")
    assert "Spline model: cannot tell direction of motion, separator b" in "\n".join(untold(blind, TITLES))


def test_coverage_is_pooled_by_points_with_an_error_over_strings(coverage):
    table = pooled(coverage, ["map", "level"]).set_index(["map", "level"])
    assert table.loc[("forward", 0.9), "held"] == pytest.approx(0.9)
    assert table.loc[("inverse", 0.5), "held"] == pytest.approx(0.4)
    assert table["outside"].tolist() == pytest.approx([0.1, 0.1, 0.0, 0.0])
    assert table["error"].to_numpy() == pytest.approx(0.01 / 3**0.5)  # two strings each at ± 0.01
    few = coverage.assign(points=coverage["points"].where(coverage["string"] != "a", 0.0))
    few["held"] = few["held"].where(few["string"] != "a")
    assert pooled(few, ["map"])["held"].notna().all()


@pytest.fixture
def written(few_shot, floor, coverage, tmp_path, monkeypatch):
    """The folder of the program's reports, run on the made tables."""
    parts = {
        "string": [*STRINGS, "e", "f"],
        "strings": ["test"] * 4 + ["train", "tune"],
        "material": ["silk", "hemp"] * 3,
    }
    points = pd.DataFrame({name: parts.get(name, [1] * 6) for name in SCHEMA.names})
    points = points.astype({field.name: "str" for field in SCHEMA if field.type == "string"})
    for name, table, schema in (
        ("points", points, SCHEMA),
        ("few", few_shot, FEW_SHOT),
        ("floor", floor, FLOOR),
        ("coverage", coverage, COVERAGE),
    ):
        schemas.write(table, schema, tmp_path / f"{name}.parquet")
    arguments = [
        "campaign", "points.parquet", "--few-shot", "few.parquet", "--floor", "floor.parquet", "--coverage",
        "coverage.parquet", "--titles", *(f"{model}={title}" for model, title in TITLES.items()),
        "--intervals-of", "Spline model", "--out-dir", "out", "--svg-dir", "svg",
    ]  # fmt: skip
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.argv", arguments)
    with pytest.raises(SystemExit) as status:
        page.main()
    assert status.value.code == 0
    return tmp_path


@pytest.mark.long
def test_the_program_writes_page_tables_and_figures(written, few_shot, coverage):
    names = {f"{name}.{suffix}" for name in ("few_shot", "coverage") for suffix in ("csv", "png", "pdf")}
    names |= {"campaign.md", "campaign.html", "few_shot.csv-metadata.json", "coverage.csv-metadata.json"}
    assert {path.name for path in (written / "out").iterdir()} == names
    for name in ("few_shot", "coverage"):
        beside = json.loads((written / "out" / f"{name}.csv-metadata.json").read_text())
        heads = [column["titles"] for column in beside["tableSchema"]["columns"]]
        assert heads == list(pd.read_csv(written / "out" / f"{name}.csv").columns)
    html = (written / "out" / "campaign.html").read_text(encoding="utf-8")
    assert '<img src="few_shot.png"' in html and html.count("<table") == 8
    assert {path.name for path in (written / "svg").iterdir()} == {"few_shot.svg", "coverage.svg"}
    rows = pd.read_csv(written / "out" / "few_shot.csv")
    assert len(rows) == len(few_shot) + 4 and (rows["model"] == "floor").sum() == 4
    assert len(pd.read_csv(written / "out" / "coverage.csv")) == len(coverage)


def test_the_page_counts_strings_and_gives_every_cell(written):
    text = (written / "out" / "campaign.md").read_text(encoding="utf-8")
    assert "6 strings of 2 materials: 1 to learn on, 1 to learn on what a correction may be, 4 new." in text
    assert "| Spline model, alone |  | 1.04 (0.968–1.10) | 0.345 (0.323–0.367) | **0.0690** (0.0645–0.0735) |" in text
    assert (
        "4 of 8 shares" not in text and "2 of 4 shares (two maps, 2 levels) are within 2 points of their level" in text
    )
    assert "the farthest is inverse at" in text and "10.00 % forward, 0.00 % inverse" in text
    assert "| inverse | 90 | 80.0 ± 0.6 | 80.0 ± 0.6 | 80.0 ± 0.6 | 0.4 turns | 0.8 turns |" in text
    for link in re.findall(r"\]\(([^)]+)\)", text):
        assert (written / "out" / link).is_file(), link


def test_figures_have_a_line_for_every_way_to_learn_and_the_floor(few_shot, floor, coverage):
    figure = figures.few_shot(few_shot, floor, TITLES)
    for axes in figure.axes:
        named = [line for line in axes.get_lines() if not line.get_label().startswith("_")]
        assert len(named) == len(KNOWN) + 1
        assert {line.get_linestyle() for line in named} == {"-", "--", ":"} and axes.get_yscale() == "log"
    plt.close(figure)
    figure = figures.coverage(coverage)
    assert len(figure.axes) == 3 and "4 strings" in figure.get_suptitle()
    plt.close(figure)
