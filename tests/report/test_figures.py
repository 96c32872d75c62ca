import re
import sys
from itertools import pairwise

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import programs
import pytest
from matplotlib.lines import Line2D
from stages.nine_strokes import NINE

from pipeline.ground.stored import schemas
from pipeline.report import figures
from pipeline.report.drawn.averaged import PARTS, averaged, parts_of
from pipeline.report.drawn.drawing import STYLE, save
from pipeline.report.drawn.error_row import as_bars, by_range, foot_of
from pipeline.report.drawn.figure_4 import MEANS, SAMPLES, figure_4
from pipeline.report.drawn.figure_5 import figure_5
from pipeline.report.drawn.winding import with_median, with_nominal
from pipeline.report.drawn.zero_of_x import zero_of_x
from pipeline.report.figures import best_other
from pipeline.report.layout.made_by import MadeBy

TITLES = {"inn": "INN model", "spline": "Spline model", "mlp": "MLP model", "traditional": "Traditional model"}
AWAY = {"inn": 0.1, "spline": 0.02, "mlp": 0.3, "traditional": 0.01}  # of the measurement, in mm and turns
SMALL = MadeBy("ci.yaml", "abc1234", "small", "", ())


def made_metrics():
    """Forward RMSE of every model on all held-out points, and on one stroke, where another is best."""
    rows = [
        ("m", model, "within", "forward", stroke, "all", "all", 0, "rmse", "mm", away if stroke == "all" else 1 - away)
        for model, away in AWAY.items()
        for stroke in ("all", "1")
    ]
    return pd.DataFrame(rows, columns=schemas.METRICS.names)


@pytest.fixture(scope="module")
def material(tmp_path_factory):
    """A dataset, metrics and the models' predictions of two seeds, as the DAG leaves them."""
    folder = tmp_path_factory.mktemp("processed") / "UHMWPE"
    schemas.write(NINE, schemas.DATASET, folder / "dataset.parquet")
    schemas.write(made_metrics(), schemas.METRICS, folder / "metrics.parquet")
    test_points = np.flatnonzero(NINE["within"] == "test")
    for model, away in AWAY.items():
        for seed in (0, 1):
            table = pd.DataFrame({"point": test_points})
            for column in ("displacement_mm", "motor_turns"):
                table[column] = NINE[column].to_numpy()[test_points] + away * seed
            schemas.write(table, schemas.PREDICTIONS, folder / model / f"within-{seed}.predictions.parquet")
    return folder


@pytest.fixture(scope="module")
def dataset(material):
    return schemas.read(material / "dataset.parquet", schemas.DATASET)


@pytest.fixture(scope="module")
def learned(material, dataset):
    """Medians of the INN's and the spline's predictions, by title."""
    return {
        TITLES[model]: with_median(dataset, sorted((material / model).glob("within-*.parquet")))
        for model in ("inn", "spline")
    }


@pytest.fixture(autouse=True)
def closed():
    yield
    plt.close("all")


def draw(material, out, *more):
    predictions = [str(path) for path in sorted(material.glob("*/within-*.parquet"))]
    words = [material / "dataset.parquet", material / "metrics.parquet", "--predictions", *predictions]
    words += ["--titles", *(f"{model}={title}" for model, title in TITLES.items()), "--out-dir", out, *more]
    done = programs.run("pipeline.report.figures", *words)
    assert done.returncode == 0, done.stderr
    return {path.name: path.read_bytes() for path in out.iterdir()}


@pytest.mark.long
def test_figures_are_drawn_and_the_same_every_time(material, tmp_path):
    first, second = draw(material, tmp_path / "a"), draw(material, tmp_path / "b")
    assert sorted(first) == ["figure_4.pdf", "figure_4.png", "figure_5.pdf", "figure_5.png"]
    assert first == second
    assert first["figure_4.png"].startswith(b"\x89PNG") and first["figure_5.pdf"].startswith(b"%PDF")
    small = draw(material, tmp_path / "c", "--made-by", SMALL.packed())
    assert all(small[name] != first[name] for name in first)


