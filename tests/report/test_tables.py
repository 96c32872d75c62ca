import csv
import io
import json
from dataclasses import replace

import pandas as pd
import pytest
from in_a_browser import clicked, needs_browser

from pipeline.ground.stored import schemas
from pipeline.report.comparison import comparison
from pipeline.report.layout import paper
from pipeline.report.layout.made_by import MadeBy
from pipeline.report.layout.table_forms import from_markdown, to_csv, to_latex, to_markdown
from pipeline.report.parts.materials import html_table
from pipeline.report.tables import rows, write
from pipeline.report.web.page import document

TITLES = {"inn": "INN model", "mlp": "MLP model", "traditional": "Traditional model"}
HEADERS = {
    1: "Model,Stroke times,Average error (mm),Maximum error (mm),RMSE (mm)",
    2: "Model,Stroke times,Average error (θ/2π),Maximum error (θ/2π),RMSE (θ/2π)",
}


def made_metrics(strokes=(1, 5, 9), seeds=5):
    """Metrics whose value tells where it came from: model + stroke/10 + metric/100 + seed/1000, unwinding + 50."""
    lines = []
    for model_number, model in enumerate(TITLES, 1):
        for split in ("within", "later"):
            for direction in ("forward", "inverse"):
                for stroke in strokes:
                    for phase, more in (("winding", 0), ("unwinding", 50)):
                        for number, metric in enumerate(paper.METRICS, 1):
                            for seed in range(seeds):
                                value = model_number + stroke / 10 + number / 100 + seed / 1000 + more
                                value += 100 * (split == "later") + 1000 * (direction == "inverse")
                                lines.append(
                                    ("m", model, split, direction, str(stroke), phase, "all", seed, metric, "mm", value)
                                )
    return pd.DataFrame(lines, columns=schemas.METRICS.names)


@pytest.mark.parametrize("number", [1, 2])
def test_csv_layout_is_the_one_that_programs_read(number):
    text = to_csv(number, rows(made_metrics(), number, TITLES))
    assert text.splitlines()[0] == HEADERS[number]
    body = list(csv.reader(io.StringIO(text)))[1:]
    assert [line[0] for line in body] == [title for title in TITLES.values() for _ in range(3)]
    assert [line[1] for line in body] == ["n=1", "n=5", "n=9"] * 3


def test_cells_are_medians_of_the_seeds_within_and_winding():
    body = list(csv.reader(io.StringIO(to_csv(1, rows(made_metrics(), 1, TITLES)))))[1:]
    assert body[0][2:] == ["1.112", "1.122", "1.132"]
    assert body[7][2:] == ["3.512", "3.522", "3.532"]
    inverse = list(csv.reader(io.StringIO(to_csv(2, rows(made_metrics(), 2, TITLES)))))[1:]
    assert inverse[0][2] == "1001.112"


def test_cells_are_medians_not_means_and_of_the_whole_range():
    metrics = made_metrics(strokes=(1,), seeds=3)
    metrics["value"] = metrics["seed"].map({0: 1.0, 1: 2.0, 2: 9.0})
    poison = metrics.assign(angle_band="0-25%", value=99.0)
    table = rows(pd.concat([metrics, poison], ignore_index=True), 1, TITLES)
    assert table[0][2] == ["2.000"] * 3


def test_a_stroke_that_is_not_there_keeps_its_row_empty():
    body = list(csv.reader(io.StringIO(to_csv(1, rows(made_metrics(strokes=(1,)), 1, TITLES)))))[1:]
    assert len(body) == 9
    assert body[1] == ["INN model", "n=5", "", "", ""]


def test_markdown_and_latex_hold_the_same_numbers():
    table = rows(made_metrics(), 1, TITLES)
    markdown, latex = to_markdown(1, table), to_latex(1, table, "tab:one")
    for _, _, cells in table:
        assert all(cell in markdown and cell in latex for cell in cells)
    assert latex.count(r"\multirow") == 3 and markdown.count("INN model") == 1
    assert r"$\theta/2\pi$" in to_latex(2, table, "tab:two")


def test_the_markdown_table_can_be_read_back_whatever_a_title_holds():
    table = rows(made_metrics(), 1, {"inn": "<b> | *INN* [a](b) \\", "mlp": "MLP model"})
    caption, head, body, notes = from_markdown(to_markdown(1, table, "small fit", ("one", "two")))
    assert caption.endswith("(small fit)") and head == paper.header(1) and notes == ["one", "two"]
    assert body == [[title, stroke, *cells] for title, stroke, cells in table]


