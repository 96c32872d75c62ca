"""The index: the short answer first, every name escaped, every link relative, and what the end of a run names."""

import html
import json
import re
import shutil
from html.parser import HTMLParser
from urllib.parse import unquote

import numpy as np
import pandas as pd
import programs
import pytest
from made_verdict import made_verdict
from stages.nine_strokes import NINE, recorded
from test_diagnoses import FINE, TIED
from test_models_page import TITLES, made_metrics
from test_tables import made_metrics as made_table_metrics

from pipeline.diagnosis.study.heldout import LAST
from pipeline.ground.kinematics import usual_stiffness
from pipeline.ground.stored import schemas
from pipeline.ground.words.jump_notes import write_jumps
from pipeline.ground.words.left_out import LeftOut, to_json
from pipeline.report.end_of_job.summary import summary
from pipeline.report.index import page
from pipeline.report.layout.made_by import MadeBy
from pipeline.report.model_to_take.to_take import LATER, Models, materials_table
from pipeline.report.model_to_take.usual_model import RULE, RULES, uses
from pipeline.report.models import NOTES
from pipeline.report.parts.diagnoses import tag
from pipeline.report.parts.index_head import glance, next_run, runs_table, shortened
from pipeline.report.parts.page_parts import of_materials, of_runs
from pipeline.report.parts.recorded_strings import by_stroke, recorded_strings, rows, sentence
from pipeline.report.web.markdown import web_page
from pipeline.report.web.page import anchor, together

HOSTILE = "<img src=x onerror=alert(1)>"
SMALL = MadeBy(f"{HOSTILE}.yaml", "abc1234", "small", f"{HOSTILE} 2 seeds", ())
MATERIAL = "nylon"
TITLE = f"Model |{HOSTILE}"


class Seen(HTMLParser):
    """Tags, addresses and ids of a page."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.addresses, self.ids, self.handlers = [], [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        for name, value in attributes:
            if name in ("href", "src"):
                self.addresses.append(value)
            if name == "id":
                self.ids.append(value)
            if name.startswith("on"):
                self.handlers.append((tag, name))


def run(program, *words):
    done = programs.run(f"pipeline.report.{program}", *words)
    assert done.returncode == 0, done.stderr


@pytest.fixture(scope="module")
def reports(tmp_path_factory):
    """Reports of one material with hostile titles and of runs with hostile names, all by the real programs."""
    root = tmp_path_factory.mktemp("project")
    out, mark = root / "reports" / MATERIAL, ("--made-by", SMALL.packed())
    titles = ["--titles", f"inn={TITLE}", *(f"{model}={title}" for model, title in TITLES.items() if model != "inn")]
    for name, metrics in (("models", made_metrics()), ("tables", made_table_metrics())):
        table = metrics.assign(material=HOSTILE)
        schemas.write(table, schemas.METRICS, root / f"{name}.parquet")
    run("tables", str(root / "tables.parquet"), *titles, *mark, "--out-dir", str(out))
    run("comparison", str(root / "tables.parquet"), *titles, *mark, "--out", str(out / "comparison.md"))
    pages = ("--out", str(out / "models.md"), "--table", str(out / "models.csv"))
    run("models", str(root / "models.parquet"), *titles, *mark, "--directed", "mlp", *pages)
    run("metrics", str(root / "models.parquet"), *mark, "--out", str(root / "reports" / "metrics.csv"))
    for stem in ("figure_4", "figure_5"):
        for suffix in ("png", "pdf"):
            (out / f"{stem}.{suffix}").write_bytes(b"")
    schemas.write(NINE.assign(run=HOSTILE), schemas.DATASET, root / "dataset.parquet")
    run("material_page", str(out), *mark, "--dataset", str(root / "dataset.parquet"))
    tied = {**TIED, "next_experiment": f"hold 20 N {HOSTILE}: for 15 minutes"}
    tied["mechanisms"] = [{"id": "creep"}, {"id": HOSTILE}]
    made_verdict(root / "reports" / "diagnosis" / HOSTILE, f"{HOSTILE}: ambiguous", tied)
    made_verdict(root / "reports" / "diagnosis" / "it's 100% #1?", "consistent", FINE)
    made_verdict(root / "reports" / "diagnosis" / "short", "raw/short: too short")
    words = [MATERIAL, "--runs", HOSTILE, "it's 100% #1?", "short", "--reports", str(root / "reports")]
    words += ["--strings", json.dumps({MATERIAL: [HOSTILE, "short", "no such run"]})]
    run("index", *words, *mark, "--out", str(root / "reports" / "index.html"))
    return root / "reports"


def pages_of(reports):
    return {path: path.read_text(encoding="utf-8") for path in sorted(reports.rglob("*.html"))}


def test_no_name_reaches_a_page_unescaped(reports):
    pages = pages_of(reports)
    names = {path.relative_to(reports).as_posix() for path in pages}
    parts = {f"pages/{name}.html" for name in (anchor("run", HOSTILE), "run-it-s-100-1", "run-short")}
    parts |= {f"{MATERIAL}/{name}.html" for name in ("index", "models", "comparison")}
    assert names == {"index.html"} | parts
    for path, text in pages.items():
        seen = Seen(text)
        assert HOSTILE not in text and not seen.handlers, path
        assert html.escape(HOSTILE) in text, path  # the mark of the configuration has it on each page
        assert seen.tags.count("script") == 1 and "x" not in seen.addresses, path


def test_the_model_to_take_comes_first_and_an_ambiguous_verdict_looks_like_no_error(reports):
    """A newcomer's first page began with "1 ambiguous, but worse on unseen strokes: do not adopt", in red."""
    text = (reports / "index.html").read_text(encoding="utf-8")
    assert text.index("At a glance") < text.index(">Materials<") < text.index("Verdicts: ") < text.index(">Runs<")
    assert "Ambiguous is no fault: several explanations fit" in text
    assert 'class="verdict ambiguous">' in text and 'class="verdict unknown">' not in text
    for warned in ("ambiguous, but worse on unseen strokes: do not adopt", "explained, but not settled"):
        assert tag(warned).startswith('<span class="verdict doubted">') and warned.partition(",")[2] in tag(warned)
    assert ".verdict.ambiguous, .verdict.doubted { background: #fdeecb }" in text


