"""Many runs: the index shows a line of each, and every run and material is a small page of its own."""

import json
import shutil
from dataclasses import replace

import programs
import pytest
from in_a_browser import clicked, needs_browser
from made_verdict import made_verdict
from test_diagnoses import FINE, TIED
from test_index import Seen

from pipeline.report.layout.made_by import MadeBy
from pipeline.report.parts.page_parts import FEW

MANY = 60
STRINGS = {f"m-{at}": [f"m-{at}-{run:02d}" for run in range(20)] for at in range(MANY // 20)}
RUNS = [run for runs in STRINGS.values() for run in runs]
WORDS = "What is said of a run at length. " * 20


def index(reports, strings, *more):
    runs = [run for own in strings.values() for run in own]
    done = programs.run(
        "pipeline.report.index", *strings, "--runs", *runs, "--strings", json.dumps(strings),
        "--reports", reports, "--out", reports / "index.html", *more,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr


@pytest.fixture(scope="module")
def reports(tmp_path_factory):
    folder = tmp_path_factory.mktemp("many") / "reports"
    for at, run in enumerate(RUNS):
        made_verdict(folder / "diagnosis" / run, f"{run}: said\n\n{WORDS}", FINE if at % 3 else TIED)
    index(folder, STRINGS)
    return folder


def test_the_index_of_many_runs_has_a_line_of_each_and_no_figure(reports):
    text = (reports / "index.html").read_text()
    seen = Seen(text)
    assert WORDS.strip() not in text and "img" not in seen.tags
    assert all(f'<a href="pages/run-{run}.html">{run}</a>' in text for run in RUNS)
    assert 'data-only="ambiguous">20 ' in text and 'data-only="consistent">40 ' in text
    assert '<td class="text">m-1</td>' in text


def test_every_part_is_a_page_that_leads_back_and_to_its_neighbours(reports):
    pages = sorted(path.name for path in (reports / "pages").iterdir())
    assert pages == sorted(f"run-{run}.html" for run in RUNS)
    for path in (reports / "pages").iterdir():
        for address in Seen(path.read_text()).addresses:
            assert address.startswith("#") or (path.parent / address).is_file(), (path, address)
    middle = (reports / "pages" / f"run-{RUNS[1]}.html").read_text()
    for to in ("../index.html", f"../pages/run-{RUNS[0]}.html", f"../pages/run-{RUNS[2]}.html"):
        assert f'href="{to}"' in middle, to
    assert WORDS.strip() in middle and f'src="../diagnosis/{RUNS[1]}/diagnosis.png"' in middle


def test_a_material_has_one_page_to_which_the_index_leads(reports, tmp_path):
    """pages/material-<x>.html and <x>/index.html showed much the same."""
    strings = {f"m-{at:02d}": [] for at in range(FEW + 1)}
    index(tmp_path, strings)
    text = (tmp_path / "index.html").read_text()
    assert 'href="m-07/index.html"' in text and "material-" not in text.partition("<body>")[2]
    assert not list((tmp_path / "pages").iterdir())


def test_few_runs_stand_on_the_index_itself_and_a_page_of_a_run_that_is_gone_goes(reports, tmp_path):
    place = tmp_path / "reports"
    shutil.copytree(reports, place)
    few = {"m-0": STRINGS["m-0"][:FEW]}
    index(place, few)
    text = (place / "index.html").read_text()
    assert text.count("<img") == FEW and 'href="#run-m-0-00"' in text and WORDS.strip() in text
    assert len(list((place / "pages").iterdir())) == FEW
    assert not [path.name for path in place.iterdir() if path.name.startswith(".")]


def test_an_index_that_fails_leaves_the_pages_of_before(reports, tmp_path, monkeypatch):
    def failing(folder):
        if folder.name == RUNS[-1]:
            raise KeyError(folder.name)
        return WORDS

    place = tmp_path / "reports"
    shutil.copytree(reports, place)
    monkeypatch.setattr("pipeline.report.parts.diagnoses.words_of", failing)
    before = {path.name: path.read_text() for path in (place / "pages").iterdir()}
    with pytest.raises(KeyError):
        index(place, STRINGS)
    assert {path.name: path.read_text() for path in (place / "pages").iterdir()} == before


def test_a_page_wears_the_mark_of_what_made_it_and_not_that_of_another_rig(tmp_path):
    """The set-up of the synthetic rig, and the INN's epochs, stood over the diagnosis of a person's own recording."""
    strings = {"nylon": ["nylon-01"], "synthetic": ["example-1"]}
    rig, small = "set-up small (5 strokes)", MadeBy("ci.yaml", "abc1234", "small", "INN model 2 seeds", ("epochs",))
    for run in ("nylon-01", "example-1"):
        made_verdict(tmp_path / "diagnosis" / run, f"{run}: said", FINE)
    whole = replace(small, rig=rig)
    own = MadeBy("ci.yaml", "abc1234", "own", "", ("setup",), rig)
    index(tmp_path, strings, "--made-by", whole.packed(), "--rig-mark", own.packed())
    pages = {path.stem: path.read_text() for path in (tmp_path / "pages").iterdir()}
    assert rig in (tmp_path / "index.html").read_text() and 'class="mark' not in pages["run-nylon-01"]
    assert rig in pages["run-example-1"] and "INN model" not in pages["run-example-1"]
    index(tmp_path, strings, "--rig-mark", MadeBy("default.yaml", "abc1234", "default").packed())
    assert 'class="mark' not in (tmp_path / "pages" / "run-example-1.html").read_text()


@needs_browser
def test_a_browser_shows_some_rows_sorts_all_of_them_and_shows_one_verdict_alone(reports, tmp_path):
    click = """<script>
      const rows = () => [...document.querySelectorAll("#runs tbody tr")].filter(row => !row.hidden);
      const said = [rows().length, document.querySelector("#runs .ways").textContent];
      document.querySelectorAll("#runs thead tr:last-child button")[0].click();
      document.querySelectorAll("#runs thead tr:last-child button")[0].click();
      said.push(rows()[0].cells[0].textContent);
      document.querySelector("a[data-only=ambiguous]").click();
      document.querySelector("#runs .ways button:nth-of-type(2)").click();
      said.push(rows().length, rows().every(row => row.cells[2].textContent === "ambiguous"));
      dispatchEvent(new Event("beforeprint"));
      said.push(rows().length);
      document.title = said.join("|");
    </script></body>"""
    page_title = clicked(reports / "index.html", click, tmp_path)
    assert page_title == "15|‹ before 1 to 15 of 60 next › show all|m-2-19|5|true|20"


@needs_browser
def test_a_click_enlarges_a_figure_and_another_ends_it(reports, tmp_path):
    click = """<script>
      const shown = () => document.querySelector("dialog").open, said = [shown()];
      document.querySelector("a.enlarge img").click();
      said.push(shown(), document.querySelector("dialog img").getAttribute("src"));
      said.push(location.href.endsWith("clicked.html"));
      document.querySelector("dialog img").click();
      said.push(shown());
      document.title = said.join("|");
    </script></body>"""
    figure = f"../diagnosis/{RUNS[0]}/diagnosis.png"
    assert clicked(reports / "pages" / f"run-{RUNS[0]}.html", click, tmp_path) == f"false|true|{figure}|true|false"


@needs_browser
def test_the_table_of_runs_fits_a_page_of_1200_pixels(tmp_path):
    """The run to make next was cut off at the edge."""
    strings = {"uhmwpe-braided": ["uhmwpe-braided-20261121-01-next"], "synthetic": ["synthetic-01"]}
    tied = {**TIED, "next_experiment": "hold 20 N and 30 N for 15 minutes each at 20 turns, then wind: all of it"}
    tied["mechanisms"] = [{"id": "friction_hysteresis"}, {"id": "lead_compliance"}]
    for (run,) in strings.values():
        made_verdict(tmp_path / "diagnosis" / run, f"{run}: said", tied)
    index(tmp_path, strings)
    script = """<script>
      const around = document.querySelector("#runs .scroll");
      document.title = [around.clientWidth > 1000, around.scrollWidth - around.clientWidth].join("|");
    </script></body>"""
    assert clicked(tmp_path / "index.html", script, tmp_path) == "true|0"
