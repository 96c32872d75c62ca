"""The page of every model, from made metrics whose numbers are known."""

import csv
import io
import re
import sys
from itertools import pairwise
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
from in_a_browser import clicked, needs_browser

from pipeline.ground.model_errors import chosen_of, errors_in
from pipeline.ground.stored import schemas
from pipeline.ground.words.glossary import MEANING
from pipeline.report.drawn.drawing import STYLE
from pipeline.report.leak import GROUPS, figure_leak, floor
from pipeline.report.leak import main as draw
from pipeline.report.model_to_take.fitted import lines_at_end, lines_on_files, times_floor
from pipeline.report.model_to_take.inverse_beside import better as better_at_the_inverse
from pipeline.report.model_to_take.least_errors import sentences
from pipeline.report.model_to_take.model_advice import NOT_DECIDED, advice_on
from pipeline.report.model_to_take.to_take import Models, materials_table
from pipeline.report.model_to_take.usual_model import RULE, RULES, weighed
from pipeline.report.models import columns, main, numbers, on_simulator, page
from pipeline.report.web.markdown import web_page
from pipeline.report.web.page import together

TITLES = {"inn": "INN model", "mlp": "MLP model", "calibrated": "Calibrated model"}
# model → RMSE forward in mm by seed; inverse is five times as much, later 0.01 more
FORWARD = {
    "inn": [0.120, 0.118, 0.125], "mlp": [0.052, 0.050, 0.051], "calibrated": [0.093],
    "floor": [0.049], "floor_blind": [0.090],
}  # fmt: skip
GROUPED = [("all", "all", "all"), ("1", "all", "all"), ("9", "all", "all"), ("all", "winding", "all")]
GROUPED += [("all", "unwinding", "all"), *(("all", "all", f"{low}-{low + 25}%") for low in (0, 25, 50, 75))]


def made_metrics(forward=FORWARD, splits=("within", "later")):
    """RMSE and, to be left out, a maximum of every model, split, map, group and seed."""
    rows = []
    for model, values in forward.items():
        for split in splits:
            for way, unit, times in (("forward", "mm", 1.0), ("inverse", "turns", 5.0)):
                for stroke, phase, band in GROUPED:
                    for seed, value in enumerate(values):
                        where = ("made", model, split, way, stroke, phase, band, seed)
                        rows.append((*where, "rmse", unit, times * (value + 0.01 * (split == "later"))))
                        rows.append((*where, "maximum", unit, 99.0))
    return pd.DataFrame(rows, columns=schemas.METRICS.names)


def with_motion_marked(rows):
    """Lines of a models.csv with one column more, by which `diagnosed` answers along a whole motion alone."""
    head, *others = rows
    return [f"{head},needs_motion", *(f"{row},{row.startswith('diagnosed,')}" for row in others)]


def table_after(text, heading):
    lines = text.split(heading)[1].split("\n\n")[1].splitlines()
    return {row[0]: row[1:] for row in ([cell.strip() for cell in line.strip("|").split("|")] for line in lines)}


def test_columns_are_all_strokes_phases_and_bands_in_order():
    heads = ["all", "n=1", "n=9", "winding", "unwinding", "0-25%", "25-50%", "50-75%", "75-100%"]
    assert list(columns(made_metrics())) == heads
    later = made_metrics().replace({"stroke": {"1": "8"}})
    assert list(columns(later))[1:3] == ["n=8", "n=9"]


def test_the_page_says_what_times_a_floor_is_and_where_strings_are_together():
    points = pd.DataFrame({"string": ["a", "b", "a"], "stroke": [1, 1, 9], "load_n": 20.0, "motor_turns": 9.0})
    text = page(numbers(made_metrics(), TITLES, ["mlp"]), "made", points.assign(later=""))
    assert "`× floor` is a model's error divided by the floor" in " ".join(text.split())
    assert "Strings together: n=1 holds that stroke of 2 strings, n=9 of 1 (a, b), as every string" in text
    assert MEANING["× floor"].startswith("a model's error divided by the floor")


