"""What strokes were recorded under: later ones of another load or twist are said, and a figure names a stroke by it."""

import numpy as np
import pandas as pd
import programs
import pytest
from stages.nine_strokes import NINE
from test_models_page import made_metrics

from pipeline.ground.stored import schemas
from pipeline.report.drawn.figure_4 import figure_4
from pipeline.report.drawn.figure_5 import figure_5
from pipeline.report.drawn.winding import with_nominal
from pipeline.report.model_to_take.to_take import Models, materials_table
from pipeline.report.shown.stroke_conditions import APART, OTHERWISE, labels, later_apart, otherwise
from pipeline.report.web.page import together

LAST = 9


def with_last(load_n=None, share_of_twist=1.0):
    """The nine strokes, the last under another load and to a share of its twist."""
    points, is_last = NINE.copy(), NINE["stroke"] == LAST
    points.loc[is_last, "load_n"] = load_n if load_n is not None else points.loc[is_last, "load_n"]
    points.loc[is_last, "motor_turns"] *= share_of_twist
    return points


def test_later_strokes_of_another_load_or_twist_are_said_with_both():
    usual_n, top_turns = NINE["load_n"].median(), NINE["motor_turns"].max()
    text = later_apart(with_last(1.5 * usual_n, 0.8))
    assert text.startswith(f"{APART}: n=9 was recorded at {1.5 * usual_n:.3g} N and to ")
    assert f"{0.8 * top_turns:.3g} turns, the others at {usual_n:.3g} N and to " in text
    assert "are errors at another load and another twist too, and do not decide which model to take." in text
    assert "are errors at another load too, and do not decide" in later_apart(with_last(1.5 * usual_n))
    assert "are errors at another twist too, and do not decide" in later_apart(with_last(None, 1.2))


@pytest.mark.parametrize("load_n", [None, 30.0])
def test_later_errors_under_another_load_are_marked_and_choose_no_model(tmp_path, load_n):
    metrics, dataset, table = (tmp_path / name for name in ("metrics.parquet", "dataset.parquet", "models.csv"))
    errors = made_metrics()
    is_later_mlp = (errors["split"] == "later") & (errors["model"] == "mlp")
    errors.loc[is_later_mlp, "value"] *= 100.0  # inside strokes it errs least
    schemas.write(errors, schemas.METRICS, metrics)
    schemas.write(with_last(load_n), schemas.DATASET, dataset)
    words = ("--titles", "mlp=MLP", "calibrated=Calibrated", "--out", tmp_path / "models.md", "--table", table)
    done = programs.run("pipeline.report.models", metrics, *words, "--dataset", dataset)
    assert done.returncode == 0, done.stderr
    rows = pd.read_csv(table)
    assert (rows["other_conditions"] == ((rows["split"] == "later") & (load_n is not None))).all()
    title = "Calibrated" if load_n is None else "MLP"
    assert f"Take the **{title}**." in (tmp_path / "models.md").read_text(encoding="utf-8")
    model = "calibrated" if load_n is None else "mlp"
    page = (tmp_path / "models.md").read_text(encoding="utf-8")
    assert f"processed/made/{model}/within-0.model --format c" in page, "the commands are of that model too"
    models = Models.read(table)
    assert models.titles[models.chosen()] == title and len(models.errors) == 8, "the index shows all of them"


def test_later_strokes_like_the_others_need_no_word():
    usual_n = NINE["load_n"].median()
    assert later_apart(NINE) == later_apart(with_last(1.01 * usual_n, 0.99)) == later_apart(None) == ""
    assert later_apart(with_last(1.5 * usual_n).assign(later="")) == ""
    table = with_last(1.5 * usual_n)
    table.loc[table["stroke"].isin([1, 3, 5]), "load_n"] = 1.5 * usual_n  # strokes that the models saw had it too
    assert later_apart(table) == ""
    table.loc[table["stroke"].isin([1, 3]), "load_n"] = usual_n  # of seven or eight one is few: it was told as none
    assert "most others at" in later_apart(table)


def test_a_later_stroke_is_measured_by_its_own_string():
    """Of a string that was under 30 N in all strokes it said that few learnt strokes had that load."""
    usual_n = NINE["load_n"].median()
    other = NINE.assign(string="B", load_n=1.5 * usual_n, motor_turns=0.8 * NINE["motor_turns"])
    other.loc[~other["stroke"].isin([4, 8, 9]), "later"] = ""
    other.loc[other["stroke"] == 8, "later"] = "test"
    assert later_apart(pd.concat([NINE, other], ignore_index=True)) == ""
    other.loc[other["stroke"] == 9, "load_n"] = 3.0 * usual_n
    assert later_apart(pd.concat([NINE, other], ignore_index=True)).startswith(f"{APART}: n=9 was recorded at ")


