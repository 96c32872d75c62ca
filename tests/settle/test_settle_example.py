"""The example that shows the loop unattended runs as its first lines say."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.long
def test_the_example_goes_from_nothing_to_a_right_and_firm_verdict_with_the_page_open(tmp_path):
    command = [sys.executable, ROOT / "examples" / "settle_unattended.py", tmp_path]
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=900)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "http://127.0.0.1:" in done.stdout and "friction_hysteresis; settled rightly" in done.stdout
    found = json.loads((tmp_path / "reports" / "settle" / "poor-1" / "settled.json").read_text())
    assert found["spent"]["runs"] >= 1 and (tmp_path / "raw" / "poor-1" / "capture.json").is_file()