def test_the_page_of_a_material_shows_its_tables_and_figures_and_leads_nowhere_else(reports):
    """The quick reports of a new material have no other page; runs and the index may be there later, or never."""
    text = (reports / MATERIAL / "index.html").read_text(encoding="utf-8")
    seen = Seen(text)
    assert "Table I: forward" in text and "Table II: inverse" in text and seen.tags.count("img") == 2
    files = {address for address in seen.addresses if not address.startswith("#")}
    assert {f"../{MATERIAL}/{name}" for name in ("models.html", "comparison.html", "figure_5.png")} <= files
    assert all(address.startswith(f"../{MATERIAL}/") for address in files - {"../index.html"})


def test_every_link_is_relative_and_leads_to_something_wherever_the_folder_lies(reports, tmp_path):
    moved = tmp_path / "else where"
    shutil.copytree(reports, moved)
    for path, text in pages_of(moved).items():
        seen = Seen(text)
        assert len(seen.ids) == len(set(seen.ids)), path
        for address in seen.addresses:
            if address.startswith("#"):
                assert unquote(address[1:]) in seen.ids, (path, address)
            else:
                assert not re.match(r"[a-z]+:|/", address), (path, address)
                assert (path.parent / unquote(address)).is_file(), (path, address)


def test_the_page_of_a_material_begins_with_which_string_and_load_it_shows(reports):
    text = (reports / MATERIAL / "index.html").read_text(encoding="utf-8")
    begins = text[: text.index("Table I: forward")]
    sizes = "load 20 N, radius 0.4 mm, length 400 mm, torsion zone 150 mm, separator 8 mm, stiffness 15 N/mm"
    assert f"String a-01 (run {html.escape(HOSTILE)}): {sizes}, twist " in begins
    assert "turns; strokes 1 to 9." in begins