def test_latex_shows_a_title_as_it_is_and_has_a_label():
    text = to_latex(1, rows(made_metrics(), 1, {"inn": r"50 % of a_b & {c} \d"}), "tab:m-forward")
    assert r"{50 \% of a\_b \& \{c\} \textbackslash{}d}" in text and r"\label{tab:m-forward}" in text
    assert text.index(r"\caption") < text.index(r"\label") < text.index(r"\begin{tabular}")


SMALL = MadeBy("ci.yaml", "abc1234", "small", "INN model 2 seeds of 3 epochs", ())


def test_every_form_of_a_small_fit_says_that_it_is_no_result_and_the_csv_keeps_its_layout(tmp_path):
    write(made_metrics(), 1, TITLES, SMALL, tmp_path)
    plain = to_csv(1, rows(made_metrics(), 1, TITLES))
    assert (tmp_path / "table_1.csv").read_text() == plain and plain.splitlines()[0] == HEADERS[1]
    for suffix in ("md", "tex"):
        text = (tmp_path / f"table_1.{suffix}").read_text()
        assert "COMPARISON (small fit: not a result, made by ci.yaml)" in text
        assert "Small fit, not a result: made by ci.yaml" in text and "2 seeds of 3 epochs" in text
    beside = json.loads((tmp_path / "table_1.csv-metadata.json").read_text())
    assert beside["url"] == "table_1.csv" and beside["schema:creativeWorkStatus"] == "small fit: not a result"
    assert [column["titles"] for column in beside["tableSchema"]["columns"]] == HEADERS[1].split(",")


def test_a_result_carries_the_name_of_its_configuration_and_no_warning(tmp_path):
    write(made_metrics(), 2, TITLES, MadeBy("default.yaml", "abc1234", "default", "", ()), tmp_path)
    text = (tmp_path / "table_2.md").read_text()
    assert text.startswith("TABLE II: INVERSE KINEMATICS MODEL ERROR COMPARISON\n")
    assert text.endswith("\nMade by the default configuration, default.yaml (checksum of its settings abc1234).\n")


def test_a_jump_of_the_zero_stands_beneath_the_tables(tmp_path):
    made_by = MadeBy("default.yaml", "abc1234", "default", "", ())
    write(made_metrics(), 1, TITLES, made_by, tmp_path, jumped=["The zero jumps by 0.6 mm."])
    assert "Beware: The zero jumps by 0.6 mm." in (tmp_path / "table_1.md").read_text()
    assert "the zero jumps between runs" in (tmp_path / "table_1.tex").read_text()
    assert "zero" not in (tmp_path / "table_1.csv").read_text()


def test_eight_strokes_give_no_empty_row_where_a_person_reads(tmp_path):
    write(made_metrics(strokes=range(1, 9)), 1, TITLES, SMALL, tmp_path)
    markdown, latex = ((tmp_path / f"table_1.{suffix}").read_text() for suffix in ("md", "tex"))
    assert from_markdown(markdown)[2][1][1] == "n=5" and len(from_markdown(markdown)[2]) == 6
    assert "n=9$" not in latex and latex.count(r"\multirow{2}") == 3
    for text in (markdown, latex):
        assert "Shown are strokes 1 and 5 of 1 to 8 (the paper has 1, 5 and 9)." in text
    assert (tmp_path / "table_1.csv").read_text().count("n=9,,,\n") == 3
    compared = comparison(made_metrics(strokes=range(1, 9)), "m", TITLES)
    assert (
        "| n=9 |" not in compared.split("## Forward, later")[0]
        and "Shown are strokes 1 and 5 of 1 to 8 (the" in compared
    )


def test_every_form_says_which_of_many_strokes_it_shows_and_where_all_are(tmp_path):
    write(made_metrics(strokes=range(1, 13)), 1, TITLES, SMALL, tmp_path)
    words = "Shown are strokes 1, 5 and 9 of 1 to 12. All strokes are rows of processed/"
    for text in ((tmp_path / "table_1.md").read_text(), (tmp_path / "table_1.tex").read_text()):
        assert words in text
    assert words in comparison(made_metrics(strokes=range(1, 13)), "m", TITLES)
    columns = json.loads((tmp_path / "table_1.csv-metadata.json").read_text())["tableSchema"]["columns"]
    assert "shown are the paper's three, processed/" in columns[1]["dc:description"]
    for number in (1, 2):
        write(made_metrics(strokes=range(1, 13)), number, TITLES, SMALL, tmp_path)
    assert html_table(tmp_path, 1, "").count("Shown are strokes 1, 5 and 9 of 1 to 12.") == 1
    assert "the paper has" not in html_table(tmp_path, 1, ""), "noise where the strokes are there"
    inverse = html_table(tmp_path, 2, "")
    assert inverse.count("(turns)") == 3 and "(θ/2π)" not in inverse, "the paper's head is no unit"
    assert "; the files call the turns θ/2π, as the paper does." in inverse and "csv has" not in inverse
    assert "θ/2π" not in html_table(tmp_path, 1, "") and inverse.count('class="again"') == 2 * len(TITLES)
    write(made_metrics(strokes=range(1, 7)), 2, TITLES, SMALL, tmp_path)
    six = html_table(tmp_path, 2, "")
    assert "n=9" not in six.split("</table>")[0], "and the page says why the csv has it"
    assert "; the csv has n=9 too, in empty cells." in six
    assert "n is the number of the stroke." in inverse
    write(made_metrics(), 1, TITLES, SMALL, tmp_path)
    assert "Shown" not in (tmp_path / "table_1.md").read_text()


