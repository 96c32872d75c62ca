"""The plans of docs/diagnose.md lie within what their recordings hold, so that there is an error to report."""

import re
from pathlib import Path

import pandas as pd
import programs
import pytest

PAGE = (Path(__file__).parents[2] / "docs/diagnose.md").read_text()


@pytest.mark.long
def test_the_plan_for_the_rig_of_the_paper_is_inside_what_it_records(tmp_path):
    *_, plan = re.findall(r"printf '(time_s,.*?)' > plan.csv", PAGE)
    (tmp_path / "plan.csv").write_text(plan.replace("\\n", "\n"))
    assert programs.run("pipeline.rig.record", "paper", tmp_path / "example-1", "--seed", "1").returncode == 0
    words = "--motion", tmp_path / "plan.csv", "--out", tmp_path / "planned.csv"
    done = programs.run("pipeline.simulate", tmp_path / "example-1", *words)
    assert done.returncode == 0 and not done.stderr, done.stderr
    outside = pd.read_csv(tmp_path / "planned.csv")["outside"]
    assert outside.sum() == pytest.approx(0.0)
