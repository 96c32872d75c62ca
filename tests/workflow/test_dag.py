import copy
import json
import os
import re
from pathlib import Path
from types import SimpleNamespace

import pytest
import yaml
from made_recording import content
from snakemake.exceptions import WorkflowError
from snakemake.utils import update_config, validate

from pipeline.ground.code.fingerprint import fingerprint, reachable
from pipeline.ground.configuration import USUAL, complete
from pipeline.ground.errors import BadInput
from pipeline.ground.words.left_out import LeftOut
from pipeline.workflow.dag import fits, make_plan, recorded_files, table_order

ROOT = Path(__file__).parents[2]


def test_plan_sorts_runs_by_material(make_run, tmp_path):
    nylon = {**content("x")["string"], "material": "nylon"}
    make_run("a-01")
    make_run("a-02")
    make_run("n-01", string=nylon)
    make_run("mass-01", actuator="moving_mass", string=None, rig={"mass_kg": 90.0})
    cut_off = make_run("cut-01")
    (cut_off / "recording.parquet").rename(cut_off / "recording.frames")
    (make_run("cut-02") / "recording.parquet").rename(tmp_path / "raw" / "cut-02" / "recording.lines")
    plan = make_plan(tmp_path / "raw", ["synthetic-01"])
    assert plan.materials == {"synthetic": ["synthetic-01"], "UHMWPE": ["a-01", "a-02"], "nylon": ["n-01"]}
    assert plan.others == ["mass-01"] and plan.refused == plan.misnamed == []
    assert [left_out.run for left_out in plan.unfinished] == ["cut-01", "cut-02"] and "--recover" in plan.unfinished[
        0
    ].why
    assert {left_out.material for left_out in plan.unfinished} == {"UHMWPE"}, "a job of nylon ended with them"


HOSTILE = [
    "$(touch PWNED)",
    "nylon-1 (copy)",
    "it's",
    "a{b}c",
    "two\nlines",
    "-rf",
    "ä",
    "x" * 200,
    "campaign",
    "A-1",
    "n" + "-0" * 20,
]


def test_a_folder_that_can_be_no_run_is_left_out_with_the_mend(make_run, tmp_path):
    make_run("a-01")
    for name in HOSTILE:
        make_run(name)
    (tmp_path / "raw" / "-empty").mkdir()
    (tmp_path / "raw" / ".hidden").mkdir()
    (tmp_path / "raw" / "loop").symlink_to("loop")
    plan = make_plan(tmp_path / "raw", [])
    assert plan.runs == ["a-01"] and sorted(left_out.run for left_out in plan.misnamed) == sorted(HOSTILE)
    for left_out in plan.misnamed:
        assert "rename the folder" in left_out.why and left_out.why.isprintable() and left_out.field == "its name"


@pytest.mark.parametrize("name", ["diagnosis", "r" * 20, "x" * 101])
def test_a_synthetic_run_has_a_name_as_any_run_has(tmp_path, name):
    with pytest.raises(BadInput, match="configuration: synthetic"):
        make_plan(tmp_path / "raw", [name])


BAD = {
    "deep": "a: " + "[" * 3000 + "]" * 3000,
    "unknown": "run: bad-01\nstring: {material: nylon, raduis_mm: 1}\n",
    "twice": "run: bad-01\nrun: bad-01\n",
    "tag": "run: !!python/object:os.system bad-01\n",
    "binary": "\udcff\udcfe",
    "empty": "",
    **{taken: f"run: bad-01\nstring: {{material: {taken}, radius_mm: 0.4, length_mm: 400, stiffness_n_per_mm: 15}}\n"
       "rig: {torsion_zone_mm: 150, separator_mm: 8}\n"
       for taken in ("diagnosis", "real", "proof", "campaign", "blind", "logs", "site", "synthetic")},
}  # fmt: skip


@pytest.mark.parametrize("kind", BAD)
def test_a_bad_run_yaml_costs_its_own_run(make_run, tmp_path, kind):
    make_run("good-01")
    (make_run("bad-01") / "run.yaml").write_bytes(BAD[kind].encode("utf-8", "surrogateescape"))
    plan = make_plan(tmp_path / "raw", [])
    assert plan.materials == {"UHMWPE": ["good-01"]} and not plan.others
    (left_out,) = plan.refused
    assert left_out.run == "bad-01" and "bad-01/run.yaml" in left_out.file and left_out.mend
    assert left_out.material == ("nylon" if kind == "unknown" else kind if "radius_mm" in BAD[kind] else "")