def test_comparison_shows_the_paper_beside_ours_with_the_spread():
    text = comparison(made_metrics(), "m", TITLES)
    assert "The paper has numbers of two of these models" in text and "taken as 0, so the" in text
    assert "| INN model | n=1 | 1.112 (1.110–1.114) | 0.180 |" in text
    assert "| Traditional model | n=9 | 3.912 (3.910–3.914) | 2.101 |" in text
    assert "later strokes, winding" in text and "101.112" in text


def test_comparison_says_at_its_top_why_the_inn_is_not_the_papers():
    floor = made_metrics()[lambda rows: rows["model"] == "inn"].assign(model="floor_blind")
    metrics = pd.concat([made_metrics(), floor.assign(value=0.9 * floor["value"])])
    text = comparison(metrics, "synthetic", TITLES)
    top = text.partition("Errors are on held-out points only")[0]
    assert (
        "not to those of its INN: forward, winding, n=5, the INN's RMSE is 1.532 mm here and 0.269 mm in the paper"
        in top
    )
    assert "Here noise makes 1.379 mm, together with the loop" in top
    assert "This rig is not the paper's" in comparison(metrics, "nylon", TITLES)
    assert "So a difference from the paper tells of the recording" in top
    far = pd.concat([made_metrics(), floor.assign(value=0.1 * floor["value"])])
    text = comparison(far, "nylon", TITLES)
    assert (
        "This network errs by 10.0 times that: its errors cannot be compared" in text and "tells of the rec" not in text
    )
    assert "1.112" in comparison(metrics, "nylon", TITLES) and "in the paper." not in comparison(
        made_metrics(), "m", TITLES
    )


def test_comparison_says_of_each_error_whether_the_traditional_model_agrees_with_the_paper():
    metrics = made_metrics().astype({"value": float})
    for number, direction in paper.MAPS.items():
        for stroke, printed in paper.TABLES[number]["traditional"].items():
            for metric, theirs in zip(paper.METRICS, printed, strict=True):
                at = (metrics["map"] == direction) & (metrics["stroke"] == str(stroke)) & (metrics["metric"] == metric)
                metrics.loc[at & (metrics["model"] == "traditional"), "value"] = theirs * (1.0 - 0.02 * number)
    text = comparison(metrics, "synthetic", TITLES)
    assert "Yes: 6 of 6 errors agree." in text
    assert "`python tests/golden/check_metrics.py reports`" in text
    assert text.count("agrees, within 2.0 %") == text.count("agrees, within 4.0 %") == 3
    off = (metrics["stroke"] == "5") & (metrics["metric"] == "rmse") & (metrics["map"] == "inverse")
    wrong = metrics.assign(value=metrics["value"].where(~off | (metrics["split"] == "later"), 3.14 * 1.2))
    text = comparison(wrong, "synthetic", TITLES)
    assert "No: 5 of 6 errors agree" in text
    assert "- Table II, inverse, RMSE (θ/2π): does not agree: 20.0 % off" in text
    assert "errors agree" not in comparison(metrics, "nylon", TITLES)  # another string: nobody expects it
    assert "errors agree" not in comparison(metrics[metrics["model"] != "traditional"], "synthetic", TITLES)


def test_comparison_of_another_rig_says_first_that_no_agreement_is_expected_and_counts_none():
    metrics, mark = made_metrics(), replace(SMALL, rig="set-up small (2 strokes)")
    text = comparison(metrics, "synthetic", TITLES, mark=mark)
    top = text.partition("Errors are on held-out points only")[0]
    assert "No agreement with the paper is expected here: ci.yaml records another synthetic rig" in top
    assert "and its trainings are short. This rig is set-up small (2 strokes)." in top and "snakemake --cores 2" in top
    assert "errors agree" not in text and "was fitted to the errors" not in text
    assert "errors agree" in comparison(metrics, "synthetic", TITLES, mark=SMALL)
    assert "No agreement" not in comparison(metrics, "nylon", TITLES, mark=mark)