def test_the_page_begins_with_the_model_to_take_and_who_errs_less():
    titles = {"mlp": "MLP model", "spline": "Spline model"}
    metrics = made_metrics(FORWARD | {"spline": [0.058]})
    metrics.loc[(metrics["model"] == "mlp") & (metrics["split"] == "later"), "value"] *= 1.2
    begins = page(numbers(metrics, titles, ["mlp"]), "made").split("RMSE on held-out")[0]
    assert begins.startswith("# made: every model")
    least = "Its forward error on later strokes is the least of those that can be exported: 0.068 mm."
    assert f"Take the **Spline model**. {least} On strokes" in begins
    assert f"{RULE}\n\n1. {RULES[0]}\n2. {RULES[1]}\n3. {RULES[2]}\n" in begins
    less = "the MLP model errs less forward: 0.051 mm against 0.058 mm. On later strokes it errs by 0.073 mm"
    assert f"On strokes like the recorded ones {less} against 0.068 mm." in begins
    begins = page(numbers(made_metrics(FORWARD | {"spline": [0.093]}), titles, ["mlp"]), "made")
    assert "Take the **MLP model**." in begins and "On strokes like the recorded ones" not in begins


def test_a_simulator_that_errs_far_above_the_floor_on_later_strokes_has_its_reason_beside_it():
    """It stood at 233 times its floor below a table in which it was the best, without a word."""
    metrics = made_metrics(FORWARD | {"diagnosed": [0.05]})
    metrics.loc[(metrics["model"] == "diagnosed") & (metrics["split"] == "later"), "value"] *= 100.0
    table_of = numbers(metrics, {"mlp": "MLP model", "diagnosed": "Diagnosed simulator"}, ["mlp", "diagnosed"])
    (line,) = on_simulator(table_of, "later", "forward")
    assert re.match(r"- Diagnosed simulator \(6.000 mm, [0-9]+ × its floor\): for this table the effects were", line)
    assert "It errs by 0.050 mm within strokes." in line and line in page(table_of, "made")
    assert on_simulator(table_of, "within", "forward") == []


def test_cells_are_medians_with_their_spread_and_the_least_is_bold():
    text = page(numbers(made_metrics(), TITLES, ["mlp"]), "made")
    table = table_after(text, "## Forward, within strokes: RMSE in mm")
    assert table["INN model"][2] == "0.120 (0.118–0.125)"
    assert table["MLP model"][2] == "**0.051** (0.050–0.052)"
    assert table["*floor without direction*"][2] == "0.090" and "99.0" not in text
    assert all(cell.startswith("**") for cell in table["MLP model"][2:])
    assert not any("**" in cell for name in table if name != "MLP model" for cell in table[name])


def test_what_shows_the_same_number_shares_the_bold():
    tied = numbers(made_metrics({**FORWARD, "calibrated": [0.0512]}), TITLES, ["mlp"])
    table = table_after(page(tied, "made"), "## Forward, within strokes: RMSE in mm")
    assert table["Calibrated model"][2] == "**0.051**" and table["MLP model"][2].startswith("**0.051**")


def test_every_model_is_held_against_the_floor_that_it_is_entitled_to():
    table = numbers(made_metrics(), TITLES, ["mlp"]).set_index(["model", "split", "map", "column"]).sort_index()
    assert table.loc[("inn", "within", "forward", "all"), "ratio"] == pytest.approx(0.120 / 0.090)
    assert table.loc[("mlp", "within", "forward", "all"), "ratio"] == pytest.approx(0.051 / 0.049)
    assert table.loc[("calibrated", "later", "inverse", "n=9"), "ratio"] == pytest.approx(0.103 / 0.100)
    assert table.loc["inn", "direction"].unique().tolist() == [False]
    assert table.loc["floor", "ratio"].unique().tolist() == [1.0]


def told(metrics, directed, split="within", way="forward"):
    table = numbers(metrics, TITLES, directed)
    return sentences(table[(table["split"] == split) & (table["map"] == way)])


