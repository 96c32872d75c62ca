"""Every rule says what its jobs need, in one file."""

import re
from pathlib import Path
from types import SimpleNamespace

import yaml

from pipeline.workflow.needs import BESIDE_MB, FURTHER, MEASURED, Needs

ROOT = Path(__file__).parents[2]
RULES = {
    name: body
    for path in (ROOT / "pipeline" / "rules").glob("*.smk")
    for name, body in re.findall(r"^rule (\w+):\n((?:[ \n].*\n?)*)", path.read_text(encoding="utf-8"), re.MULTILINE)
}


MEANT = yaml.safe_load(MEASURED.read_text(encoding="utf-8"))


MATERIALS = {"nylon": ["nylon-01"], "polyester": [f"polyester-{number}" for number in range(200)]}
PEAK = re.compile(r"([\d,]+) MB")


def of(material):
    return SimpleNamespace(material=material)


def test_every_rule_takes_its_own_needs_from_the_file_and_none_stands_there_for_no_rule():
    assert len(RULES) > 30
    for name, body in RULES.items():
        assert f'    resources:\n        **NEEDS["{name}"],\n' in body, name
    assert set(MEANT) == set(RULES)
    assert all(
        {"mem_mb", "runtime"} <= set(needs) <= {"mem_mb", "runtime", *FURTHER.values()} for needs in MEANT.values()
    )


def test_no_rule_is_given_less_than_what_was_measured():
    measured = dict(re.findall(r"^(\w+): \{.*\}  # (.*)", MEASURED.read_text(encoding="utf-8"), re.MULTILINE))
    assert len(measured) >= len(MEANT) - 1
    for rule, notes in measured.items():
        assert PEAK.search(notes), rule
        for note in notes.split("; "):
            runs = int(many[1]) if (many := re.search(r"^(\d+) runs", note)) else 1
            meant_mb = MEANT[rule]["mem_mb"] + (runs - 1) * MEANT[rule].get("more_mb", 0)
            assert all(meant_mb >= 1.3 * float(peak.replace(",", "")) for peak in PEAK.findall(note)), (rule, note)


def test_a_job_that_is_tried_again_is_given_more():
    needs = Needs(MATERIALS)["diagnose"]
    assert needs["runtime"](of("nylon"), attempt=2) == 2 * MEANT["diagnose"]["runtime"]
    assert needs["mem_mb"](of("nylon"), attempt=1) == MEANT["diagnose"]["mem_mb"] + BESIDE_MB
    assert needs["mem_mb"](of("nylon"), attempt=2) == 2 * (MEANT["diagnose"]["mem_mb"] + BESIDE_MB)


def test_a_fit_of_many_runs_is_given_more_and_a_diagnosis_of_one_of_them_is_not():
    train, diagnose = Needs(MATERIALS)["train"], Needs(MATERIALS)["diagnose"]
    assert train["runtime"](of("nylon"), attempt=1) == MEANT["train"]["runtime"]
    assert train["runtime"](of("polyester"), attempt=1) >= 200 * 2  # min: a run's part of an inn takes more than one
    assert train["mem_mb"](of("polyester"), attempt=1) >= 200 * 42  # MB: what a spline takes for each
    assert diagnose["runtime"](SimpleNamespace(run="polyester-1"), attempt=1) == MEANT["diagnose"]["runtime"]
