"""The tree is clean, formatted and typed, and says nothing that belongs elsewhere."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


def tool(*command):
    done = subprocess.run([sys.executable, "-m", *command], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize(
    "command",
    [
        ("ruff", "check", "."),
        ("ruff", "format", "--check", "."),
        ("snakefmt", "--check", "Snakefile", "pipeline/rules"),
        pytest.param(("mypy",), marks=pytest.mark.long),
    ],
    ids=lambda command: " ".join(command),
)
def test_tools_are_content(command):
    tool(*command)


def test_snakemake_lint_finds_nothing_but_that_there_is_no_conda():
    command = [sys.executable, "-m", "snakemake", "--lint", "json", "--snakefile", str(ROOT / "Snakefile")]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    titles = set(re.findall(r'"title": "([^"]+)"', done.stdout))
    assert titles <= {"Specify a conda environment or container for each rule."}, titles


def tracked():
    if shutil.which("git") is None or not (ROOT / ".git").exists():
        pytest.skip("not a git checkout: nothing says which files are tracked")
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True)
    return [ROOT / name for name in listed.stdout.splitlines()]


def test_no_generated_file_is_tracked():
    for path in tracked():
        top = path.relative_to(ROOT).parts
        if top[0] in ("raw", "processed", "reports"):
            assert top[1:] == ("README.md",) or top[:2] == ("reports", "blind"), path
        shown = top[:2] == ("docs", "pictures")  # what the README and the site show of the tool
        assert path.suffix not in (".pyc", ".pdf", ".model") and (shown or path.suffix != ".png"), path


def test_readme_is_short_and_its_commands_are_the_two():
    text = (ROOT / "README.md").read_text()
    assert len(text.splitlines()) < 100
    assert "python3 env/run.py snakemake --cores 2" in text and "python3 env/run.py pytest" in text
    for program in re.findall(r"python -m (pipeline[.\w]*)", text):
        path = ROOT.joinpath(*program.split("."))
        assert path.with_suffix(".py").is_file() or (path / "__main__.py").is_file(), program


def test_readme_has_short_lines_and_each_link_leads_to_a_file():
    text = (ROOT / "README.md").read_text()
    long = [line for line in text.splitlines() if len(line) > 120 and not line.lstrip("<").startswith(("img", "src"))]
    assert not long
    links = re.findall(r"\]\(([^)#:]+)\)", text)
    assert len(links) > 10 and not [link for link in links if not (ROOT / link).is_file()]


def test_the_lock_pins_everything_that_the_project_names():
    def names(file):
        lines = [line.split("#")[0].strip() for line in (ROOT / "env" / file).read_text().splitlines()]
        return {re.split("==", line)[0].lower().replace("_", "-"): line for line in lines if line}

    locked = names("requirements.lock")
    assert set(names("requirements.in")) <= set(locked)
    assert all("==" in line for line in locked.values())