def test_the_page_says_who_is_best_where_and_how_the_inn_stands_among_the_others():
    metrics = made_metrics({**FORWARD, "calibrated": [0.131]})
    metrics.loc[(metrics["model"] == "inn") & (metrics["angle_band"] == "0-25%"), "value"] *= 0.1
    best, columns_won, inn, near = told(metrics, ["mlp"])
    assert best == (
        "- Least error forward, within strokes: MLP model (0.051 mm);"
        " of the models that are not told the direction: INN model (0.120 mm)."
    )
    rest = "n=1, n=9, winding, unwinding, 25-50%, 50-75%, 75-100%"
    assert columns_won == f"- Least error by column: INN model (0-25%); MLP model ({rest})."
    assert inn == (
        "- The INN model (0.120 mm) errs less than Calibrated model (0.131); more than MLP model (0.051)."
        " It is not told the direction, without which the floor is 0.090 mm instead of 0.049 mm."
    )
    assert near == ("- Models that know the direction and err by at most 1.05 × their floor: MLP model (1.04 ×).")
    assert "Calibrated model (0.705)" in told(metrics, ["mlp"], "later", "inverse")[2]


def test_what_a_table_cannot_tell_apart_shares_the_least_error():
    tied = told(made_metrics({**FORWARD, "calibrated": [0.0512]}), ["mlp"])
    assert tied[0].startswith("- Least error forward, within strokes: MLP model, Calibrated model (0.051 mm); of the ")
    assert tied[0].endswith("that are not told the direction: Calibrated model (0.051 mm).")
    assert tied[1] == "- Least error by column: MLP model (every column); Calibrated model (every column)."


def test_the_page_says_when_the_inn_loses_to_none_or_hardly():
    best = told(made_metrics({**FORWARD, "inn": [0.050]}), [])
    assert best[0] == "- Least error forward, within strokes: INN model (0.050 mm)."
    assert "(0.050 mm) errs less than all others: MLP model (0.051, within the spread of the seeds), Cal" in best[2]
    assert "more than" not in best[2] and "none of the others" not in best[2]
    worst = told(made_metrics({**FORWARD, "inn": [2.499]}), ["mlp"])[2]
    assert "- The INN model (2.499 mm) errs more than all others: MLP model (0.051), Calibrated" in worst
    alone = made_metrics(FORWARD)
    assert not [
        line for line in told(alone[alone["model"].isin(["inn", "floor", "floor_blind"])], []) if "errs" in line
    ]
    hardly = made_metrics({**FORWARD, "calibrated": [0.119]})
    assert "Calibrated model (0.119, within the spread of the seeds)" in told(hardly, ["mlp"])[2]
    assert told(made_metrics({**FORWARD, "mlp": [0.2]}), ["mlp"])[-1].endswith(": none.")
    assert len(told(made_metrics({name: FORWARD[name] for name in ("mlp", "floor", "floor_blind")}), ["mlp"])) == 3


def test_a_split_that_was_left_out_is_said_to_be():
    text = page(numbers(made_metrics(splits=("within",)), TITLES, ["mlp"]), "made")
    assert text.count("Skipped: the strings have too few strokes.") == 2


def test_the_program_writes_the_page_and_the_same_numbers_as_csv(tmp_path, monkeypatch):
    schemas.write(made_metrics(), schemas.METRICS, tmp_path / "metrics.parquet")
    titles = [f"{model}={title}" for model, title in TITLES.items()]
    words = [str(tmp_path / "metrics.parquet"), "--titles", *titles, "--directed", "mlp"]
    words += ["--out", str(tmp_path / "models.md"), "--table", str(tmp_path / "models.csv")]
    monkeypatch.setattr(sys, "argv", ["models", *words])
    with pytest.raises(SystemExit):
        main()
    assert (tmp_path / "models.md").read_text(encoding="utf-8").startswith("# made: every model beside the floor")
    rows = list(csv.DictReader(io.StringIO((tmp_path / "models.csv").read_text(encoding="utf-8"))))
    assert len(rows) == 5 * 2 * 2 * len(GROUPED) and float(rows[0]["median"]) == 0.12


