"""Which configuration made a page: what is a result, what is a small fit, and that every form of a table says so."""

import copy
import csv
import json
from pathlib import Path

import pytest
import yaml
from snakemake.utils import update_config

from pipeline.report.layout.made_by import MadeBy, called, made_by, sentence, unpacked, warning
from pipeline.report.layout.plain_markdown import note, plain
from pipeline.report.layout.sidecar import describe
from pipeline.report.web.page import document, paragraph
from pipeline.rig.setup_words import other_rig

CONFIG = Path(__file__).parents[2] / "pipeline" / "config"
DEFAULT = yaml.safe_load((CONFIG / "default.yaml").read_text())
CI = yaml.safe_load((CONFIG / "ci.yaml").read_text())
MODELS = ["models", "keep_lossy"]


def merged(*parts):
    """The default configuration with others on top, as Snakemake merges them."""
    config = copy.deepcopy(DEFAULT)
    for part in parts:
        update_config(config, part)
    return config


def test_the_default_configuration_is_a_result():
    mark = made_by(DEFAULT, DEFAULT, "default.yaml", MODELS)
    assert mark.kind == "default" and warning(mark) == "" and mark.changed == ()
    statement = sentence(mark)
    assert f"Made by the default configuration, default.yaml (checksum of its settings {mark.digest})." in statement
    assert len(mark.digest) == 7
    assert "INN model 5 seeds of 24 epochs" in statement and "MLP model 5 seeds of 240 epochs" in statement
    assert not note(mark).startswith("**")


@pytest.mark.parametrize("parts", [MODELS, ["campaign"], ["proof"], ["leak"]])
def test_what_ci_makes_is_a_small_fit(parts):
    mark = made_by(merged(CI), DEFAULT, "ci.yaml", parts)
    assert mark.kind == "small" and "small fit: not a result" in warning(mark)
    assert sentence(mark).startswith("Small fit, not a result: made by ci.yaml") and note(mark).startswith("**Small")


@pytest.mark.parametrize(
    ("change", "kind"),
    [
        ({"models": {"mlp": {"seeds": {"later": 4}}}}, "small"),
        ({"models": {"inn": {"settings": {"epochs": 23}}}}, "small"),
        ({"models": {"inn": {"settings": {"epochs": 48}}}}, "own"),
        ({"models": {"inn": {"settings": {"width": 8}}}}, "own"),
        ({"keep_lossy": True}, "own"),
        ({"campaign": {"strings": 3}, "proof": {"seed": 1}, "recordings": "/some/where"}, "default"),
    ],
)
def test_a_change_counts_where_it_matters(change, kind):
    mark = made_by(merged(change), DEFAULT, "mine.yaml", MODELS)
    assert mark.kind == kind
    assert ("not the default configuration, made by mine.yaml" in warning(mark)) == (kind == "own")


@pytest.mark.parametrize("parts", [["models"], ["synthetic"], ["models", "synthetic", "leak"]])
def test_no_mark_calls_the_projects_own_configuration_the_readers(parts):
    """A page of ci.yaml began with "Your own configuration"."""
    mark = made_by(merged(CI), DEFAULT, "ci.yaml", parts)
    assert "made by ci.yaml" in sentence(mark) and "made by ci.yaml" in warning(mark)
    assert "own configuration" not in sentence(mark).lower() + warning(mark)


def test_the_hash_of_a_configuration_stands_at_the_foot_of_a_page_alone():
    mark = made_by(merged(CI), DEFAULT, "ci.yaml", MODELS)
    assert mark.digest in sentence(mark) and mark.digest not in sentence(mark, versioned=False) + warning(mark)
    page = document("a", paragraph("body"), mark)
    assert page.count(mark.digest) == 1 and page.index(mark.digest) > page.index("body")
    assert "checksum" not in document("a", paragraph("body"), MadeBy()) + document("a", paragraph("body"))


def test_an_own_configuration_says_what_differs():
    mark = made_by(merged({"models": {"inn": {"settings": {"epochs": 48}}}}), DEFAULT, "mine.yaml", MODELS)
    assert "it differs from the default in models.inn.settings.epochs (48 instead of 24)." in sentence(mark)
    assert sentence(mark).startswith("Not the default configuration: made by mine.yaml")