def test_a_recording_that_nobody_described_is_named_with_the_command_that_describes_it(tmp_path):
    """The mend was `new_run` without the run's name, and did not say what to do with what is no run."""
    raw = tmp_path / "raw"
    for name in ("old-log", "photographs"):
        (raw / name).mkdir(parents=True)
    (raw / "old-log" / "recording.csv").write_text("time_s\n")
    (left_out,) = make_plan(raw, []).left_out
    mend = f"write it with python -m pipeline.new_run old-log --out {raw} and the string's sizes, or move the folder"
    assert mend in left_out.why and "if it is no run" in left_out.why


@pytest.mark.parametrize("named", [r"a\0b", r"a\u202Eb", "<b>", "x" * 5000, r"a\nb"])
def test_no_word_that_names_no_material_reaches_the_pages(make_run, tmp_path, named):
    text = BAD["unknown"].replace("nylon", f'"{named}"')
    assert named in text
    (make_run("bad-01") / "run.yaml").write_text(text)
    (left_out,) = make_plan(tmp_path / "raw", []).refused
    assert left_out.material == "" and all(sign.isprintable() for sign in left_out.why)


@pytest.mark.parametrize("material", ["nylon", '"nylon"', "'nylon' # soft", "nylon}"])
def test_a_run_yaml_that_cannot_be_read_still_tells_its_material(make_run, tmp_path, material):
    opening = "{" if material.endswith("}") else "\n  "
    text = f"run: bad-01\n# material: silk\nradius: .nan\nstring: {opening}material: {material}\n"
    (make_run("bad-01") / "run.yaml").write_text(text)
    (left_out,) = make_plan(tmp_path / "raw", []).refused
    assert left_out.material == "nylon" and ".nan is no finite number" in left_out.why


def test_a_run_that_is_refused_leaves_the_plan_and_with_it_a_material_of_its_own(make_run, tmp_path):
    silk = {**content("x")["string"], "material": "silk"}
    for name, changes in (("a-01", {}), ("a-02", {}), ("s-01", {"string": silk})):
        make_run(name, **changes)
    make_run("mass-01", actuator="moving_mass", string=None, rig={"mass_kg": 90.0})
    plan = make_plan(tmp_path / "raw", [])
    plan.leave_out({run: LeftOut(run, "", "f", "g", "h", "i") for run in ("a-02", "s-01", "mass-01")})
    assert plan.materials == {"UHMWPE": ["a-01"]} and plan.others == []
    assert [(left_out.run, left_out.material) for left_out in plan.refused] == [
        ("a-02", "UHMWPE"),
        ("s-01", "silk"),
        ("mass-01", ""),
    ]


def test_a_run_yaml_that_is_none_costs_its_own_run(make_run, tmp_path):
    make_run("good-01")
    (make_run("nameless-01") / "run.yaml").unlink()
    for name, make in (("folder-01", Path.mkdir), ("pipe-01", os.mkfifo)):
        file = make_run(name) / "run.yaml"
        file.unlink()
        make(file)
    plan = make_plan(tmp_path / "raw", [])
    assert plan.runs == ["good-01"]
    assert [left_out.run for left_out in plan.refused] == ["folder-01", "nameless-01", "pipe-01"]


def test_every_name_that_a_rule_hands_to_a_shell_is_quoted():
    rules = sorted((ROOT / "pipeline" / "rules").glob("*.smk"))
    shells = [text for path in rules for text in re.findall(r"    shell:\n((?: {8}.*\n)+)", path.read_text())]
    placeholders = [name for text in shells for name in re.findall(r"(?<!{)\{([^{}]+)\}", text)]
    assert len(shells) > 30 and len(placeholders) > 100
    assert [name for name in placeholders if not name.endswith(":q")] == []


def test_a_real_recording_is_never_made_again(make_run, tmp_path):
    folder = make_run("synthetic-01")
    (folder / "capture.json").write_text(json.dumps({"hello": {"device": "lab rig 3"}}))
    with pytest.raises(BadInput, match="real recording under a name of the synthetic rig"):
        make_plan(tmp_path / "raw", ["synthetic-01"])


def test_recorded_files_are_what_is_there(make_run, tmp_path):
    make_run("a-01", suffix=".csv")
    files = recorded_files(tmp_path / "raw", "a-01", ["synthetic-01"])
    assert [name.rsplit("/", 1)[1] for name in files] == ["run.yaml", "recording.csv"]


def test_the_tables_order_is_the_default_ones_whatever_a_configuration_begins_with():
    folder = ROOT / "pipeline" / "config"
    default, small = (yaml.safe_load((folder / name).read_text())["models"] for name in ("default.yaml", "ci.yaml"))
    merged = list(dict.fromkeys([*small, *default]))
    assert merged != list(default)
    assert table_order(merged, default) == table_order(default, default) == list(default)
    assert table_order(["mine", *merged], default) == [*list(default)[:-1], "mine", "traditional"]


