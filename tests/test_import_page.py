"""docs/import.md: its example is imported as it stands, and its tables name every key that a mapping may hold."""

import hashlib
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from made_recording import recording

from pipeline.ingest import read_samples
from pipeline.run_yaml import Channel, Run, String
from pipeline.text_file import TextFile

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "docs" / "import.md").read_text(encoding="utf-8")


def part(name):
    """The block of the page that a name stands above."""
    return re.search(rf"`{re.escape(name)}`\n\n```\w*\n(.*?)```", PAGE, re.DOTALL)[1]


def test_the_pages_example_is_imported_and_says_what_comes_next(tmp_path):
    made = recording()
    numbers = np.column_stack([made["time_s"] * 1e3, made["motor_turns"] * 360, 12 - made["displacement_mm"]])
    rows = [";".join(f"{value:.6f}" for value in row).replace(".", ",") for row in numbers]
    opening = part("log.csv").splitlines()[:3]
    (tmp_path / "log.csv").write_text("\n".join([*opening, *rows]) + "\n", encoding="cp1252")
    (tmp_path / "map.yaml").write_text(part("map.yaml"), encoding="utf-8")
    command, following = re.search(r"```sh\n(.*)\n(.*)\n```", PAGE).groups()
    words = [sys.executable, *command.split()[1:]]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, env={"PYTHONPATH": str(ROOT)})
    assert done.returncode == 0, done.stderr
    diagnose = "python -m pipeline.diagnose raw/nylon-20261121-01 --out reports/mine"
    alone = f"or ask only what the simulator leaves out: {diagnose}"
    assert done.stdout.splitlines()[-1] == f"make its reports with: {following}, {alone}"
    folder = tmp_path / "raw" / "nylon-20261121-01"
    _, samples = read_samples(folder)
    for name in ("time_s", "motor_turns", "displacement_mm"):
        assert samples[name].to_numpy() == pytest.approx(made[name].to_numpy(), abs=1e-5), name
    first, second, *_ = (folder / "run.yaml").read_text().splitlines()
    digest = hashlib.sha256((tmp_path / "log.csv").read_bytes()).hexdigest()
    assert first == f"# imported from 'log.csv', sha256 {digest}"
    assert second.startswith("# through the mapping 'map.yaml', sha256 ")


@pytest.mark.parametrize("section", [Run, String, TextFile, Channel])
def test_the_page_names_every_key(section):
    for key in set(section.model_fields) - {"run", "mended"}:
        assert f"`{key}`" in PAGE, key