def beneath(figure) -> str:
    """The words beneath the panels: above the entries of a legend, if the figure has one."""
    return figure.legends[0].get_title().get_text() if figure.legends else figure.get_supxlabel()


def test_no_legend_of_figure_4_lies_within_a_panel(dataset):
    """Where curves fan out no corner of panel (c) is free, and its legend lay over them."""
    with plt.rc_context(STYLE):
        four = figure_4(with_nominal(dataset), "m")
        four.canvas.draw()
    assert all(axes.get_legend() is None for axes in four.axes) and len(four.legends) == 1
    legend = four.legends[0].get_window_extent()
    assert legend.y1 < min(axes.get_tightbbox().y0 for axes in four.axes)


def test_the_legend_of_figure_4_has_room_where_strings_differ_in_load_and_twist(dataset):
    """Its first entries were cut off at the left edge, and its last at the right one."""
    points = with_nominal(dataset).assign(load_n=20.0)
    other = points.assign(string="B", run="B", load_n=30.0, motor_turns=0.8 * points["motor_turns"])
    with plt.rc_context(STYLE):
        four = figure_4(pd.concat([points, other], ignore_index=True), "m")
        four.canvas.draw()
        shown = four.legends[0].get_window_extent()
    assert any("20 and 30 N" in text.get_text() for text in four.legends[0].get_texts())
    assert len(four.legends) == 1 and shown.x0 >= 0 and shown.x1 <= four.bbox.x1


def test_figure_4_shows_strokes_against_the_traditional_model(dataset):
    four = figure_4(with_nominal(dataset), "synthetic")
    labels = [text.get_text() for text in four.legends[0].get_texts()]
    assert labels == ["n=1", "n=3", "n=5", "n=7", "traditional model"]
    forward_error = four.axes[1].get_lines()[0].get_ydata()
    winding = with_nominal(dataset).query("stroke == 1 and phase == 'winding'")
    assert forward_error == pytest.approx((winding["forward_mm"] - winding["displacement_mm"]).to_numpy())


def test_figure_5_has_a_row_of_errors_of_three_models_beneath_each_row_of_curves(dataset, learned):
    five = figure_5(with_nominal(dataset), learned, "UHMWPE")
    titles = [axes.get_title(loc="left") for axes in five.axes]
    assert [title[:3] for title in titles[:3] + titles[6:9]] == ["(a)", "(b)", "(c)", "(d)", "(e)", "(f)"]
    assert [title[:12] for title in titles[3:6]] == ["error of (a)", "error of (b)", "error of (c)"]
    assert [title.split()[-1] for title in titles[:3]] == ["n=1", "n=5", "n=9"]
    labels = [line.get_label() for line in five.axes[0].get_lines()]
    assert labels == ["measured", "traditional model", "INN model, held-out points", "Spline model, held-out points"]
    for below in (five.axes[3], five.axes[9]):
        by_label = {line.get_label(): np.asarray(line.get_ydata(), float) for line in below.get_lines()}
        for title, error in (("INN model", 0.05), ("Spline model", 0.01)):
            shown = by_label[f"{title}, held-out points"]
            assert np.isfinite(shown).any() and shown[np.isfinite(shown)] == pytest.approx(error)
        assert "traditional model" in by_label and below.get_yscale() == "log"
        assert all(line.get_linestyle() != "None" for line in below.get_lines())


