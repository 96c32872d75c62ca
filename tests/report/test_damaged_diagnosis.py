"""A diagnosis.json that is damaged costs its own run on the index, is said there, and made again by the next start."""

import hashlib
import json
import os

import programs
import pytest
from made_damage import flips_and_cuts
from made_verdict import made_verdict

from pipeline.ground.errors import BadInput
from pipeline.ground.stored.checked_json import sum_file, write_checked
from pipeline.report.layout.verdict_file import damage
from pipeline.report.parts.diagnoses import content_of
from pipeline.workflow import known_files
from pipeline.workflow.dag import Plan, output_of, stored
from pipeline.workflow.known_files import KnownFiles

NAMED = {
    "id": "creep",
    "rms_mm": {"value": 0.41},
    "parameters": {"tau_s": {"value": 31.0}},
    "sentence": "It creeps – ü.",
}
CONTENT = {
    "run": "a-3", "verdict": "ambiguous", "mismatch": {"rms_mm": 0.44, "driver": "time under load"},
    "mechanisms": [NAMED], "alternatives": [["thermal"]], "next_experiment": "hold 20 N",
    "parameters": {"radius_mm": {"nominal": 0.55, "value": 0.561}},
    "fit": {"noise_floor_mm": 0.031, "heldout": {"split": "last", "nominal_mm": 1.92, "explained_mm": None}},
    "evidence": {"chosen_without_them": ["creep"]},
}  # fmt: skip
BROKEN = {
    "cut": b"{", "a list": b"[]", "a number": b'{"verdict": 3}', "deep": b"[" * 100_000, "no text": b"\xff\xfe",
    "nothing": b"", "another verdict": json.dumps(CONTENT | {"verdict": "ambiguo}s"}).encode(),
    "a size of text": json.dumps(CONTENT | {"mismatch": {"rms_mm": "0.44"}}).encode(),
    "an endless size": json.dumps(CONTENT | {"mismatch": {"rms_mm": float("nan")}}).encode(),
    "a long size": json.dumps(CONTENT | {"mismatch": {"rms_mm": 10**400}}).encode(),
    "no noise": json.dumps(CONTENT | {"fit": {"heldout": None}}).encode(),
}  # fmt: skip


@pytest.fixture
def folder(tmp_path):
    """A run's diagnosis as the program leaves it."""
    verdict_folder = made_verdict(tmp_path / "R" / "diagnosis" / "a-3", "a-3: ambiguous")
    write_checked(verdict_folder / "diagnosis.json", json.dumps(CONTENT, indent=1, ensure_ascii=False) + "\n")
    return verdict_folder


def test_its_check_sum_is_what_sha256sum_writes(folder):
    digest = hashlib.sha256((folder / "diagnosis.json").read_bytes()).hexdigest()
    assert (folder / "diagnosis.json.sha256").read_text() == f"{digest}  diagnosis.json\n"


def test_no_flipped_bit_of_a_diagnosis_is_read_silently(folder):
    path, refused = folder / "diagnosis.json", 0
    whole = path.read_bytes()
    assert content_of(folder) == CONTENT and damage(path) == ""
    for content in flips_and_cuts(whole):
        path.write_bytes(content)
        with pytest.raises(BadInput, match=r"damaged.*Mend: run snakemake: it is made again") as error:
            content_of(folder)
        refused += str(path) in str(error.value) and bool(damage(path))
    assert refused == 320


def test_who_edits_or_moves_one_without_its_check_sum_is_not_asked_for_one(folder):
    path = folder / "diagnosis.json"
    sum_file(path).unlink()
    path.write_text(json.dumps(CONTENT | {"next_experiment": None}))
    assert content_of(folder) == CONTENT | {"next_experiment": None} and damage(path) == ""


@pytest.mark.parametrize("kind", BROKEN)
def test_without_a_check_sum_its_form_is_looked_at(folder, kind):
    path = folder / "diagnosis.json"
    sum_file(path).unlink()
    path.write_bytes(BROKEN[kind])
    assert "is damaged" in damage(path)
    with pytest.raises(BadInput, match="is damaged"):
        content_of(folder)


@pytest.mark.parametrize("kind", ["cut", "a list", "a number", "deep"])
@pytest.mark.parametrize("summed", [True, False])
def test_the_index_goes_on_without_its_run_and_says_so(folder, kind, summed):
    reports = folder.parents[1]
    made_verdict(reports / "diagnosis" / "b-1", "b-1: ambiguous, but whole", CONTENT)
    (folder / "diagnosis.json").write_bytes(BROKEN[kind])
    if not summed:
        sum_file(folder / "diagnosis.json").unlink()
    words = ("--runs", "a-3", "b-1", "--strings", '{"nylon": ["a-3", "b-1"]}', "--reports", reports)
    done = programs.run("pipeline.report.index", *words, "--out", reports / "index.html")
    assert done.returncode == 0 and not done.stderr, done.stderr
    assert "left out: " in done.stdout and f"{folder / 'diagnosis.json'}: " in done.stdout
    page = (reports / "index.html").read_text()
    part = page.partition('id="left-out"')[2].partition("</table>")[0]
    assert '<td class="text">a-3</td><td class="text">nylon</td>' in part.replace("\n", "")
    assert "is damaged" in part and "Mend: run snakemake: it is made again." in part
    assert "b-1: ambiguous, but whole" in page and "a-3: ambiguous" not in page
    assert sorted(os.listdir(reports / "pages")) == ["run-b-1.html"]


def test_the_start_of_the_workflow_looks_for_it(folder, monkeypatch, tmp_path):
    monkeypatch.setattr(known_files, "SETTLED_S", -1.0)  # a test does not wait until a file is old
    name = "reports/diagnosis/a-3/diagnosis.json"
    assert name in set(stored({}, Plan(others=["a-3"]))) and output_of(name) == "reports/diagnosis/a-3"
    assert output_of("processed/a-3/samples.parquet") == "processed/a-3/samples.parquet"
    registry, path = KnownFiles(tmp_path / "known.json", {"diagnosis.json": damage}), folder / "diagnosis.json"
    assert registry.damaged([str(path), str(tmp_path / "diagnosis.json")]) == {} and str(path) in registry.facts
    right = sum_file(path).read_text()
    sum_file(path).write_text(right.replace(right[0], "x"))  # the index would refuse it
    assert list(registry.damaged([str(path)])) == [str(path)]
    sum_file(path).write_text(right)
    assert registry.damaged([str(path)]) == {}
    path.write_bytes(b"{")
    assert "its check sum" in registry.damaged([str(path)])[str(path)]