def made_leak():
    """Errors of two fits of every group of the figure."""
    rows = []
    for number, group in enumerate(GROUPS, start=1):
        for seed in range(2):
            where = ("made", group, "within"), ("all", "all", "all", seed)
            for way, metric, value in [
                ("forward", "rmse", 0.05), ("inverse", "rmse", number / 10), ("inverse", "leak_rmse", number / 11),
                ("inverse", "residual_rmse", 0.05),
            ]:  # fmt: skip
                rows.append((*where[0], way, *where[1], metric, "mm", value))
    return pd.DataFrame(rows, columns=schemas.METRICS.names)


def test_the_figure_of_the_leak_is_drawn_with_the_blind_floor(tmp_path, monkeypatch):
    assert floor(made_metrics(), "inverse") == pytest.approx(0.45)
    for name, table in (("leak", made_leak()), ("metrics", made_metrics())):
        schemas.write(table, schemas.METRICS, tmp_path / f"{name}.parquet")
    words = [str(tmp_path / "leak.parquet"), str(tmp_path / "metrics.parquet"), "--out-dir", str(tmp_path)]
    monkeypatch.setattr(sys, "argv", ["leak", *words])
    with pytest.raises(SystemExit):
        draw()
    assert all((tmp_path / f"figure_leak.{suffix}").stat().st_size > 10_000 for suffix in ("png", "pdf"))


def drawn_leak(leak):
    with plt.rc_context(STYLE):
        figure = figure_leak(leak, made_metrics(), "made")
        figure.canvas.draw()
    plt.close(figure)
    return figure


def test_no_label_of_the_leaks_figure_touches_the_panel_beside_it():
    figure = drawn_leak(made_leak())
    for left_panel, right in pairwise(figure.axes):
        heads = [axes.xaxis.label.get_window_extent() for axes in (left_panel, right)]
        assert heads[1].x0 - heads[0].x1 > 0.15 * figure.dpi and right.get_window_extent().x0 > heads[0].x1
    rows = [label.get_window_extent() for label in figure.axes[0].get_yticklabels()]
    assert all(row.x0 > 0 and row.x1 < figure.axes[0].get_window_extent().x0 for row in rows)


def test_no_mark_of_the_leaks_figure_hides_another_one():
    """Whole error, leak and rest lay on each other in one column, and three slopes in another."""
    figure = drawn_leak(made_leak().assign(value=0.1))  # the worst: all of a panel at one value
    for axes in figure.axes:
        sizes = [(line, line.get_markersize() * figure.dpi / 72) for line in axes.lines if line.get_marker() != "None"]
        marks = [(*axes.transData.transform(xy), size) for line, size in sizes for xy in line.get_xydata()]
        assert len(marks) >= 2 * len(GROUPS)
        for place, (x, y, size) in enumerate(marks):
            assert all(np.hypot(x - other[0], y - other[1]) >= size for other in marks[:place])


@pytest.mark.parametrize("least", [1e-4, 0.02])
def test_no_number_of_the_leaks_axes_lies_on_another(least):
    leak = made_leak()
    leak.loc[leak["metric"] == "leak_rmse", "value"] = np.geomspace(least, 6.0, 8)
    for axes in drawn_leak(leak).axes:
        low, high = axes.get_xlim()
        labels = [
            label.get_window_extent()
            for at, label in zip(axes.get_xticks(), axes.get_xticklabels(), strict=True)
            if label.get_text() and low <= at <= high
        ]
        assert len(labels) >= 2 and all(left_label.x1 < right.x0 for left_label, right in pairwise(labels))


def test_the_leaks_figure_explains_itself_and_no_legend_lies_on_data():
    figure = drawn_leak(made_leak())
    for axes in figure.axes:
        legend = axes.get_legend().get_window_extent()
        assert legend.y1 < axes.get_window_extent().y0 and legend.y0 > figure._supxlabel.get_window_extent().y1
    assert figure.get_suptitle() == "made: why an INN trained one way fails the other way", "its numbers were a wall"
    lines = figure.get_supxlabel().split("\n")
    assert len(lines) <= 5, "a caption that is longer is not read"
    assert lines[2].startswith("Leak and rest of θ, medians in turns: A 0.091 and 0.05, B 0.18 and 0.05 (not mended)")
    words = " ".join(lines)
    assert "A mark is one training" in words and "Rest: the error of θ that comes from the error of x." in words
    assert "Leak: the error of θ from their change, " in words and "they do not" not in words, "no riddle"
    assert "cancel" not in words, "nothing to explain: no part is larger than the whole here"
    assert "the twist θ into the contraction x" in words and "Mended: the leak is smaller than the rest." in words
    rows = " ".join(label.get_text() for label in figure.axes[0].get_yticklabels())
    assert all(f"{letter} 0." in lines[2] for letter in "ABCD"), "C alone said no number of D"
    assert "puts all values back" in rows and "undo each other" not in rows + words
    assert all(letter in rows for letter in "ABCD") and "with the settings\nof the INN of Tables I, II" in rows
    assert all(axes.get_xlabel().endswith(("(mm)", "(turns), logarithmic")) for axes in figure.axes)