def test_figure_5_says_in_its_legend_what_is_drawn_and_why_it_shows_its_last_model(dataset, learned):
    five = figure_5(with_nominal(dataset), learned, "UHMWPE", "Spline model")
    (legend,) = five.legends
    words = [text.get_text() for text in legend.get_texts()]
    assert words[1::2] == ["traditional model, and its error", "Spline model: held-out points, and their error"]
    bars = [line for line in five.axes[3].get_lines() if "held-out" in line.get_label()]
    points = [line for line in five.axes[0].get_lines() if "held-out" in line.get_label()]
    keys = [(line.get_color(), line.get_marker(), line.get_linewidth()) for line in legend.findobj(Line2D)]
    assert len(bars) == len(points) == 2
    assert all((line.get_color(), line.get_marker(), line.get_linewidth()) in keys for line in (*bars, *points))
    title = " ".join(legend.get_title().get_text().split())
    assert "A bar: the rms error over one of 24 equal parts of the stroke" in title
    assert (
        "Spline model: beside INN and traditional, the least forward error over all held-out strokes together" in title
    )
    other = figure_5(with_nominal(dataset), learned, "UHMWPE").legends[0].get_title().get_text()
    assert "the least forward error" not in other


@pytest.mark.parametrize("last", [1, 2, 9])
def test_the_words_beneath_a_figure_lie_on_it_and_touch_nothing(dataset, learned, last):
    few = with_nominal(dataset[dataset["stroke"] <= last])
    few_learned = {title: points[points["stroke"] <= last] for title, points in learned.items()}
    few.loc[few["motor_turns"] < 2.0, "displacement_mm"] = -0.5
    with plt.rc_context(STYLE):
        four, five = figure_4(few, "UHMWPE"), figure_5(few, few_learned, "UHMWPE", "Spline model")
        for figure in (four, five):
            figure.canvas.draw()
        shown = {figure: figure.legends[0].get_window_extent() for figure in (four, five)}
    for figure, words in shown.items():
        assert words.x0 >= 0 and words.x1 <= figure.bbox.x1 and words.y0 >= 0
        assert words.y1 < min(axes.get_tightbbox().y0 for axes in figure.axes)


def test_the_spike_of_the_inverse_error_is_explained_where_it_is(dataset):
    recorded = with_nominal(dataset)
    above = recorded.assign(displacement_mm=recorded["displacement_mm"].abs())
    below = recorded.copy()
    below.loc[below["stroke"] == 5, "displacement_mm"] -= 2.0
    below = with_nominal(below)
    floor_turns = -below["separator_mm"].iloc[0] / below["radius_mm"].iloc[0] / (2.0 * np.pi)
    words = f"so the model answers {floor_turns:.2g} turns at every x < 0".replace("-", "−")
    for figure, text in ((figure_4(below, "m"), "(c), (d): below"), (figure_5(below, {}, "m"), "Inverse: below")):
        caption = " ".join(beneath(figure).split())
        assert (
            words in caption
            and text in caption
            and re.search(r"at every x < 0, and errs there by up to [\d.]+ turns\.$", caption)
        )
    for caption in (beneath(figure_4(above, "m")), beneath(figure_5(above, {}, "m"))):
        assert "x < 0" not in caption and caption.startswith("n is the number of the stroke. Shown: ")


def test_a_figure_says_which_strokes_it_shows_and_which_the_tables_do(dataset):
    """Figures 4, 5 and the tables show different strokes, and none said so."""
    nine, few = with_nominal(dataset), with_nominal(dataset[dataset["stroke"] <= 4])
    captions = [
        (beneath(figure_4(nine, "synthetic")), "n=1, 3, 5, 7 of 1 to 9; the tables show n=1, 5, 9."),
        (beneath(figure_4(nine, "m")), "n=1, 5, 9 of 1 to 9; as in the tables."),
        (figure_5(nine, {}, "m").legends[0].get_title().get_text(), "n=1, 5, 9 of 1 to 9; as in the tables."),
        (beneath(figure_4(few, "m")), "n=1, 2, 3, 4, all that there are; the tables show n=1."),
        (figure_5(few, {}, "m").legends[0].get_title().get_text(), "n=1, 3, 4 of 1 to 4; the tables show n=1."),
    ]
    for words, strokes in captions:
        assert f"n is the number of the stroke. Shown: {strokes}" in " ".join(words.split()), words