def test_the_table_of_strings_says_what_nobody_measured_and_ranges(tmp_path):
    """Each string has a row, and a rig without a separator has none."""
    string = recorded().run.string
    usual = usual_stiffness(string.radius_mm, string.length_mm)
    pair = NINE.assign(
        string="b", run="b-01", separator_mm=np.nan, torsion_zone_mm=np.nan, stiffness_n_per_mm=usual,
        load_n=np.where(NINE["stroke"] > 5, 40.0, 20.0),
    )  # fmt: skip
    turns = NINE["motor_turns"].where(NINE["motor_turns"] > NINE["motor_turns"].min(), 0.0002441)  # a coder's step
    more = NINE.assign(run="a-02", stroke=NINE["stroke"] + 9, radius_mm=0.5, length_mm=1234.0, motor_turns=turns)
    schemas.write(pd.concat([NINE, pair, more]), schemas.DATASET, tmp_path / "dataset.parquet")
    first, second = rows(by_stroke(tmp_path / "dataset.parquet"))
    assert (
        first[:4] == ["a-01", "a-01, a-02", "20", "0.4 to 0.5"]
        and first[4] == "400 to 1,234"
        and first[-1] == "1 to 18"
    )
    assert second[:8] == ["b", "b-01", "20 to 40", "0.4", "400", "none", "none", "not measured"]
    assert first[-2].startswith("0 to "), "not 0.0002441"
    words = sentence(second)
    assert words.startswith(
        "String b (run b-01): load 20 to 40 N, radius 0.4 mm, length 400 mm, stiffness not measured,"
    )
    assert words.endswith(f" to {NINE['motor_turns'].max():.3g} turns; strokes 1 to 9.")
    many = pd.concat([NINE.assign(string=f"s-{number}") for number in range(7)])
    schemas.write(many, schemas.DATASET, tmp_path / "many.parquet")
    text = recorded_strings(by_stroke(tmp_path / "many.parquet"), "nylon")
    assert "The strings of nylon" in text and text.count("<tr>") == 8 and "String s-1" not in text
    assert "has one answer for strings of the same sizes" in text and "fits: s-0, s-1, s-2, s-3 and 3 more. pre" in text
    other_sizes = recorded_strings(by_stroke(tmp_path / "dataset.parquet"), "nylon")
    assert "String b (" in other_sizes and "one answer" not in other_sizes, "no two strings of these are alike"
    two = pd.concat([NINE, NINE.assign(string="b"), NINE.assign(string="c", radius_mm=0.5)])
    schemas.write(two, schemas.DATASET, tmp_path / "alike.parquet")
    of_alike = recorded_strings(by_stroke(tmp_path / "alike.parquet"), "nylon")
    assert "are those of such fits: a-01 and b. predict" in of_alike
    one_string = recorded_strings(by_stroke(tmp_path / "dataset.parquet").loc[["a-01"]], "nylon")
    assert "one answer" not in one_string


def test_after_the_quick_command_of_a_material_no_link_of_its_pages_leads_to_a_page_that_was_not_made(
    reports, tmp_path
):
    """Nothing but the material's folder is made by that command. The one link out of it says which command makes it."""
    shutil.copytree(reports / MATERIAL, tmp_path / MATERIAL)
    words = (
        '<p><a href="../index.html">all reports</a> (made by the main job, snakemake --cores 2; it may be missing or '
    )
    words += "older than this page)</p>"
    for path, text in pages_of(tmp_path).items():
        addresses = [each for each in Seen(text).addresses if not each.startswith("#") and each != "../index.html"]
        assert addresses or path.name != "index.html"
        assert all((path.parent / unquote(address)).is_file() for address in addresses), path
        assert words in text, path


def test_a_page_is_the_same_whatever_lies_beside_it_and_says_which_job_makes_the_index(tmp_path, monkeypatch):
    """It led to the index only where that was there: one job on a cluster and one here made other bytes."""
    monkeypatch.chdir(tmp_path)
    before = web_page("# a\n", None)
    (tmp_path / "index.html").write_text("")
    assert web_page("# a\n", None) == before
    before_link, _, after_link = before.partition('<a href="../index.html">all reports</a>')
    assert before_link.endswith("<p>"), "the page opened with what the index is not"
    assert after_link.startswith(
        " (made by the main job, snakemake --cores 2; it may be missing or older than this page)"
    )