def test_strokes_that_were_recorded_otherwise_than_most_are_said_if_they_are_shown():
    usual_n, top_turns = NINE["load_n"].median(), NINE["motor_turns"].max()
    other, usual = f"{1.5 * usual_n:.3g} N", f"{usual_n:.3g} N"
    points = with_last(1.5 * usual_n, 0.8)
    text = otherwise(points)
    assert text.startswith(f"{OTHERWISE}: n=9 at {other} and to {0.8 * top_turns:.3g} turns; the others at {usual} and")
    assert otherwise(with_last(1.5 * usual_n)) == f"{OTHERWISE}: n=9 at {other}; the others at {usual}."
    assert otherwise(points, [1, 5]) == otherwise(NINE) == otherwise(None) == otherwise(with_last(1.01 * usual_n)) == ""
    points.loc[points["stroke"].isin([3, 4]), "load_n"] = 2.0 * usual_n
    several = f"n=3 to 4 at {2.0 * usual_n:.3g} N and to {top_turns:.3g} turns; n=9 at {other} and to "
    assert several in otherwise(points)
    points["load_n"] = usual_n * (1.0 + 0.1 * (points["stroke"] - 4.0).clip(lower=0.0))
    low, high = f"{1.1 * usual_n:.3g}", f"{1.5 * usual_n:.3g}"
    assert otherwise(points).startswith(f"{OTHERWISE}: n=5 to 9 at {low} to {high} N and to ")
    two = with_last().assign(string="b")
    two.loc[two["stroke"] < 5, "load_n"] = 1.5 * usual_n
    first_four = f"of string b n=1 to 4 at {other}; all others at {usual}."
    assert otherwise(pd.concat([with_last().assign(string="a"), two])) == f"{OTHERWISE}: {first_four}"
    two["load_n"] = 1.5 * usual_n
    points = pd.concat([with_last().assign(string="a"), two.query("stroke < 7")])
    all_of_b = f"{OTHERWISE}: all strokes of string b at {other}; all others at {usual}."
    assert otherwise(points) == all_of_b
    assert otherwise(points, [1, 5]) == all_of_b.replace("others at", "others of those shown at")


def test_a_figure_names_a_stroke_by_its_load_where_loads_differ_and_by_a_smaller_twist():
    usual_n, top_turns = NINE["load_n"].median(), NINE["motor_turns"].max()
    strokes = {1: ["a-01"], 9: ["a-01"]}
    assert labels(NINE, strokes) == {1: "n=1", 9: "n=9"}
    points = with_last(1.5 * usual_n, 0.8)
    words = f"n=9 ({1.5 * usual_n:.3g} N, to {0.8 * top_turns:.3g} turns)"
    assert labels(points, strokes) == {1: f"n=1 ({usual_n:.3g} N)", 9: words}
    recorded = with_nominal(points)
    assert words in figure_5(recorded, {}, "m").axes[2].get_title(loc="left")
    few = recorded[recorded["stroke"].isin([1, 2, 9])]
    assert words in [text.get_text() for text in figure_4(few, "m").legends[0].get_texts()]


def with_changing(stroke, low_n, high_n):
    """The nine strokes, one of them under a load that rises within it."""
    points = NINE.copy()
    of_it = points["stroke"] == stroke
    points.loc[of_it, "load_n"] = np.linspace(low_n, high_n, of_it.sum())
    return points


def test_a_load_that_changes_within_a_stroke_is_named_by_its_range():
    """`n=9 at 29.9 N` was told of a load that went from 10 to 50 N."""
    points = with_changing(LAST, 10.0, 50.0)
    named = labels(points, {number: [points["string"].iloc[0]] for number in (1, LAST)})
    assert named[LAST] == "n=9 (12 to 48 N)" and " to " not in named[1]
    assert "n=9 was recorded at 12 to 48 N (changing within a stroke), the others at 20 N" in later_apart(points)


def test_strokes_under_about_the_same_changing_load_are_alike():
    every = NINE.assign(load_n=20.0 + 10.0 * np.sin(np.arange(len(NINE))))
    every.loc[every["stroke"] == LAST, "load_n"] *= 1.08
    assert later_apart(every) == "" and otherwise(every) == ""
    assert labels(every, {1: [every["string"].iloc[0]], LAST: [every["string"].iloc[0]]}) == {1: "n=1", LAST: "n=9"}


@pytest.mark.parametrize("program", ["models", "comparison"])
def test_pages_with_later_strokes_say_what_differs(tmp_path, program):
    folder = tmp_path / "made"
    schemas.write(with_last(1.5 * NINE["load_n"].median()), schemas.DATASET, folder / "dataset.parquet")
    schemas.write(made_metrics(), schemas.METRICS, folder / "metrics.parquet")
    words = [folder / "metrics.parquet", "--titles", "inn=INN", "--out", folder / f"{program}.md"]
    words += ["--table", folder / "models.csv"] if program == "models" else []
    for more, times in ([], 0), (["--dataset", folder / "dataset.parquet"], 2):
        done = programs.run(f"pipeline.report.{program}", *words, *more)
        assert done.returncode == 0, done.stderr
        text = (folder / f"{program}.md").read_text()
        assert text.count(OTHERWISE) == times // 2
        assert text.count(APART) == (folder / f"{program}.html").read_text().count(APART) == times
    assert APART not in text.split("later strokes")[0]
    if program == "models":
        assert f"<b>made</b>: {APART}: n=9 was recorded at" in together(materials_table(tmp_path, ["made"], str))