def test_the_model_to_take_is_drawn_beside_another_that_errs_less(material, tmp_path, monkeypatch):
    """Of a quick run the diagnosed simulator was drawn, and the spline, which is advised, was in no figure."""
    metrics = made_metrics()
    later = metrics.assign(split="later")  # where the spline errs least
    metrics.loc[metrics["model"] == "mlp", "value"] /= 100.0
    metrics = pd.concat([metrics, later[later["model"] != "traditional"]], ignore_index=True)
    schemas.write(metrics, schemas.METRICS, tmp_path / "metrics.parquet")
    drawn = []
    monkeypatch.setattr(figures, "figure_5", lambda *words: drawn.append(words) or figure_5(*words))
    predictions = [str(path) for path in sorted(material.glob("*/within-*.predictions.parquet"))]
    words = ["figures", str(material / "dataset.parquet"), str(tmp_path / "metrics.parquet"), "--predictions"]
    words += [*predictions, "--titles", *(f"{model}={title}" for model, title in TITLES.items())]
    monkeypatch.setattr(sys, "argv", [*words, "--out-dir", str(tmp_path)])
    monkeypatch.setattr(figures, "save", lambda *_: None)
    with pytest.raises(SystemExit) as end:
        figures.main()
    assert end.value.code == 0 and list(drawn[0][1]) == ["INN model", "MLP model", "Spline model"]
    monkeypatch.setattr(figures, "later_apart", lambda _: "later strokes of another load, which do not decide")
    with pytest.raises(SystemExit):
        figures.main()
    assert list(drawn[1][1]) == ["INN model", "MLP model"], "the page takes that one, and no other is named"
    monkeypatch.undo()
    five = figure_5(*drawn[0])
    words = " ".join(five.legends[0].get_title().get_text().split())
    assert "MLP model: beside INN and traditional, the least forward error" in words
    assert "Spline model: the model to take" in words
    assert "Spline model, held-out points" in [line.get_label() for line in five.axes[0].get_lines()]
    with plt.rc_context(STYLE):
        five = figure_5(*drawn[0])
        five.canvas.draw()
        shown = five.legends[0].get_window_extent()
    assert shown.x0 >= 0 and shown.y1 < min(axes.get_tightbbox().y0 for axes in five.axes)


def test_an_error_is_a_root_mean_square_along_the_stroke_and_breaks_where_nothing_was_held_out():
    positions = np.array([0.0, 0.1, 0.2, 9.8, 9.9, 10.0, 5.0, np.nan])
    middle, size = by_range(positions, np.array([3.0, -3.0, 3.0, 1.0, -1.0, np.sqrt(7.0), 8.0, 1.0]), 0.0, 10.0)
    assert len(middle) == len(size) == 24 and middle[0] == pytest.approx(10.0 / 48.0)
    assert size[[0, -1]] == pytest.approx([3.0, np.sqrt(3.0)])
    assert np.isnan(size[1:-1]).all()  # one point makes no root mean square


def test_a_lucky_range_stands_on_the_axis_which_says_so_and_stretches_nothing(dataset, learned):
    lucky = {title: points.copy() for title, points in learned.items()}
    points = lucky["Spline model"]
    chosen = points[(points["stroke"] == 1) & (points["phase"] == "winding")].index[:12]
    points.loc[chosen, "forward_mm"] = points.loc[chosen, "displacement_mm"] + 1e-7
    usual, stretched = (figure_5(with_nominal(dataset), of_models, "m") for of_models in (learned, lucky))
    assert usual.axes[3].get_ylim()[0] == pytest.approx(0.008) and stretched.axes[3].get_ylim()[0] == 0.002
    assert usual.axes[3].get_ylabel() == "rms error (mm)"
    assert stretched.axes[3].get_ylabel() == "rms error (mm)", "the foot ran into it as one phrase"
    beneath = [" ".join(each.legends[0].get_title().get_text().split()) for each in (usual, stretched)]
    words = "An error that stands on the lower axis is 0.002 mm or less."
    assert words in beneath[1] and "stands on the lower axis" not in beneath[0]
    drawn = {line.get_label(): np.asarray(line.get_ydata(), float) for line in stretched.axes[3].get_lines()}
    assert np.nanmin(drawn["Spline model, held-out points"]) == 0.002