def test_the_index_opens_with_the_answer_and_folds_the_rest(reports):
    text = (reports / "index.html").read_text()
    opening, _, rest = text[text.index("<body>") :].partition(f'<details id="material-{MATERIAL}">')
    for words in ("At a glance", MATERIAL, "MLP model", "0.051 (1.04 ×", "ambiguous", "hold 20 N"):
        assert words in opening, words
    assert "consistent" in opening and "not decided" in opening and "<pre>" not in opening
    assert (
        opening.index("Small fit, not a result") < opening.index("At a glance") < opening.index('data-only="ambiguous"')
    )
    assert opening.count(" open>") == 2  # what a person came for may be folded, and is not
    open_parts, _, folded_part = opening.partition('<details id="rules">')
    assert open_parts.count("<details") == open_parts.count("<table") == 2, "nine paragraphs stood between the tables"
    assert all(words in folded_part and words not in open_parts for words in (RULE, LATER[:40], "is exported by"))
    assert "TABLE" not in opening and "Table II: inverse" in rest and "glossary" in rest
    assert "models.html" in rest and "models.md" not in rest and "comparison.html" in rest


def test_every_page_wears_the_mark_of_its_configuration(reports):
    for path, text in pages_of(reports).items():
        assert '<p class="mark small" role="note">Small fit, not a result' in text, path
        assert "abc1234" in text and text.count("Small fit, not a result") == 1, path


def test_pages_bring_their_own_script_and_style_and_ask_the_network_for_nothing(reports):
    for path, text in pages_of(reports).items():
        assert "http" not in text.replace("http-equiv", ""), path
        assert "table.sortable" in text, path
        tables = Seen(text).tags.count("table")
        assert tables == text.count('<table class="sortable') == text.count("<thead>"), path
        assert tables or path.name.startswith("run-"), path


def changed(models, to, **medians):
    """A models.csv with other medians on all points, by model and split, and no row of a model that is not named."""
    rows = pd.read_csv(models)
    first = rows[rows["model"] == "mlp"]
    parts = []
    for model, (title, within, later) in medians.items():
        mine = first.assign(model=model, title=title)
        mine["needs_motion"] = model == "diagnosed"
        parts.append(mine.assign(median=mine["split"].map({"within": within, "later": later}), ratio=2.0))
    pd.concat(parts).to_csv(to, index=False)


def test_the_model_of_a_material_is_the_one_that_the_command_exports(tmp_path, reports):
    (tmp_path / MATERIAL).mkdir()
    folder = tmp_path / MATERIAL / "models.csv"
    medians = {"polynomial": ("Polynomial", 0.02, 0.4), "spline": ("Spline", 0.103, 0.153)}
    changed(reports / MATERIAL / "models.csv", folder, diagnosed=("Simulator", 0.01, 0.889), **medians)
    cells = ["0.103 (2.00 ×)", "0.153 (2.00 ×)"]
    assert Models.read(folder).row() == ["Spline", *cells, *cells, "0.010 (2.00 ×)", "0.889 (2.00 ×)"]
    words = html.unescape(str(together(materials_table(tmp_path, [MATERIAL], str))))
    export, _ = uses(MATERIAL, "spline")
    assert export in words
    assert RULE in words and all(f"<li>{rule}</li>" in words for rule in RULES)
    assert f"The Spline is exported by <code>{export}" in words
    assert "The simulator is no model to take away: it needs the whole motion" in words
    less = "the Polynomial errs less forward: 0.020 mm against 0.103 mm. On later strokes it errs by 0.400 mm"
    less = f"<b>{MATERIAL}</b>: On strokes like the recorded ones {less} against 0.153 mm."
    assert f"{less} Take the Polynomial if only strokes" in words
    medians["polynomial"] = ("Polynomial", 0.1, 0.4)
    changed(reports / MATERIAL / "models.csv", folder, diagnosed=("Simulator", 0.01, 0.889), **medians)
    words = str(together(materials_table(tmp_path, [MATERIAL], str)))
    assert "errs less" not in words, "so little less is told as alike"


@pytest.mark.parametrize(
    ("later", "model"), [((0.153, 0.156), "Spline"), ((0.165, 0.151), "Spline"), ((0.168, 0.151), "Polynomial")]
)
def test_the_model_to_take_is_the_one_whose_numbers_on_the_page_justify_it(tmp_path, reports, later, model):
    """The spline was named whatever its errors were."""
    (tmp_path / MATERIAL).mkdir()
    spline, polynomial = ("Spline", 0.103, later[0]), ("Polynomial", 0.02, later[1])
    changed(reports / MATERIAL / "models.csv", tmp_path / MATERIAL / "models.csv", polynomial=polynomial, spline=spline)
    assert Models.read(tmp_path / MATERIAL / "models.csv").row()[0] == model
    words = str(together(materials_table(tmp_path, [MATERIAL], str)))
    export, _ = uses(MATERIAL, model.lower())
    assert export in words and words.count("<p>The model to take is found so:") == 1