@pytest.mark.parametrize(
    ("leaks", "words"),
    [
        ((1.6, 0.04, 0.05), "A 1.6 and 0.05, B 0.04 and 0.05 (mended), C 0.05 and 0.05 (mended)"),
        ((5.9, 6.0, 0.001), "B 6 and 0.05 (not mended), C 0.001 and 0.05 (mended)"),
        ((5.9, 6.0, 0.3), "C 0.3 and 0.05 (not mended)"),
        ((0.03, 0.02, 0.01), "A 0.03 and 0.05, B 0.02 and 0.05, C 0.01 and 0.05"),
    ],
)
def test_the_leaks_figure_calls_a_remedy_what_is_one_on_its_data(leaks, words):
    """In the quick configuration one of the two remedies is none, and the figure called it one."""
    leak = made_leak()
    for group, value in zip(GROUPS, leaks, strict=False):
        leak.loc[(leak["model"] == group) & (leak["metric"] == "leak_rmse"), "value"] = value
    figure = drawn_leak(leak)
    fails = "why an INN trained one way fails the other way" in figure.get_suptitle()
    assert fails == (leaks[0] > 0.05) and f"{words}, D " in " ".join(figure.get_supxlabel().split())


def test_a_leak_that_is_larger_than_the_whole_error_is_explained():
    leak = made_leak()
    leak.loc[(leak["model"] == "random_both") & (leak["metric"] == "leak_rmse") & (leak["seed"] == 0), "value"] = 0.25
    words = " ".join(drawn_leak(leak).get_supxlabel().split())
    cancel = "can cancel in part: the leak alone is larger than the whole error in 1 of 8 trainings."
    assert cancel in words and "rest alone is larger" not in words


def test_the_spread_of_the_seeds_stands_on_a_line_of_its_own():
    shown = web_page("# a\n\n| model | all |\n| --- | --- |\n| INN (2–3) | **0.120** (0.118–0.125) |\n", None)
    assert "<strong>0.120</strong><br><small>(0.118\u2060–\u20600.125)</small></td>" in shown
    assert shown.count("<small>") == 1


@needs_browser
def test_every_table_fits_a_page_of_1200_pixels_even_where_every_cell_has_a_spread(tmp_path):
    seeds = {model: [0.120, 0.118, 0.125] for model in ("inn", "mlp", "diagnosed", "floor", "floor_blind")}
    base_metrics = made_metrics(seeds)
    metrics = pd.concat([base_metrics, base_metrics[base_metrics["stroke"] == "1"].assign(stroke="5")])
    titles = {"inn": "Conditional INN", "mlp": "MLP model", "diagnosed": "Diagnosed simulator"}
    (tmp_path / "models.html").write_text(web_page(page(numbers(metrics, titles, ["mlp"]), "made"), None))
    script = """<script>
      const all = [...document.querySelectorAll(".scroll")];
      const wide = all.filter(table => table.scrollWidth > table.clientWidth);
      document.title = [innerWidth, all.length, all[0].querySelectorAll("th").length, wide.length].join("|");
    </script></body>"""
    assert clicked(tmp_path / "models.html", script, tmp_path) == "1200|4|13|0"