def test_a_bar_is_as_wide_as_its_range_and_is_joined_to_no_other():
    x, y = as_bars(np.array([1.0, 3.0]), np.array([0.2, np.nan]), 2.0)
    assert x[[0, 1, 3, 4]].tolist() == [0.0, 2.0, 2.0, 4.0] and np.isnan(x[[2, 5]]).all()
    assert y[[0, 1]].tolist() == [0.2, 0.2] and np.isnan(y[2:]).all()


@pytest.mark.parametrize(
    ("sizes", "foot"), [([0.02, 0.02, 1e-6], 0.005), ([0.08, 9.0, 0.08], 0.02), ([np.nan, np.nan, np.nan], 0.2)]
)
def test_an_axis_begins_at_a_quarter_of_the_best_models_usual_error(sizes, foot):
    assert foot_of([np.array([5.0, 6.0]), np.array(sizes)]) == pytest.approx(1.0 if np.isnan(sizes[0]) else foot)


def test_the_third_model_is_the_best_of_the_others():
    assert best_other(made_metrics(), TITLES) == "spline"
    assert best_other(made_metrics(), {"inn": "INN", "mlp": "MLP", "traditional": "T"}) == "mlp"
    assert best_other(made_metrics(), {"inn": "INN", "traditional": "T"}) is None


@pytest.mark.parametrize(("last", "shown"), [(8, [1, 5, 8]), (2, [1, 2]), (1, [1])])
def test_figures_have_no_panel_for_a_stroke_that_is_not_there(dataset, learned, last, shown):
    few = with_nominal(dataset[dataset["stroke"] <= last])
    few_learned = {title: points[points["stroke"] <= last] for title, points in learned.items()}
    four, five = figure_4(few, "UHMWPE"), figure_5(few, few_learned, "UHMWPE")
    assert len(five.axes) == 4 * len(shown)
    letters = [axes.get_title(loc="left")[1] for axes in five.axes if axes.get_title(loc="left").startswith("(")]
    assert "".join(letters) == "abcdef"[: 2 * len(shown)]
    assert [axes.get_title(loc="left").split("n=")[1] for axes in five.axes[: len(shown)]] == [str(n) for n in shown]
    assert all(len(axes.get_lines()) >= 2 for axes in [*five.axes, *four.axes])


def test_a_figure_of_no_winding_says_so(dataset):
    none = with_nominal(dataset[dataset["phase"] != "winding"])
    assert "no winding was recorded" in figure_4(none, "UHMWPE").get_suptitle()
    assert "no winding was recorded" in figure_5(none, {}, "UHMWPE").get_suptitle()


def test_a_figure_of_a_small_fit_says_that_it_is_no_result(tmp_path):
    figure = plt.figure()
    figure.suptitle("nylon")
    save(figure, tmp_path / "small", SMALL)
    assert figure.get_suptitle() == "nylon\nsmall fit: not a result, made by ci.yaml"
    assert b"Small fit, not a result: made by ci.yaml" in (tmp_path / "small.png").read_bytes()
    figure = plt.figure()
    figure.suptitle("nylon")
    save(figure, tmp_path / "usual", MadeBy("default.yaml", "abc1234", "default", "", ()))
    assert figure.get_suptitle() == "nylon"
    assert b"Made by the default configuration" in (tmp_path / "usual.png").read_bytes()