def test_the_pages_say_why_the_error_on_later_strokes_of_a_model_is_not_that_of_a_diagnosis(reports):
    """One simulator had 0.153 mm on the last quarter in one table and 0.24 mm on the last 30 % in another."""
    share = f"last {100 * LAST:.0f} %"
    index, runs = (
        str(table) for table in (together(materials_table(reports, [MATERIAL], str)), runs_table(reports, {}, {}, str))
    )
    assert LATER in html.unescape(index) and "the last quarter" in LATER and share in LATER
    assert "may name other effects" in LATER and "other numbers" not in LATER, "7.3 mm stood beside 2.3 mm of one run"
    assert f"rms error on unseen strokes (the {share})" in runs
    assert share in NOTES and "the last quarter" in NOTES
    assert "diagnosed simulator, forward: mm (× floor)" in index, "a number without a unit"


def test_without_a_spline_or_a_simulator_the_index_says_what_it_shows_and_no_more(tmp_path, reports):
    assert Models.read(tmp_path / "none.csv").row() == [""] * 7
    assert Models.read(reports / MATERIAL / "models.csv").row()[:2] == ["MLP model", "0.051 (1.04 ×)"]
    words = str(together(materials_table(reports, [MATERIAL], str)))
    assert "processed/<material>" not in words and "no model to take away" not in words


def test_an_error_far_above_the_floor_is_coloured_and_what_the_page_is_stands_first(tmp_path):
    """7.271 mm (233 ×) stood in plain black, and "At a glance" before any sentence of what the page is."""
    head = "model,title,split,map,column,median,ratio"
    rows = ("spline,Spline model,later,forward,all,0.153,4.89", "diagnosed,Diagnosed,later,forward,all,7.271,233.0")
    (tmp_path / "nylon").mkdir()
    (tmp_path / "nylon" / "models.csv").write_text("\n".join([head, *rows]))
    shown = str(together(materials_table(tmp_path, ["nylon"], str)))
    assert '<td><span class="far">7.271 (233 ×)</span></td>' in shown and "<td>0.153 (4.89 ×)</td>" in shown
    opening = str(glance(tmp_path, ["nylon"], [], {}, str, str))
    assert opening.index("This page shows what was made of the recordings") < opening.index("At a glance")


def test_the_next_run_is_said_in_a_few_words():
    assert shortened("one stroke under twice the load: hold 0 turns for 2 s; more") == "one stroke under twice the load"
    assert shortened("Rest at 0.5 turns. Then go on.") == "Rest at 0.5 turns"
    assert shortened("word " * 60).endswith("word …") and len(shortened("word " * 60)) < 185


def test_a_next_run_is_readable_to_its_end(tmp_path):
    """A sentence ended in "and diagnose …", and the end of it stood in no place of the page."""
    whole = "Record the rig once more, with at least 8 strokes (30 N among the first), and diagnose all runs together"
    assert next_run({"next_experiment": whole}, tmp_path) == whole
    long = "word " * 60 + '"end"'
    assert f'<span title="{"word " * 60}&#34;end&#34;">word ' in next_run({"next_experiment": long}, tmp_path)


def test_what_was_left_out_stands_on_the_page_and_beneath_the_tables(tmp_path, reports):
    planned = to_json([LeftOut(HOSTILE, "nylon", "raw/x/run.yaml", HOSTILE, "is wrong", "mend it")])
    run("index", "--planned", planned, "--reports", str(tmp_path), "--out", str(tmp_path / "index.html"))
    text = (tmp_path / "index.html").read_text()
    assert text.index("At a glance") < text.index('<h2 id="left-out">Left out</h2>') < text.index("<details")
    assert html.escape(HOSTILE) in text and HOSTILE not in text
    metrics = str(reports.parent / "tables.parquet")
    run("tables", metrics, "--titles", "inn=INN", "--planned", planned, "--out-dir", str(tmp_path))
    assert '\nLeft out: run "\\<img src=x' in (tmp_path / "table_1.md").read_text()
    assert r'Left out: "\textless{}img' in (tmp_path / "table_1.tex").read_text()
    assert "Left out" not in (tmp_path / "table_1.csv").read_text()


