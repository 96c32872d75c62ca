"""Every rule says what its jobs need, in one file."""

import re
from pathlib import Path

import yaml

from pipeline.workflow.needs import MEASURED, Needs

ROOT = Path(__file__).parents[2]
RULES = {
    name: body
    for path in (ROOT / "pipeline" / "rules").glob("*.smk")
    for name, body in re.findall(r"^rule (\w+):\n((?:[ \n].*\n?)*)", path.read_text(encoding="utf-8"), re.MULTILINE)
}


MEANT = yaml.safe_load(MEASURED.read_text(encoding="utf-8"))


def test_every_rule_takes_its_own_needs_from_the_file_and_none_stands_there_for_no_rule():
    assert len(RULES) > 30
    for name, body in RULES.items():
        assert f'    resources:\n        **NEEDS["{name}"],\n' in body, name
    assert set(MEANT) == set(RULES)
    assert all(set(needs) == {"mem_mb", "runtime"} for needs in MEANT.values())


def test_a_job_that_is_tried_again_is_given_more():
    needs = Needs()["diagnose"]
    assert needs["mem_mb"](None, attempt=2) == 2 * needs["mem_mb"](None, attempt=1) == 2 * MEANT["diagnose"]["mem_mb"]