def test_errors_of_many_samples_are_averaged_along_a_stroke_but_on_the_papers_figure(dataset):
    """At 100 Hz the error was noise, and the last stroke lay over the others: no drift could be seen."""
    winding = with_nominal(dataset[(dataset["stroke"] == 1) & (dataset["phase"] == "winding")])
    many = pd.concat([winding] * (1 + 500 // len(winding)), ignore_index=True).sort_values(
        "motor_turns", ignore_index=True
    )
    noise = np.tile([0.5, -0.5], len(many))[: len(many)]
    many = many.assign(time_s=np.arange(len(many)) / 100.0, forward_mm=many["displacement_mm"] + 0.2 + noise)
    own, papers = figure_4(many, "nylon"), figure_4(many, "synthetic")
    every, means = own.axes[1].get_lines()[:2]
    assert len(every.get_ydata()) == len(many) and len(means.get_ydata()) == PARTS and every.get_alpha() < 0.5
    middle = means.get_ydata()[np.isfinite(means.get_ydata())]
    assert np.abs(middle - 0.2).max() < 0.2 and middle.mean() == pytest.approx(0.2, abs=0.05)
    means_words = MEANS.format(PARTS)
    assert means_words in " ".join(beneath(own).split()) and means_words not in beneath(papers)
    assert len(papers.axes[1].get_lines()) == 2 and papers.axes[1].get_lines()[0].get_alpha() is None


def recorded_from(winding, counts):
    """Strokes like one winding, with as many samples of it each as `counts` says, and errors that are even."""
    rows = [
        winding.iloc[np.linspace(0, len(winding) - 1, count).astype(int)].assign(
            stroke=stroke, time_s=np.arange(count) / 50.0, motor_turns=np.linspace(1.0, 20.0, count)
        )
        for stroke, count in counts.items()
    ]
    points = with_nominal(pd.concat(rows, ignore_index=True))
    away = 0.01 * points["stroke"]
    return points.assign(displacement_mm=points["forward_mm"] - away, inverse_turns=points["motor_turns"] - away - 0.1)


@pytest.mark.parametrize(
    ("counts", "parts"),
    [
        ({1: 900, 5: 390, 9: 612}, 78),
        ({1: 900, 5: 700, 9: 612}, PARTS),
        ({1: 900, 5: 30, 9: 612}, 20),
        ({1: 99, 5: 60}, 0),
        ({}, 0),
    ],
)
def test_all_strokes_of_figure_4_are_drawn_in_one_way_whatever_their_samples(dataset, counts, parts):
    """Strokes of fewer samples were thin raw lines over the faint ones, and the words were of the others."""
    assert parts_of(counts.values()) == parts
    if not counts:
        return
    winding = dataset[(dataset["stroke"] == 1) & (dataset["phase"] == "winding")]
    points = recorded_from(winding, counts)
    four = figure_4(points, "nylon")
    words = " ".join(beneath(four).split())
    assert (MEANS.format(parts) in words) is (parts > 0) and (SAMPLES in words) is (parts == 0)
    for axes in (four.axes[1], four.axes[3]):
        lines = [line for line in axes.get_lines() if len(line.get_xdata()) > 2]
        every = [line for line in lines if line.get_marker() != "."]
        means = [line for line in lines if line.get_marker() == "."]
        assert [len(line.get_xdata()) for line in every] == list(counts.values())
        assert len({(line.get_alpha(), line.get_linewidth()) for line in every}) == 1
        assert [len(line.get_xdata()) for line in means] == [parts] * (len(counts) if parts else 0)


def test_the_axis_of_the_inverse_error_is_that_of_the_means_and_says_what_lies_beyond(dataset):
    """A few samples at the clipped root took half of it."""
    winding = dataset[(dataset["stroke"] == 1) & (dataset["phase"] == "winding")]
    points = recorded_from(winding, {1: 800, 5: 800})
    usual = figure_4(points, "nylon")
    assert "lie beyond it" not in beneath(usual)
    middle = points.index[(points["stroke"] == 5)][400]
    points.loc[middle, "inverse_turns"] = points.loc[middle, "motor_turns"] - 9.0
    four = figure_4(points, "nylon")
    low, high = four.axes[3].get_ylim()
    means = np.concatenate([line.get_ydata() for line in four.axes[3].get_lines() if line.get_marker() == "."])
    assert low < np.nanmin(means) and high >= max(0.0, np.nanmax(means)) and low > -4.0
    words = "(d): the axis shows the means. Single samples lie beyond it, the farthest at −9 turns."
    assert words in " ".join(beneath(four).split())


def test_a_mean_is_of_a_hundredth_of_the_range_and_missing_where_no_point_lies():
    x, y = averaged(pd.Series([0.0, 0.5, 100.0, np.nan]), pd.Series([1.0, 3.0, 7.0, 1.0]))
    assert len(x) == PARTS and x[[0, -1]].tolist() == [0.25, 100.0] and y[[0, -1]].tolist() == [2.0, 7.0]
    assert np.isnan(y[1:-1]).all() and np.isnan(averaged(pd.Series([np.nan]), pd.Series([1.0]))[1]).all()


def test_figure_4_says_where_an_untwisted_string_stands(dataset):
    """The string stood at 0.2 mm, and the words spoke of its zero as if it were there."""
    caption = " ".join(beneath(figure_4(with_nominal(dataset), "m")).split())
    untwisted_mm = np.hypot(150.0, 8.0) - 150.0
    assert f"Without twist that is {untwisted_mm:.2f} mm, not 0, since the separator spreads the string." in caption
    pair = dataset.assign(actuator="twisted_pair", separator_mm=np.nan, torsion_zone_mm=np.nan)
    assert zero_of_x(pair).endswith("to the traditional model's value at that twist.") and zero_of_x(pair[:0]) == ""
    again = pd.concat([pair, pair.assign(run="second")])
    last = (
        " A further run with `tare: run` in its run.yaml goes on where the run before ended, with what the string took "
        "back since. Where the two rest under other loads or at other twists it goes on from an earlier rest like its "
        "own, or from a straight line in load through earlier rests, or is set to the model's value."
    )
    assert zero_of_x(again).endswith(f"at that twist.{last}")
    apart = pd.concat([dataset, dataset.assign(run="second")])
    assert zero_of_x(apart).endswith(f"since the separator spreads the string.{last}")


def with_errors(size_mm):
    """Held-out points of a model that errs by about such a size, forward and inverse."""
    size = size_mm * np.random.default_rng(1).standard_normal(len(NINE))
    return NINE.assign(forward_mm=NINE["displacement_mm"] + size, inverse_turns=NINE["motor_turns"] + size)


def test_no_bar_of_figure_5_hides_another_or_lies_under_the_axis():
    """Of two models that erred alike the second one was not to be seen, nor a bar on the lower axis."""
    learned = {"INN": with_errors(0.05), "Spline": with_errors(0.05), "MLP": with_errors(0.0004)}
    with plt.rc_context(STYLE):
        five = figure_5(with_nominal(NINE), learned, "m")
        five.canvas.draw()
    below = five.axes[3]
    bars = [next(line for line in below.get_lines() if line.get_label().startswith(title)) for title in learned]
    wide, order = ([each(line) for line in bars] for each in (lambda line: line.get_lw(), lambda line: line.zorder))
    assert wide == sorted(wide) and np.diff(wide).min() >= 1.5 and order == sorted(order, reverse=True)
    assert min(order) > max(spine.zorder for spine in below.spines.values())
    assert "the wider bar lies beneath the narrower one" in " ".join(five.legends[0].get_title().get_text().split())


def test_the_numbers_of_an_axis_over_many_decades_do_not_overlap():
    with plt.rc_context(STYLE):
        five = figure_5(with_nominal(NINE), {"INN": with_errors(0.05), "MLP": with_errors(0.0004)}, "m")
        five.canvas.draw()
    for below in (five.axes[3], five.axes[9]):
        low, high = below.get_ylim()
        numbers = [
            label.get_window_extent()
            for at, label in zip(below.get_yticks(), below.get_yticklabels(), strict=True)
            if low <= at <= high
        ]
        assert len(numbers) >= 3 and all(lower.y1 < upper.y0 for lower, upper in pairwise(numbers))
