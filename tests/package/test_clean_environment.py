"""`pip install .` as a person does it: a new environment that takes each package from a registry, none of ours."""

import json
import os
import shutil
import subprocess
import venv
from pathlib import Path

import pytest
from made_recording import recording
from tutorial_run import TUTORIAL, as_program, code_cells, unlike

ROOT = Path(__file__).resolve().parents[2]
PROJECT = ("pipeline", "pyproject.toml", "README.md", "LICENSE")  # what pip needs of the checkout
CLEAN = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "TWISTBENCH", "VIRTUAL"))}


def ended(*words: object, cwd: Path) -> subprocess.CompletedProcess[str]:
    """How a command ended that sees neither the checkout nor its environment."""
    return subprocess.run([str(word) for word in words], cwd=cwd, capture_output=True, text=True, env=CLEAN)


@pytest.fixture(scope="module")
def programs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of programs of a new environment, after one `pip install` of the project and its required packages."""
    work_folder = tmp_path_factory.mktemp("clean")
    source = work_folder / "source"
    source.mkdir()
    for name in PROJECT:
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, source / name, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy(ROOT / name, source)
    venv.create(work_folder / "env", with_pip=True)
    python = work_folder / "env" / "bin" / "python"
    reached = ended(
        python, "-m", "pip", "download", "-q", "--no-deps", "-d", work_folder, "typing_extensions", cwd=work_folder
    )
    if reached.returncode:
        assert not os.environ.get("CI"), f"CI has a registry: {reached.stderr}"
        pytest.skip(f"pip reaches no package registry: {reached.stderr.strip().splitlines()[-1]}")
    done = ended(python, "-m", "pip", "install", "-q", "--no-compile", source, cwd=work_folder)  # half the time
    assert done.returncode == 0, done.stderr
    return python.parent


@pytest.mark.long
def test_the_required_packages_are_enough_to_diagnose_a_run_folder(programs: Path, tmp_path: Path) -> None:
    recording(strokes=4).to_csv(tmp_path / "log.csv", index=False)
    sizes = ["--radius-mm", "0.4", "--length-mm", "400", "--torsion-zone-mm", "150", "--separator-mm", "8"]
    words = ("new-run", "made", "--material", "UHMWPE", *sizes, "--recording", "log.csv")
    done = ended(programs / "twistbench", *words, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    done = ended(programs / "twistbench", "diagnose", "raw/made", "--out", "out", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    verdict = json.loads((tmp_path / "out" / "made" / "diagnosis.json").read_text())
    assert verdict["run"] == "made" and verdict["verdict"]
    packages = ended(programs / "python", "-m", "pip", "list", "--format", "json", cwd=tmp_path)
    names = {package["name"] for package in json.loads(packages.stdout)}
    assert "twistbench" in names and not names & {"torch", "snakemake", "pytest"}
    assert not ended(programs / "python", "-m", "pip", "check", cwd=tmp_path).returncode


@pytest.mark.long
def test_the_tutorial_runs_with_the_required_packages(programs: Path, tmp_path: Path) -> None:
    shutil.copy(TUTORIAL.with_name("nylon_log.csv"), tmp_path)
    cells = code_cells()
    done = ended(programs / "python", "-c", as_program(cells), cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert not unlike(cells, done.stdout)