def test_the_page_names_the_file_of_every_fit_and_how_it_is_used():
    """No page named a .model file, and two commands need one."""
    forward = FORWARD | {"spline": [0.05]}
    metrics = made_metrics(forward)
    metrics = metrics[~((metrics["model"] == "mlp") & (metrics["split"] == "later"))]
    text = "\n".join(lines_on_files(metrics, "nylon"))
    assert "`python -m pipeline.export processed/nylon/spline/within-0.model --format c`" in text
    assert "`python -m pipeline.predict processed/nylon/dataset.parquet questions.csv --model spline --out" in text
    inn = ", ".join(f"`within-{seed}.model`" for seed in range(3))
    assert f"| `processed/nylon/inn/` | {inn} | {inn.replace('within', 'later')} |" in text
    assert f"| `processed/nylon/mlp/` | {inn} |  |" in text and "floor" not in text
    assert "processed/nylon/calibrated/within-0.model --format c" in "\n".join(
        lines_on_files(metrics[metrics["model"] == "calibrated"], "nylon")
    )
    assert lines_on_files(metrics[metrics["model"] == "floor"], "nylon") == []


def test_the_main_job_ends_with_the_commands_that_use_a_fitted_model(tmp_path):
    models = [Path(f"processed/nylon/{name}/within-0.model") for name in ("spline", "cinn", "diagnosed")]
    none = Path("none.csv")
    unrelated = Path("processed/silk/mlp/within-0.model")
    assert lines_at_end("nylon", [*models, unrelated], none, whole_motion=["diagnosed"]) == [
        "to a controller: python -m pipeline.export processed/nylon/spline/within-0.model --format c",
        "to ask it: python -m pipeline.predict processed/nylon/dataset.parquet questions.csv"
        " --model spline --out reports/mine/answers.csv",
        "questions.csv has a row for each question: docs/use_a_model.md shows one",
        "fitted too: cinn",
    ]
    assert lines_at_end("nylon", [Path("processed/nylon/spline/later-0.model")], none) == []
    (tmp_path / "models.csv").write_text(
        "model,split,map,column,median\nspline,later,forward,all,2\ncinn,later,forward,all,1\n"
    )
    reason, export, *_ = lines_at_end("nylon", models, tmp_path / "models.csv")
    assert "processed/nylon/cinn/within-0.model" in export
    least = "Its forward error on later strokes is the least of those that can be exported: 1.000 mm."
    assert reason == f"model to take: cinn. {least}"


def test_later_strokes_under_a_load_that_few_learnt_strokes_have_do_not_decide_which_model_to_take(tmp_path):
    """Of 26 strokes the last seven were under 30 N, and a small MLP was taken, 2.5 times worse inside strokes."""
    rows = ["spline,within,forward,all,0.073,False", "mlp,within,forward,all,0.185,False"]
    rows += ["spline,later,forward,all,0.46,{0}", "mlp,later,forward,all,0.267,{0}"]
    models, models_csv = ["spline", "mlp"], tmp_path / "models.csv"

    def advised(is_apart):
        text = "\n".join(["model,split,map,column,median,other_conditions", *rows]).format(is_apart)
        models_csv.write_text(text + "\n")
        return advice_on(models, models_csv)

    assert advised(False).model == "mlp" and NOT_DECIDED not in advised(False).reason
    assert advised(True).model == chosen_of(models, errors_in(models_csv)) == "spline"
    assert "on held-out points inside strokes is the least" in advised(True).reason
    assert advised(True).reason.endswith(NOT_DECIDED)


