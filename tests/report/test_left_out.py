"""What was left out: from the stage that refuses a run to the tables, the page and the end of the main job."""

import argparse
import json
import shlex
import sys
from pathlib import Path

import pandas as pd
import programs
import pytest
from made_recording import recording

from pipeline.ground.errors import BadInput
from pipeline.ground.input.words_by_file import by_file
from pipeline.ground.stored import schemas
from pipeline.ground.words import jump_notes
from pipeline.ground.words.left_out import LeftOut, from_json, noted, read_left_out, to_json, write_left_out
from pipeline.report import left_out
from pipeline.report.end_of_job import stale_reports
from pipeline.workflow.dag import Plan, stored
from pipeline.workflow.known_files import KnownFiles

ONE = LeftOut("a-01", "nylon", "raw/a-01/run.yaml", "<b>", "is 'x' & \n\x1b[31m", "write it")


def asked(*words):
    parser = argparse.ArgumentParser()
    left_out.arguments(parser)
    return parser.parse_args(words)


def test_it_is_told_beneath_tables_and_on_the_page_with_nothing_unescaped(tmp_path):
    write_left_out(tmp_path / "left_out.json", [ONE])
    arguments = asked(
        "--left-out", str(tmp_path / "left_out.json"), "--planned", to_json([LeftOut("b-02", *["x"] * 5)])
    )
    assert [entry.run for entry in left_out.told(arguments)] == ["a-01", "b-02"]
    runs = left_out.told(arguments)
    assert left_out.beneath("tex", runs) == ["Left out: a-01, b-02."]
    assert left_out.beneath("md", runs)[0].startswith("Left out: run a-01: raw/a-01/run.yaml: \\<b>: is 'x' & ")
    page = left_out.section(left_out.told(arguments))
    assert "&lt;b&gt;" in page and "<b>" not in page and "\x1b" not in page and "Mend: write it." in page
    nothing = asked()
    assert left_out.told(nothing) == left_out.beneath("md", []) == left_out.beneath("tex", []) == []


def test_a_folder_with_a_blank_in_its_name_is_told_in_quotes():
    run = LeftOut("my run", "nylon", "raw/my run", "run", "is no name of a run", "rename it")
    assert left_out.beneath("md", [run]) == [
        'Left out: run "my run": raw/my run: run: is no name of a run. Mend: rename it.'
    ]
    assert left_out.beneath("tex", [run, ONE]) == ['Left out: "my run", a-01.']


def test_a_refusal_is_noted_handed_on_and_told(tmp_path):
    samples, strokes = tmp_path / "a-01" / "samples.parquet", tmp_path / "a-01" / "strokes.parquet"
    with noted(tmp_path, [samples, strokes], note=True):
        raise BadInput("raw/a-01/recording.csv", "time_s", "runs backwards", "record it again")
    for table in (samples, strokes):
        with pytest.raises(schemas.Refused, match="time_s: runs backwards"):
            schemas.read(table)
    assert [entry.run for entry in left_out.told(asked("--left-out", str(strokes)))] == ["a-01"]
    with pytest.raises(BadInput), noted(tmp_path, [tmp_path / "b.parquet"], note=False):
        raise BadInput("f", "g", "h", "i")
    samples.write_bytes(samples.read_bytes()[:-1])
    with pytest.raises(schemas.Damaged), noted(tmp_path, [strokes], note=True):  # to be made again, not left out
        schemas.read(samples)
    assert not (tmp_path / "b.parquet").exists()


@pytest.mark.parametrize(
    "content", [b"[{", b"\xff[]", b"{}", b"[[]]", b'[{"run": 5}]', b"[" * 9000, b"", to_json([ONE]).encode()]
)
def test_a_damaged_list_of_what_was_left_out_is_found_at_the_start_and_refused_by_a_page(tmp_path, content):
    path = tmp_path / "left_out.json"
    write_left_out(path, [ONE])
    registry = KnownFiles(tmp_path / "known.json")
    assert "processed/nylon/left_out.json" in set(stored({}, Plan(materials={"nylon": ["a-01"]})))
    assert registry.damaged([str(path)]) == {} and left_out.told(asked("--left-out", str(path))) == [ONE]
    path.write_bytes(content)
    assert list(registry.damaged([str(path)])) == [str(path)]
    with pytest.raises(BadInput, match=r"content: is damaged, .*Mend: delete it and run snake"):
        left_out.told(asked("--left-out", str(path)))


@pytest.mark.parametrize("content", [b"[", b"\xff[]", b"{}", b"[5]", b"[" * 9000, b"", b'["The zero jumps."]'])
def test_a_damaged_note_of_jumps_is_found_at_the_start_and_refused(tmp_path, content):
    path = tmp_path / jump_notes.NAME
    jump_notes.write_jumps(path, {"a": ["The zero jumps."]})
    registry = KnownFiles(tmp_path / "known.json")
    assert "processed/nylon/zero_jumps.json" in set(stored({}, Plan(materials={"nylon": ["a-01"]})))
    assert registry.damaged([str(path)]) == {} and jump_notes.read_jumps([path]) == ["The zero jumps."]
    path.write_bytes(content)
    assert list(registry.damaged([str(path)])) == [str(path)]
    with pytest.raises(BadInput, match=r"content: is damaged, .*Mend: delete it and run snake"):
        jump_notes.read_jumps([path])