def test_an_index_of_nothing_says_so(tmp_path):
    run("index", "--reports", str(tmp_path), "--out", str(tmp_path / "index.html"))
    assert "No run lies in raw/ yet." in (tmp_path / "index.html").read_text()


def test_the_end_of_a_run_names_what_it_was_asked_for_and_is_there(reports):
    tables = [str(reports / MATERIAL / f"table_{number}.md") for number in (1, 2)]
    end_text = summary(tables, reports, [MATERIAL], ["short"])
    assert "TABLE I: " in end_text and "TABLE II: " in end_text and end_text.endswith(f"\nTable II: {tables[1]}\n")
    for other in ("index.html", "comparison", "models.html", "figure_", "diagnosis"):
        assert other not in end_text, other
    more = [*tables, str(reports / "index.html"), str(reports / MATERIAL / "models.html")]
    more += [str(reports / "proof" / "proof.html"), str(reports / "diagnosis" / "short")]
    end_text = summary(more, reports, [MATERIAL], ["short"])
    assert f"the way to all of it: {reports / 'index.html'}" in end_text and "models.html" in end_text
    assert "raw/short: too short" in end_text and "proof" not in end_text.replace(str(reports), "")


def test_a_terminal_shows_the_tables_words_without_the_marks_of_markdown(tmp_path, reports):
    note = tmp_path / "processed" / MATERIAL / "zero_jumps.json"
    note.parent.mkdir(parents=True)
    write_jumps(note, {"a": [r"write `tare: run` in a_1\b [c]"]})
    metrics, folder = str(reports.parent / "tables.parquet"), tmp_path / MATERIAL
    run("tables", metrics, "--titles", "inn=INN [c]", "--jumps", str(note), "--out-dir", str(folder))
    assert r"write \`tare: run\` in a_1\\b \[c\]" in (folder / "table_1.md").read_text()
    assert r"| INN \[c\]" in (folder / "table_1.md").read_text()
    end_text = summary([str(folder / "table_1.md"), str(note)], tmp_path, [MATERIAL], [])
    assert "| INN [c]" in end_text and end_text.count(r"write `tare: run` in a_1\b [c]") == 1, (
        "once, not beneath each table"
    )


@pytest.mark.parametrize("jumps", [["The zero jumps"], []])
def test_the_model_to_take_is_doubted_beside_its_name_where_the_zero_jumps(tmp_path, jumps):
    """The warning stood 22 lines above the command that exports the model."""
    note = tmp_path / "processed" / MATERIAL / "zero_jumps.json"
    model = tmp_path / "processed" / MATERIAL / "spline" / "within-0.model"
    model.parent.mkdir(parents=True)
    model.touch()
    write_jumps(note, {"a": jumps})
    end_text = summary([str(note), str(model)], tmp_path / "reports", [MATERIAL], [])
    assert "\nto a controller: " in end_text
    assert ("\nBeware: the zero jumps between runs, as said above: " in end_text) == bool(jumps)


def test_a_jump_of_the_zero_is_said_on_the_page(tmp_path):
    runs, mark = of_runs(tmp_path, []), MadeBy("default.yaml", "abc1234", "default", "", ())
    text = page(tmp_path, of_materials(tmp_path, [], {}, runs), runs, {}, [], mark, {MATERIAL: ["The zero <jumps>."]})
    assert "The zero &lt;jumps&gt;." in text and 'id="jumps"' in text


def test_a_jump_of_the_zero_is_said_in_its_materials_row_and_above_the_runs(reports):
    """It stood below the runs, and the row of 11 times the floor had no word of its cause."""
    runs, mark = of_runs(reports, ["short"]), MadeBy("default.yaml", "abc1234", "default", "", ())
    materials = of_materials(reports, [MATERIAL, "steel"], {}, runs)
    text = page(reports, materials, runs, {}, [], mark, {MATERIAL: ["The zero <jumps>."]})
    row = text[: text.index('id="jumps"')].partition("<tbody>")[2]
    first, second = row.split("</tr>")[:2]
    assert MATERIAL in first and 'href="#jumps">its zero jumps between runs' in first and "zero" not in second
    assert text.index('id="materials"') < text.index(f"<b>{MATERIAL}</b>: The zero &lt;jumps") < text.index('id="runs"')
    assert text.count('id="jumps"') == 1