def test_the_main_job_says_how_the_model_to_take_errs_at_the_inverse_and_which_is_better_there(tmp_path):
    """It named `calibrated`, whose inverse erred by 0.51 turns where the spline's did by 0.21, and no word said so."""
    models = [Path(f"processed/nylon/{name}/within-0.model") for name in ("calibrated", "spline", "diagnosed")]
    rows = ["model,split,map,column,median", "calibrated,later,forward,all,0.166", "spline,later,forward,all,0.3"]
    rows += ["diagnosed,later,forward,all,0.051", "calibrated,later,inverse,all,0.51"]

    def ends(spline_turns):
        marked = with_motion_marked([*rows, f"spline,later,inverse,all,{spline_turns}"])
        (tmp_path / "models.csv").write_text("\n".join(marked))
        return lines_at_end("nylon", models, tmp_path / "models.csv", whole_motion=["diagnosed"])

    reason, at_inverse, export, by_position, *_ = ends(0.21)
    least = "Its forward error on later strokes is the least of those that can be exported: 0.166 mm."
    assert reason == f"model to take: calibrated. {least}", "diagnosed has 0.051 mm in models.md"
    assert at_inverse == (
        "Its inverse error on later strokes is 0.510 turns. A position controller asks the inverse (tsa_inverse of an "
        "export): for that take the spline, which errs less at it: 0.210 turns against 0.510 turns. Forward it errs by "
        "0.300 mm against 0.166 mm."
    )
    assert export == "to a controller: python -m pipeline.export processed/nylon/calibrated/within-0.model --format c"
    assert by_position.startswith("to a position controller: python -m pipeline.export processed/nylon/spline/within-0")
    _, at_inverse, export, ask_line, *_ = ends(0.48)
    assert at_inverse == "Its inverse error on later strokes is 0.510 turns.", "so little less is told as alike"
    assert "calibrated" in export and ask_line.startswith("to ask it: ")


def test_the_pages_say_which_model_is_better_at_the_inverse(tmp_path):
    titles = {"mlp": "MLP model", "spline": "Spline model"}
    metrics = made_metrics(FORWARD | {"spline": [0.058]})
    metrics.loc[(metrics["model"] == "mlp") & (metrics["map"] == "inverse"), "value"] *= 0.1
    metrics.loc[(metrics["model"] == "mlp") & (metrics["split"] == "later"), "value"] *= 1.2
    begins = page(numbers(metrics, titles, ["mlp"]), "made").split("RMSE on held-out")[0]
    assert begins.count("for that take the MLP model, which errs less at it: ") == 1, begins
    (tmp_path / "nylon").mkdir()
    rows = ["model,title,split,map,column,median,ratio"]
    rows += [f"{name},{titles[name]},later,forward,all,{error},2" for name, error in (("spline", 0.1), ("mlp", 0.2))]
    rows += [f"{name},{titles[name]},later,inverse,all,{error},2" for name, error in (("spline", 0.5), ("mlp", 0.2))]
    (tmp_path / "nylon" / "models.csv").write_text("\n".join(rows))
    index = str(together(materials_table(tmp_path, ["nylon"], str)))
    assert "take the MLP model, which errs less at it: 0.200 turns against 0.500 turns. Forward it errs by 0.2" in index


def test_the_main_job_says_why_the_model_to_take_is_not_the_best_of_the_tables(tmp_path):
    """The tables called the polynomial the best; the line below them exported the spline, without a word."""
    models = [Path(f"processed/nylon/{name}/within-0.model") for name in ("spline", "polynomial", "diagnosed")]
    errors = {("spline", "later"): 0.039, ("spline", "within"): 0.049, ("polynomial", "later"): 0.037}
    errors |= {("polynomial", "within"): 0.038, ("diagnosed", "within"): 0.034, ("diagnosed", "later"): 0.03}
    rows = [f"{model},{split},forward,all,{error}" for (model, split), error in errors.items()]
    marked = with_motion_marked(["model,split,map,column,median", *rows])
    (tmp_path / "models.csv").write_text("\n".join(marked) + "\n")
    assert lines_at_end("nylon", models, tmp_path / "models.csv", whole_motion=["diagnosed"])[0] == (
        "model to take: spline. Its forward error on later strokes, 0.039 mm, is at most 1.1 times the least of those "
        "that can be exported. Inside strokes, which the tables show, polynomial errs less: 0.038 mm against 0.049 mm. "
        "If your strokes stay as recorded, take polynomial."
    )