def test_a_small_fit_says_that_it_records_another_rig_where_it_does():
    rig = other_rig(CI["synthetic"], DEFAULT["synthetic"])
    strokes = "5 strokes: 4 from 0 up to 20 turns under 20 N, then 1 from 0 up to 16 turns under 30 N"
    assert rig == f"set-up small ({strokes})"
    mark = made_by(merged(CI), DEFAULT, "ci.yaml", [*MODELS, "synthetic"], rig)
    whose = "Only material synthetic is of another synthetic rig than by default"
    assert f"{whose}: {rig}. Fits: INN model 2 seeds" in sentence(mark)
    assert "rig" not in sentence(made_by(merged(CI), DEFAULT, "ci.yaml", MODELS, rig))  # another material has its own
    assert other_rig(DEFAULT["synthetic"], DEFAULT["synthetic"]) == ""
    alone = made_by(merged(CI), DEFAULT, "ci.yaml", ["synthetic"], rig)
    statement = f"Not the default configuration: made by ci.yaml. {whose}: {rig}."
    assert sentence(alone, versioned=False) == statement, "a key of the configuration is no sentence"
    lossy = made_by(merged({**CI, "keep_lossy": True}), DEFAULT, "ci.yaml", ["synthetic", "keep_lossy"], rig)
    assert "; it differs from the default in keep_lossy. Only material synthetic" in sentence(lossy, versioned=False)
    assert other_rig({"a": {"setup": "no such.yaml"}}, DEFAULT["synthetic"]) == "set-up no such.yaml"


def test_the_hash_is_of_the_configuration_and_not_of_where_files_lie():
    digests = [
        made_by(merged(change), DEFAULT, "x", MODELS).digest
        for change in (
            {},
            {"recordings": "/a"},
            {"campaign": {"seed": 5}},
            {"models": {"inn": {"title": "x"}}},
        )
    ]
    assert digests[0] == digests[1] and len(set(digests)) == 3


def test_a_mark_survives_the_command_line():
    mark = made_by(merged(CI), DEFAULT, "it's $(touch PWNED) <b>.yaml", MODELS)
    assert unpacked(mark.packed()) == mark
    for text in ("nothing", "{}", '{"changed": 3}', '{"changed": [], "else": 1}', "[]"):
        with pytest.raises(ValueError):
            unpacked(text)


def test_a_configuration_is_called_by_its_files_and_options():
    assert called([], False) == "default.yaml"
    assert called(["/a/ci.yaml", "/b/mine.yaml"], True) == "ci.yaml + mine.yaml with --config"


def test_markdown_shows_any_text_as_it_is():
    from markdown_it import MarkdownIt

    hostile = "<img src=x onerror=alert(1)> [a](javascript:b) | *c* `d` \\e ![f](g)\nh"
    shown = MarkdownIt().enable("table").render(plain(hostile))
    assert "<img" not in shown and "<a" not in shown and "<em>" not in shown and "<code>" not in shown
    assert "&lt;img src=x onerror=alert(1)&gt; [a](javascript:b) | *c* `d` \\e" in shown


def test_the_file_beside_a_table_is_csv_on_the_web(tmp_path):
    table = tmp_path / "some.csv"
    table.write_text("a (mm),b\n1,x\n")
    mark = MadeBy("ci.yaml", "abc1234", "small", "INN model 2 seeds of 3 epochs", ())
    describe(table, "some table", [("a (mm)", "number", "size of a in mm"), ("b", "string", "a name")], mark)
    content = json.loads((tmp_path / "some.csv-metadata.json").read_text())
    assert content["@context"][0] == "http://www.w3.org/ns/csvw" and content["url"] == "some.csv"
    with open(table, newline="") as file:
        assert [column["titles"] for column in content["tableSchema"]["columns"]] == next(csv.reader(file))
    assert content["schema:creativeWorkStatus"] == "small fit: not a result"
    assert "INN model 2 seeds of 3 epochs" in content["dc:provenance"] and content["schema:version"] == "abc1234"
