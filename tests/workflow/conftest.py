"""A copy of the project to run the whole workflow in, on the small rig, and to change its code."""

import shutil
import subprocess
import sys
from pathlib import Path

import once
import pytest
import yaml

ROOT = Path(__file__).parents[2]


SMALL = ("--configfile", "pipeline/config/ci.yaml")


class Project:
    """A project folder of its own that shares this environment."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def command(self, *words: str) -> list[str]:
        return [sys.executable, str(self.folder / "env" / "run.py"), "snakemake", "--cores", "2", *words, *SMALL]

    def snakemake(self, *words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(self.command(*words), cwd=self.folder, capture_output=True, text=True, timeout=900)

    def rules_to_run(self, *words: str) -> dict[str, int]:
        """How many jobs of each rule a dry run would start."""
        done = self.snakemake("--dry-run", *words)
        assert done.returncode == 0, done.stdout + done.stderr
        return self.rules_of(done.stdout + done.stderr)

    @staticmethod
    def rules_of(printed: str) -> dict[str, int]:
        """How many jobs of each rule a main job planned, by the table that it printed before it began."""
        if "Nothing to be done" in printed:
            return {}
        table = printed.split("\njob ", 1)[1].split("\n\n", 1)[0].splitlines()[2:]
        counts = {line.split()[0]: int(line.split()[1]) for line in table if len(line.split()) == 2}
        return {name: count for name, count in counts.items() if name not in ("total", "all", "tables")}

    def read(self, name: str) -> str:
        return (self.folder / name).read_text(encoding="utf-8")


def copy_project(folder: Path) -> Project:
    """Code, what is compiled of it, rules, configuration; the environment is linked, not made again."""
    ignored = shutil.ignore_patterns(".venv*", "*.tmp.*")
    for name in ("pipeline", "env"):
        shutil.copytree(ROOT / name, folder / name, ignore=ignored)
    shutil.copy(ROOT / "Snakefile", folder)
    ours = Path(sys.prefix) if (Path(sys.prefix) / "stamp").exists() else ROOT / "env" / ".venv"
    if ours.exists():
        (folder / "env" / ".venv").symlink_to(ours)
    return Project(folder)


@pytest.fixture(scope="module")
def bare_project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    """A project of which nothing is made."""
    return copy_project(tmp_path_factory.mktemp("bare"))


def main_job_of(project: Project) -> tuple[Path, str]:
    """Run the main job of a project; its folder, and what it printed."""
    done = project.snakemake()
    assert done.returncode == 0, done.stdout + done.stderr
    return project.folder, done.stdout


@pytest.fixture(scope="session")
def finished(tmp_path_factory: pytest.TempPathFactory) -> tuple[Project, str]:
    """A project whose main job has run, and what it printed: one for all processes. Tests leave it finished."""

    def make() -> tuple[Path, str]:
        return main_job_of(copy_project(tmp_path_factory.mktemp("finished")))

    folder, printed = once.made_once(once.place(tmp_path_factory), "finished", make)
    return Project(folder), printed


def fewer_models(project: Project) -> None:
    """Keep two models, one fit each: what some tests look at is the same for any."""
    for name in ("default", "ci"):
        path = project.folder / "pipeline" / "config" / f"{name}.yaml"
        config = yaml.safe_load(path.read_text())
        config["models"] = {
            model: model_settings
            for model, model_settings in config["models"].items()
            if model in ("inn", "traditional")
        }
        for model_settings in config["models"].values():
            model_settings["seeds"] = {"within": 1, "later": 1}
        path.write_text(yaml.safe_dump(config, sort_keys=False))


@pytest.fixture(scope="session")
def few_finished(finished: tuple[Project, str], tmp_path_factory: pytest.TempPathFactory) -> Project:
    """The finished project with two models, whose fits are there: one for all processes. Tests leave it finished."""

    def make() -> tuple[Path, str]:
        folder = tmp_path_factory.mktemp("few") / "project"
        shutil.copytree(finished[0].folder, folder, symlinks=True)
        fewer_models(Project(folder))
        return main_job_of(Project(folder))

    return Project(once.made_once(once.place(tmp_path_factory), "few", make)[0])


@pytest.fixture
def few(few_finished: Project, tmp_path: Path) -> Project:
    """A copy of the project of two models, times and all, to change at will."""
    folder = tmp_path / "few"
    shutil.copytree(few_finished.folder, folder, symlinks=True)
    return Project(folder)


@pytest.fixture
def project(finished: tuple[Project, str], tmp_path: Path) -> Project:
    """A copy of the finished project, times and all, to change at will."""
    folder = tmp_path / "project"
    shutil.copytree(finished[0].folder, folder, symlinks=True)
    return Project(folder)