@pytest.mark.parametrize(
    ("polynomial_mm", "floor_mm", "is_recommended"),
    [(0.030, 0.02, False), (0.027, 0.02, True), (0.027, 0.04, False), (0.027, None, True)],
)
def test_a_second_model_is_recommended_only_where_it_errs_less_by_a_fifth_and_by_what_a_rig_shows(
    tmp_path, polynomial_mm, floor_mm, is_recommended
):
    """The page recommended it over 0.005 mm of 0.035 mm, with a noise of 0.02 mm."""
    rows = ["model,title,split,map,column,median,ratio", "spline,Spline,later,forward,all,0.03,2"]
    rows += ["polynomial,Polynomial,later,forward,all,0.04,2"]
    ratio = (lambda error: f"{error / floor_mm:.6g}") if floor_mm else (lambda _: "")
    errors = {"spline": 0.035, "polynomial": polynomial_mm}
    rows += [f"{name},{name.title()},within,forward,all,{error},{ratio(error)}" for name, error in errors.items()]
    rows += [f"floor,floor,within,forward,all,{floor_mm},1"] if floor_mm else []
    (tmp_path / "nylon").mkdir()
    (tmp_path / "nylon" / "models.csv").write_text("\n".join(rows) + "\n")
    models_csv = tmp_path / "nylon" / "models.csv"
    reason = advice_on(["spline", "polynomial"], models_csv).reason
    assert f"polynomial errs less: {polynomial_mm:.3f} mm against 0.035 mm." in reason
    assert ("If your strokes stay as recorded, take polynomial." in reason) is is_recommended
    assert ("Take the Polynomial if only strokes" in Models.read(models_csv).weighed()) is is_recommended


@pytest.mark.parametrize(("polynomial_mm", "is_named"), [(0.0101, False), (0.0084, True)])
def test_a_second_model_is_named_only_where_the_two_printed_numbers_differ(tmp_path, polynomial_mm, is_named):
    """ "polynomial errs less: 0.010 mm against 0.010 mm." said nothing."""
    rows = ["model,title,split,map,column,median,ratio", "spline,Spline,later,forward,all,0.03,2"]
    rows += ["polynomial,Polynomial,later,forward,all,0.04,2", "spline,Spline,within,forward,all,0.0104,2"]
    rows += [f"polynomial,Polynomial,within,forward,all,{polynomial_mm},2"]
    (tmp_path / "models.csv").write_text("\n".join(rows) + "\n")
    reason = advice_on(["spline", "polynomial"], tmp_path / "models.csv").reason
    assert reason.startswith("model to take: spline. ")
    assert ("polynomial errs less: 0.008 mm against 0.010 mm." in reason) is is_named
    assert ("errs less" in reason) is is_named, reason


def test_a_model_that_errs_less_by_no_printed_number_is_recommended_nowhere():
    """Errors below a hundredth of a millimetre can be ten percent apart and read the same."""
    titles = {"spline": "Spline", "polynomial": "Polynomial"}
    for less, own, is_named in ((0.0008, 0.0012, False), (0.0008, 0.0024, True)):  # 0.001, 0.001 and 0.002
        errors = {("spline", "within"): own, ("polynomial", "within"): less}
        errors |= {("spline", "later"): 0.03, ("polynomial", "later"): 0.04}
        assert bool(weighed(titles, errors, 0.0)) is is_named
        within = {key: size for key, size in errors.items() if key[1] == "within"}
        assert better_at_the_inverse("spline", list(titles), within) == ("polynomial" if is_named else "")


def test_the_models_page_weighs_a_second_model_by_the_floor_too():
    titles = {"mlp": "MLP model", "spline": "Spline model"}
    for spline_mm, is_recommended in ((0.058, False), (0.085, True)):
        metrics = made_metrics(FORWARD | {"spline": [spline_mm]})
        metrics.loc[(metrics["model"] == "mlp") & (metrics["split"] == "later"), "value"] *= 2.0
        begins = page(numbers(metrics, titles, ["mlp"]), "made").split("RMSE on held-out")[0]
        assert "On strokes like the recorded ones the MLP model errs less forward" in begins
        assert ("Take the MLP model if only strokes" in begins) is is_recommended, begins


@pytest.mark.parametrize(
    ("ratio", "words"),
    [(0.9, "0.90"), (1.0, "1.00"), (1.037, "1.04"), (23.275, "23.3"), (232.75, "233"), (4321.0, "4320")],
)
def test_a_ratio_has_three_digits_at_most(ratio, words):
    """`7.271 (232.75 ×)` stood on the index."""
    assert times_floor(ratio) == words
