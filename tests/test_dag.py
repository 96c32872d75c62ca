import json
from pathlib import Path
from types import SimpleNamespace

import pytest
import yaml
from made_recording import content

from pipeline.dag import fits, make_plan, recorded_files
from pipeline.errors import BadInput
from pipeline.fingerprint import fingerprint, reachable

ROOT = Path(__file__).parent.parent


def test_plan_sorts_runs_by_material(make_run, tmp_path):
    nylon = {**content("x")["string"], "material": "nylon"}
    make_run("a-01")
    make_run("a-02")
    make_run("n-01", string=nylon)
    (make_run("bad-01") / "run.yaml").write_text("a: [")
    make_run("mass-01", actuator="moving_mass", string=None)
    (make_run("nameless-01") / "run.yaml").unlink()
    cut_off = make_run("cut-01")
    (cut_off / "recording.parquet").rename(cut_off / "recording.frames")
    (make_run("cut-02") / "recording.parquet").rename(tmp_path / "raw" / "cut-02" / "recording.lines")
    plan = make_plan(tmp_path / "raw", ["synthetic-01"])
    assert plan.materials == {"synthetic": ["synthetic-01"], "UHMWPE": ["a-01", "a-02"], "nylon": ["n-01"]}
    assert plan.others == ["bad-01", "mass-01", "nameless-01"] and plan.unfinished == ["cut-01", "cut-02"]


def test_a_real_recording_is_never_made_again(make_run, tmp_path):
    folder = make_run("synthetic-01")
    (folder / "capture.json").write_text(json.dumps({"hello": {"device": "lab rig 3"}}))
    with pytest.raises(BadInput, match="real recording under a name of the synthetic rig"):
        make_plan(tmp_path / "raw", ["synthetic-01"])


def test_recorded_files_are_what_is_there(make_run, tmp_path):
    make_run("a-01", suffix=".csv")
    files = recorded_files(tmp_path / "raw", "a-01", ["synthetic-01"])
    assert [name.rsplit("/", 1)[1] for name in files] == ["run.yaml", "recording.csv"]


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
    trained = {path.name for path in reachable("pipeline.train", "pipeline.models.traditional")}
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
    assert "models/diagnosed_run.py" in files["diagnosed"] and "models/spline.py" not in files["diagnosed"]


def test_fingerprints_change_with_the_source(tmp_path, monkeypatch):
    import pipeline.fingerprint as module

    (tmp_path / "pipeline").mkdir()
    (tmp_path / "pipeline" / "__init__.py").touch()
    (tmp_path / "pipeline" / "a.py").write_text("from pipeline import b\n")
    (tmp_path / "pipeline" / "b.py").write_text("x = 1\n")
    monkeypatch.setattr(module, "ROOT", tmp_path)

    def now():
        module._imports.cache_clear()
        return fingerprint("pipeline.a")

    before = now()
    (tmp_path / "pipeline" / "b.py").write_text("x = 2\n")
    assert now() != before
    (tmp_path / "pipeline" / "c.py").write_text("x = 2\n")
    (tmp_path / "pipeline" / "b.py").write_text("x = 1\n")
    assert now() == before
    with pytest.raises(ModuleNotFoundError):
        fingerprint("pipeline.nothing")


def test_mappings_are_runs_without_a_name():
    from pipeline.run_yaml import parse_run

    for path in sorted((Path(__file__).parent.parent / "pipeline" / "mappings").glob("*.yaml")):
        mapping = yaml.safe_load(path.read_text())
        parse_run({"run": "a", **mapping}, Path("raw/a/run.yaml"))