def test_the_last_rule_fails_for_a_refused_run_and_writes_nothing(tmp_path):
    command = ["pipeline.report.left_out", "--out", tmp_path / "out.json"]
    done = programs.run(*command, "--planned", to_json([ONE]))
    assert done.returncode == 2 and "raw/a-01/run.yaml" in done.stderr and not (tmp_path / "out.json").exists()
    assert programs.run(*command).returncode == 0 and json.loads((tmp_path / "out.json").read_text()) == []


def test_a_material_goes_on_without_a_run_of_no_use(make_run, tmp_path):
    """The real programs: one run is refused by ingest, and the dataset is made of the other."""
    processed = tmp_path / "processed"
    folders = [make_run("a-01", recording(4)), make_run("a-02", recording(4).assign(displacement_mm=1.0))]

    def program(name, *words):
        return programs.run(f"pipeline.{name}", *words)

    assert program("stages.ingest", folders[1], "--out", processed / "a-02/samples.parquet").returncode == 2
    assert not processed.exists()
    for folder in folders:
        samples = processed / folder.name / "samples.parquet"
        tables = ("--out", samples, "--out-strokes", samples.with_name("strokes.parquet"))
        assert program("stages.ingest", folder, *tables, "--note-refusals").returncode == 0
    out = ["--processed", processed, "--out", processed / "d.parquet", "--out-left-out", processed / "left.json"]
    done = program("stages.dataset", *folders, *out)
    assert done.returncode == 0, done.stderr
    assert set(schemas.read(processed / "d.parquet", schemas.DATASET)["run"]) == {"a-01"}
    (entry,) = read_left_out(processed / "left.json")
    assert entry.run == "a-02" and entry.field == "displacement_mm" and "a-02: left out" not in done.stdout
    done = program("stages.dataset", folders[1], *out)
    assert done.returncode == 2 and "never changes" in done.stderr


def test_reports_go_with_their_run_and_nothing_else_goes(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    keep = ["raw/a-01/run.yaml", "reports/blind/x.md", "reports/nylon/my_notes.txt", "reports/index.html"]
    gone = ["reports/diagnosis/a-01/verdict.txt", "reports/nylon/table_1.csv", "reports/silk/table_1.csv"]
    for name in [*keep, *gone, "reports/diagnosis/b-01/verdict.txt"]:
        Path(name).parent.mkdir(parents=True, exist_ok=True)
        Path(name).write_text("")
    before = [
        "reports/diagnosis/a-01",
        "reports/diagnosis/b-01",
        *gone[1:],
        "raw/a-01",
        "reports/../raw/a-01",
        "reports",
    ]
    assert stale_reports.remove_stale(before, ["reports/diagnosis/b-01"]) == ["reports/diagnosis/a-01", *gone[1:]]
    assert all(Path(name).is_file() for name in keep) and not any(Path(name).exists() for name in gone)
    assert Path("reports/diagnosis/b-01/verdict.txt").is_file() and not Path("reports/silk").exists()


def test_after_a_failure_the_last_pages_are_of_what_was_made(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    missing = {"processed/silk/metrics.parquet", "reports/diagnosis/b-01", "reports/index.html"}
    omissions = stale_reports.unmade(["nylon", "silk"], ["a-01", "b-01"], missing)
    assert [entry.run for entry in omissions] == ["all of silk", "b-01"]
    index = (
        "exec python -m pipeline.report.index nylon silk --runs a-01 b-01 --left-out processed/nylon/left_out.json"
        " processed/silk/left_out.json --planned '[]' --out reports/index.html > log 2>&1"
    )
    words = stale_reports.without(index, omissions, ["table_1.csv"])
    assert words[3:6] == ["nylon", "--runs", "a-01"] and "processed/silk/left_out.json" not in words
    assert from_json(words[words.index("--planned") + 1]) == omissions and words[-2:] == ["--out", "reports/index.html"]
    named, _, out = index.removeprefix("exec python -m pipeline.report.index ").partition(" --out ")
    stored = by_file(shlex.split(named), Path("words"))
    stored_index = f"exec python -m pipeline.report.index {stored} --out {out}"
    assert stale_reports.without(stored_index, omissions, ["table_1.csv"]) == words
    Path("reports/silk").mkdir(parents=True)
    Path("reports/silk/table_1.csv").write_text("")
    # its old state, said on the page
    assert stale_reports.without(index, omissions, ["table_1.csv"])[3:5] == ["nylon", "silk"]
    metrics = "exec python -m pipeline.report.metrics processed/nylon/m.parquet processed/silk/m.parquet --out x > log"
    assert stale_reports.without(metrics, omissions, ["table_1.csv"])[3:] == ["processed/nylon/m.parquet", "--out", "x"]


def test_metrics_are_written_by_the_command_of_its_rule(tmp_path):
    row = dict.fromkeys(schemas.METRICS.names, "x") | {"seed": 0, "value": 1.0}
    for name in ("nylon", "silk"):
        (tmp_path / name).mkdir()
        table = pd.DataFrame([row | {"material": name}]).astype({"seed": "int32"})
        schemas.write(table, schemas.METRICS, tmp_path / name / "metrics.parquet")
    table, out = tmp_path / "nylon" / "metrics.parquet", tmp_path / "x.csv"
    command = f"exec {sys.executable} -m pipeline.report.metrics {table} --out {out}"
    assert stale_reports.rewrite([command + " > log 2>&1"], [], [], str(Path(__file__).parents[2])) == []
    assert (tmp_path / "x.csv").read_text().splitlines()[1].startswith("nylon,")
    (wrong,) = stale_reports.rewrite([command.replace("nylon", "wool")], [], [], str(Path(__file__).parents[2]))
    assert "No such file" in wrong
