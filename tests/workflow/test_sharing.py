"""The whole project, packed and unpacked in another checkout: Snakemake has nothing to do there."""

import subprocess
import sys

import pytest

pytestmark = pytest.mark.long
SMALL = ("--configfile", "pipeline/config/ci.yaml")


def test_a_finished_project_goes_to_another_checkout(finished, bare_project, tmp_path):
    origin, lab = finished[0], bare_project

    def program(folder, *words):
        done = subprocess.run([sys.executable, "-m", *words], cwd=folder, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return done.stdout

    archive = tmp_path / "all.zip"
    printed = program(origin.folder, "pipeline.pack", "--all", *SMALL, "--out", str(archive))
    assert "synthetic" in printed
    printed = program(lab.folder, "pipeline.pack.unpack", str(archive))
    assert "packed by other code" not in printed and " ".join(SMALL) in printed
    assert lab.rules_to_run() == {}
    assert lab.read("reports/synthetic/table_1.csv") == origin.read("reports/synthetic/table_1.csv")
    changed = lab.folder / "pipeline" / "models" / "mlp.py"
    changed.write_text(changed.read_text() + "\nCHANGED = True\n")
    rules = lab.rules_to_run()
    assert "train" in rules and "ingest" not in rules and "diagnose" not in rules
    assert "packed by other code" in program(lab.folder, "pipeline.pack.unpack", str(archive))