def test_fits():
    models = {"inn": {"seeds": {"within": 2, "later": 1}}, "mlp": {"seeds": {"within": 1, "later": 1}}}
    assert len(list(fits(models, "m"))) == 5
    assert list(fits(models, "m", only="inn")) == [
        "processed/m/inn/within-0.predictions.parquet",
        "processed/m/inn/within-1.predictions.parquet",
    ]


def test_fingerprints_follow_imports_and_nothing_else():
    names = {path.name for path in reachable("pipeline.report.tables")}
    assert {"tables.py", "paper.py", "schemas.py", "files.py", "errors.py"} <= names
    assert not names & {"strokes.py", "dataset.py", "inn.py"}
    trained = {path.name for path in reachable("pipeline.stages.train", "pipeline.models.traditional")}
    assert "traditional.py" in trained and not trained & {"inn.py", "mlp.py", "strokes.py"}
    rig = {path.name for path in reachable("pipeline.rig.*")}
    assert {"__main__.py", "device.py", "creep.py", "paper.yaml", "kinematics.py"} <= rig  # found by name at run time


def test_a_models_fingerprint_covers_what_it_finds_by_name_at_run_time():
    text = (ROOT / "pipeline" / "rules" / "train.smk").read_text()
    rule = {"fingerprint": reachable}
    exec(text.partition("rule train:")[0], rule)
    files = {
        model: {f"{path.parent.name}/{path.name}" for path in rule["code_of_model"](SimpleNamespace(model=model))}
        for model in ("diagnosed", "spline")
    }
    by_name = {"mechanisms/creep.py", "mechanisms/backlash.py", "systems/twisted_string.py"}
    assert by_name < files["diagnosed"] and not by_name & files["spline"]
    assert "diagnosed/diagnosed_run.py" in files["diagnosed"] and "models/spline.py" not in files["diagnosed"]


def test_fingerprints_change_with_the_source(tmp_path, monkeypatch):
    import pipeline.ground.code.fingerprint as module

    (tmp_path / "pipeline").mkdir()
    (tmp_path / "pipeline" / "__init__.py").touch()
    (tmp_path / "pipeline" / "a.py").write_text("from . import b\n")
    (tmp_path / "pipeline" / "b.py").write_text("x = 1\n")
    monkeypatch.setattr(module, "HOUSE", tmp_path / "pipeline")

    def now():
        module._imports.cache_clear(), module._source.cache_clear()
        return fingerprint("pipeline.a")

    before = now()
    assert {path.name for path in reachable("pipeline.a")} == {"__init__.py", "a.py", "b.py"}
    (tmp_path / "pipeline" / "b.py").write_text("x = 2\n")
    assert now() != before
    (tmp_path / "pipeline" / "c.py").write_text("x = 2\n")
    (tmp_path / "pipeline" / "b.py").write_text("x = 1\n")
    assert now() == before
    with pytest.raises(ModuleNotFoundError):
        fingerprint("pipeline.nothing")


def test_mappings_are_runs_without_a_name():
    from pipeline.run.description import parse_run

    for path in sorted((Path(__file__).parents[2] / "pipeline" / "mappings").glob("*.yaml")):
        mapping = yaml.safe_load(path.read_text())
        parse_run({"run": "a", **mapping}, Path("raw/a/run.yaml"))


@pytest.mark.parametrize("above", [(), ("ci.yaml",)], ids=["default", "ci"])
def test_the_shipped_configurations_obey_the_schema(above):
    folder, config = ROOT / "pipeline" / "config", {}
    for name in ("default.yaml", *above):
        update_config(config, yaml.safe_load((folder / name).read_text(encoding="utf-8")))
    validate(config, str(folder / "schema.yaml"))
    config["models"]["inn"]["seeds"]["within"] = "many"
    with pytest.raises(WorkflowError, match="many"):
        validate(config, str(folder / "schema.yaml"))


def test_one_line_of_configuration_is_enough_for_a_model():
    """The line of CONTRIBUTING.md; an entry had to have four keys."""
    (line,) = re.findall(r"`(shifted: \{title: .*?\})`", (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8"))
    folder = ROOT / "pipeline" / "config"
    config = yaml.safe_load((folder / "default.yaml").read_text(encoding="utf-8"))
    before = copy.deepcopy(config)
    update_config(config, {"models": yaml.safe_load(line), "campaign": {"models": {"shifted": {}}}})
    validate(config, str(folder / "schema.yaml"))
    complete(config["models"])
    assert config["models"].pop("shifted") == {"title": "Shifted model", **USUAL}
    assert config["models"] == before["models"], "what an entry says stays"
    config["models"]["shifted"] = {"title": "Shifted model"}
    complete(config["models"])
    config["models"]["shifted"]["seeds"]["later"] = 7
    assert USUAL["seeds"]["later"] == 1, "entries share nothing"
    assert [Path(path).name for path in fits(config["models"], "nylon", only="shifted")] == [
        "within-0.predictions.parquet"
    ]
