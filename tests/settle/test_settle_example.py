"""The example that shows the loop unattended runs as its first lines say."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from pipeline.rig.recorded_at_once import simulate
from pipeline.rig.setup import read_setup

ROOT = Path(__file__).resolve().parents[2]


def test_the_page_says_how_to_conceal_one_effect_alone(tmp_path):
    """`small` conceals four effects, and a newcomer took it for one of the table's two."""
    text = (ROOT / "docs" / "settle.md").read_text()
    block = next(part for part in text.split("```") if part.startswith("\nsed "))
    commands, words = block.strip().splitlines()[:2], "pipeline/rig/setups/small.yaml"
    script = "\n".join(commands).replace(words, str(ROOT / words))
    subprocess.run(["bash", "-ec", script], cwd=tmp_path, check=True)
    path = tmp_path / "concealed.yaml"
    assert read_setup(str(path)).effects == {"friction_hysteresis": {"turns_per_n": 0.01, "reach_turns": 0.2}}
    other = re.search(r"`effects: (\{backlash: .*?\})`", text)
    assert other, "the other effect of the table"
    path.write_text(path.read_text().partition("effects:")[0] + f"effects: {other[1]}\n")
    simulate(read_setup(str(path)), 1)
    assert len(read_setup("small").effects) == 4 and "four effects at once" in text


@pytest.mark.long
def test_the_example_goes_from_nothing_to_a_right_and_firm_verdict_with_the_page_open(tmp_path):
    command = [sys.executable, ROOT / "examples" / "settle_unattended.py", tmp_path]
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=900)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "http://127.0.0.1:" in done.stdout and "friction_hysteresis; settled rightly" in done.stdout
    out, run = tmp_path / "reports" / "settle" / "poor-1", tmp_path / "raw" / "poor-1"
    assert done.stdout.startswith(f"first recording: {run}\nsteps and verdicts: {out}\n")
    assert "Next:" not in done.stdout, "what comes next this program does itself"
    assert "stays until this program ends" in done.stdout and f"runs: {run}, {run}-s1" in done.stdout
    assert f"drawn before it is made: {out}/step-1/proposed.png" in done.stdout
    assert f"the last verdict: {out}/step-" in done.stdout and "RUN_OF_RECORDING" not in done.stdout
    assert "stroke 1 of 1, about 0:0" in done.stdout, "how long the run with a hold still takes"
    assert "RUN_OF_RECORDING" in (tmp_path / "rig.log").read_text()
    outcome = json.loads((tmp_path / "reports" / "settle" / "poor-1" / "settled.json").read_text())
    assert outcome["spent"]["runs"] >= 1 and (tmp_path / "raw" / "poor-1" / "capture.json").is_file()