def made_points(runs):
    """A point of a stroke of each run, all of one string; the last of several under more load and wound less."""
    points = pd.DataFrame({"run": runs, "string": "s", "stroke": range(1, 1 + len(runs))})
    points["load_n"], points["motor_turns"], points["later"] = 20.0, 27.2, ""
    if len(runs) > 1:
        points.loc[points.index[-1], ["load_n", "motor_turns"]] = 30.0, 16.0
    return points


def test_every_form_says_of_a_shown_stroke_that_it_was_recorded_otherwise(tmp_path):
    points = made_points(["m-01"] * 5)
    words = "Recorded under other conditions: n=5 at 30 N and to 16 turns; the others of "
    words += "those shown at 20 N and to 27.2 turns."
    write(made_metrics(), 1, TITLES, SMALL, tmp_path, dataset=points)
    markdown, latex = ((tmp_path / f"table_1.{suffix}").read_text() for suffix in ("md", "tex"))
    assert words in markdown and words in latex and words in html_table(tmp_path, 1, "")
    assert words.replace(" of those shown", "") in comparison(made_metrics(), "m", TITLES, dataset=points)
    write(made_metrics(strokes=(1, 9)), 1, TITLES, SMALL, tmp_path, dataset=points)  # n=5 is not among its rows
    assert "other conditions" not in (tmp_path / "table_1.md").read_text()


def test_every_form_says_of_which_rows_strings_are_together(tmp_path):
    points = pd.concat([made_points(["m-01"] * 5), made_points(["m-02"]).assign(string="t")], ignore_index=True)
    write(made_metrics(), 1, TITLES, SMALL, tmp_path, dataset=points)
    words = "Strings together: n=1 holds that stroke of 2 strings, n=5 of 1 (s, t), as every string counts its own."
    markdown, latex = ((tmp_path / f"table_1.{suffix}").read_text() for suffix in ("md", "tex"))
    assert words in markdown and words in latex and words in html_table(tmp_path, 1, "")


def test_every_form_says_what_its_numbers_are_of(tmp_path):
    metrics = made_metrics()
    metrics = metrics[(metrics["model"] == "inn") | (metrics["seed"] == 0)]
    runs = ["m-01", "m-02", "m-03", "m-04", "m-05"]
    write(metrics, 2, TITLES, SMALL, tmp_path, dataset=made_points(runs))
    words = (
        "Material m: inverse errors on held-out points of the split within (each stroke is cut into short blocks, "
        "and one block in four is held out), winding, median over the seeds (5 of INN model; the others one fit); "
        "made of runs m-01, m-02, m-03 and 2 more."
    )
    markdown, latex = ((tmp_path / f"table_2.{suffix}").read_text() for suffix in ("md", "tex"))
    assert words in markdown.split("\n\n")[2] and words in latex and words not in markdown.split("\n\n")[1]
    assert latex.splitlines()[0] == r"% needs \usepackage{multirow} before \begin{document}"
    write(metrics[metrics["seed"] == 0], 1, TITLES, SMALL, tmp_path, dataset=made_points(["m-01"]))
    text = (tmp_path / "table_1.md").read_text()
    assert "Material m: forward errors on" in html_table(tmp_path, 1, "")
    assert "forward errors on" in text and "(one fit of each model); made of run m-01." in text


def test_comparison_says_when_later_was_skipped():
    metrics = made_metrics()
    assert "Skipped" in comparison(metrics[metrics["split"] == "within"], "m", TITLES)


def test_the_papers_numbers_are_the_papers():
    assert paper.TABLES[2]["traditional"][9] == (3.239, 6.945, 3.470)
    assert sum(len(by_stroke) * 3 for table in paper.TABLES.values() for by_stroke in table.values()) == 36


@needs_browser
def test_the_caption_of_a_wide_table_wraps_and_a_name_stands_once_until_the_table_is_sorted(tmp_path):
    """On a narrow page the caption was cut before its mark, "(small fit: not a result"; names stood in each row."""
    write(made_metrics(), 1, TITLES, SMALL, tmp_path)
    (tmp_path / "page.html").write_text(document("made", html_table(tmp_path, 1, ""), SMALL))
    script = """<script>
      document.querySelector("table").style.width = "3000px";
      const caption = document.querySelector("caption span");
      const seen = () => getComputedStyle(document.querySelector(".again")).visibility;
      caption.textContent = "a long caption ".repeat(50);
      const before = seen(), right = caption.getBoundingClientRect().right;
      document.querySelector("th:last-child button").click();
      document.title = [right <= innerWidth, before, seen()].join("|");
    </script></body>"""
    assert clicked(tmp_path / "page.html", script, tmp_path) == "true|hidden|visible"
