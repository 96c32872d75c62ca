"""The wheel in an environment of its own: the command is there, works on a person's files and speaks its own name."""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import venv
from collections.abc import Callable
from pathlib import Path

import pandas as pd
import pytest
import yaml
from made_recording import content, recording
from tutorial_run import TUTORIAL, as_program, code_cells, unlike

from pipeline import __version__
from pipeline.__main__ import PROGRAMS
from pipeline.models.parts.saved import write_json

ROOT = Path(__file__).resolve().parents[2]
Command = Callable[..., subprocess.CompletedProcess[str]]
SCREEN = 38  # lines, of 80 columns
EVERY_HELP = """
import sys
from contextlib import suppress
from twistbench.__main__ import main

for number, name in enumerate(names := sys.argv[1:]):
    print(end="\\f" if number else "")
    sys.argv = ["twistbench", name, "--help"]
    with suppress(SystemExit):
        main()
"""  # in one process, which imports once
CLEAN = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "PIP_", "TWISTBENCH"))}


def ended(*words: object, cwd: Path) -> subprocess.CompletedProcess[str]:
    """How a command ended that sees nothing of the checkout."""
    environment = {**CLEAN, "COLUMNS": "80", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    return subprocess.run([str(word) for word in words], cwd=cwd, capture_output=True, text=True, env=environment)


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An environment with the wheel, which finds the packages of others in the project's; nothing is downloaded."""
    work_folder = tmp_path_factory.mktemp("package")
    source = work_folder / "source"
    shutil.copytree(ROOT / "pipeline", source / "pipeline", ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, source)
    offline = ("--no-deps", "--no-index", "-q")
    pip = (sys.executable, "-m", "pip")
    done = ended(*pip, "wheel", "--no-build-isolation", *offline, "-w", work_folder, ".", cwd=source)
    assert done.returncode == 0, done.stdout + done.stderr
    (wheel,) = work_folder.glob("*.whl")
    venv.create(work_folder / "env", symlinks=True)
    python = work_folder / "env" / "bin" / "python"
    done = ended(*pip, "--python", python, "install", *offline, wheel, cwd=work_folder)
    assert done.returncode == 0, done.stdout + done.stderr
    packages = ended(
        python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))", cwd=work_folder
    ).stdout.strip()
    Path(packages, "others.pth").write_text(sysconfig.get_path("purelib") + "\n")
    return work_folder / "env"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where a person works: a recording of his own and a mapping for it."""
    user_folder = tmp_path_factory.mktemp("work")
    recording(strokes=4).rename(columns={"motor_turns": "theta"}).to_csv(user_folder / "log.csv", index=False)
    named = {"motor_turns": {"column": "theta", "unit": "turns"}}
    mapping = {key: value for key, value in content("x", channels=named).items() if key != "run"}
    (user_folder / "map.yaml").write_text(yaml.safe_dump(mapping))
    return user_folder


@pytest.fixture(scope="module")
def twistbench(place: Path, folder: Path) -> Command:
    """The installed command, run where a person works."""
    return lambda *words: ended(place / "bin" / "twistbench", *words, cwd=folder)


def good(done: subprocess.CompletedProcess[str]) -> str:
    """What a command said that ended well, and never in the words of the checkout."""
    assert done.returncode == 0, done.stdout + done.stderr
    words = r"\bpipeline\b|snakemake|main job"
    assert not re.search(words, done.stdout + done.stderr), done.stdout + done.stderr
    return done.stdout


@pytest.mark.long
def test_the_environment_has_twistbench_and_no_module_called_pipeline(place: Path, folder: Path) -> None:
    code = "import importlib.util as u, twistbench; print(twistbench.__version__, u.find_spec('pipeline'))"
    done = ended(place / "bin" / "python", "-c", code, cwd=folder)
    assert done.stdout.split() == [__version__, "None"], done.stderr
    code = "import twistbench as tb; print(*sorted({getattr(tb, name).__module__ for name in tb.__all__}))"
    homes = good(ended(place / "bin" / "python", "-c", code, cwd=folder)).split()
    assert homes and all(home.startswith("twistbench.") for home in homes)


@pytest.mark.long
def test_the_command_lists_its_programs_and_each_fits_a_screen(place: Path, folder: Path, twistbench: Command) -> None:
    printed = good(twistbench("--help"))
    assert all(re.search(rf"^  {name} +\w", printed, re.M) for name in PROGRAMS) and len(printed.splitlines()) <= SCREEN
    assert good(twistbench("--version")) == f"twistbench {__version__}\n"
    done = ended(place / "bin" / "python", "-c", EVERY_HELP, *PROGRAMS, cwd=folder)
    for name, shown in zip(PROGRAMS, good(done).split("\f"), strict=True):
        assert shown.startswith(f"usage: twistbench {name} ") and len(shown.splitlines()) <= SCREEN, shown
        assert max(map(len, shown.splitlines())) <= 80
    wrong = twistbench("diagnos")
    assert wrong.returncode == 2 and "use one of new-run" in wrong.stderr


@pytest.mark.long
def test_a_run_is_made_diagnosed_and_simulated(twistbench: Command, folder: Path) -> None:
    printed = good(twistbench("import-run", "log.csv", "--map", "map.yaml", "--run", "imported"))
    assert "twistbench diagnose raw/imported" in printed
    sizes_mm = {"radius": 0.4, "length": 400, "torsion-zone": 150, "separator": 8}
    sizes = [word for name, value in sizes_mm.items() for word in (f"--{name}-mm", value)]
    columns = ("--channels", "{motor_turns: {column: theta, unit: turns}}")
    printed = good(twistbench("new-run", "made", "--material", "UHMWPE", *sizes, *columns, "--recording", "log.csv"))
    assert "twistbench diagnose raw/made" in printed
    good(twistbench("diagnose", "raw/made", "--out", "out"))
    diagnosis = json.loads((folder / "out" / "made" / "diagnosis.json").read_text())
    assert diagnosis["run"] == "made" and diagnosis["code"]
    assert not re.search(r"\bpipeline\b|snakemake", (folder / "out" / "made" / "verdict.txt").read_text())
    simulation = ("--simulation", "out/made/diagnosis.json")
    good(twistbench("simulate", "raw/imported", *simulation, "--out", "sim.parquet"))
    assert list(pd.read_parquet(folder / "sim.parquet")) == ["time_s", "displacement_mm"]


NYLON = [  # a run of the tutorial's recording, as README.md describes it
    *("--material", "nylon", "--radius-mm", "0.4", "--length-mm", "400", "--torsion-zone-mm", "150"),
    *("--separator-mm", "8", "--string-id", "spool-3", "--recording", "nylon_log.csv", "--channels"),
    "{time_s: t_ms, motor_turns: theta_rad, load_n: force_N, displacement_mm: {column: laser_mm, scale: -1}}",
]


def page_commands() -> list[list[str]]:
    """The commands of docs/use_a_model.md that need no checkout, as words; they have no quotes."""
    page = (ROOT / "docs" / "use_a_model.md").read_text().partition("## Without the main job")[2]
    lines = [line.partition("#")[0] for line in page.partition("```sh\n")[2].partition("```")[0].splitlines()]
    return [line.split()[1:] for line in lines if line.startswith("twistbench ")]


@pytest.mark.long
def test_four_commands_lead_from_a_run_folder_to_answers_and_to_a_header(place: Path, folder: Path) -> None:
    """`predict` needed a dataset that no listed command of the installed package made."""
    work_folder = folder / "models"
    work_folder.mkdir()
    twistbench = (place / "bin" / "twistbench",)
    shutil.copy(TUTORIAL.with_name("nylon_log.csv"), work_folder)
    printed = good(ended(*twistbench, "new-run", "nylon-20261121-01", *NYLON, cwd=work_folder))
    dataset, predict, fit, export = page_commands()
    assert f"  or put its points together, for models: {shlex.join(['twistbench', *dataset])}\n" in printed
    refused = ended(*twistbench, *predict, cwd=work_folder)
    assert refused.returncode == 2 and "make it of run folders: twistbench dataset raw/<run> ..." in refused.stderr
    refused = ended(*twistbench, *export, cwd=work_folder)
    assert (
        refused.returncode == 2 and "twistbench fit-model spline processed/<material>/dataset.parquet" in refused.stderr
    )
    asks = good(ended(*twistbench, *dataset, cwd=work_folder))
    (write,) = re.findall(r"printf .*", asks)
    subprocess.run(["sh", "-c", write], cwd=work_folder, check=True)
    assert shlex.join(["twistbench", *predict]) in asks and shlex.join(["twistbench", *fit]) in asks
    good(ended(*twistbench, *predict, cwd=work_folder))
    assert pd.read_csv(work_folder / "answers.csv")["inside"].tolist() == [True]
    assert shlex.join(["twistbench", *export]) in good(ended(*twistbench, *fit, cwd=work_folder))
    assert "Errors on whole last strokes" in good(ended(*twistbench, *export, cwd=work_folder))
    header = work_folder / "reports/nylon/spline/tsa.h"
    if compiler := shutil.which("cc"):
        (work_folder / "one.c").write_text(f'#include "{header}"\nint main(void) {{ return 0; }}\n')
        done = subprocess.run([compiler, "-std=c99", "-Wall", "-o", "one", "one.c", "-lm"], cwd=work_folder)
        assert done.returncode == 0
    run_yaml = work_folder / dataset[1] / "run.yaml"
    run_yaml.write_text(f"{run_yaml.read_text()}tare: checked\n")
    done = ended(*twistbench, *predict, cwd=work_folder)
    assert done.returncode == 0 and f"To make it anew: {shlex.join(['twistbench', *dataset])}\n" in done.stderr
    bare = "import sys, pandas, twistbench as tb; tb.points(tb.Recording.read(sys.argv[1])).to_parquet(sys.argv[2])"
    done = ended(place / "bin" / "python", "-c", bare, dataset[1], predict[1], cwd=work_folder)
    assert done.returncode == 0, done.stderr
    refused = ended(*twistbench, *predict, cwd=work_folder)
    assert refused.returncode == 2 and "Mend: delete it and make it again: twistbench dataset" in refused.stderr


@pytest.mark.long
def test_a_model_that_python_saved_is_exported_as_the_reference_says(place: Path, folder: Path) -> None:
    imported = ["import-run", "log.csv", "--map", "map.yaml", "--run", "saved"]
    good(ended(place / "bin" / "twistbench", *imported, cwd=folder))
    named = re.search(r"`twistbench (export nylon\.model [^`]*)`", (ROOT / "docs" / "api.md").read_text())
    assert named
    fit = "tb.fit('spline', tb.points(tb.Recording.read('raw/saved')))"
    code = f"import twistbench as tb; {fit}.save('nylon.model')"
    good(ended(place / "bin" / "python", "-c", code, cwd=folder))
    good(ended(place / "bin" / "twistbench", *named[1].split(), cwd=folder))
    assert (folder / "tsa.h").is_file()


@pytest.mark.long
def test_the_tutorial_runs_on_the_wheel(place: Path, tmp_path: Path) -> None:
    """From a CSV to a diagnosis and an exported model, in a folder that holds the CSV alone."""
    shutil.copy(TUTORIAL.with_name("nylon_log.csv"), tmp_path)
    cells = code_cells()
    done = ended(place / "bin" / "python", "-c", as_program(cells), cwd=tmp_path)
    assert not (stale := unlike(cells, good(done))), f"store the notebook anew (CONTRIBUTING.md): {stale}"


@pytest.mark.long
def test_what_is_wrong_is_said_with_the_installed_name(twistbench: Command) -> None:
    done = twistbench("diagnose", "raw/nothing", "--out", "out")
    assert done.returncode == 2 and "twistbench new-run" in done.stderr and "pipeline" not in done.stderr


@pytest.mark.long
@pytest.mark.parametrize(
    ("lacks", "extra", "file", "words"),
    [
        ("h5py", "formats", "a.h5", ["import-run", "a.h5", "--guess"]),
        ("torch", "models", "mlp/within-0.model", ["export", "mlp/within-0.model", "--format", "c"]),
    ],
)
def test_a_package_that_is_left_to_choose_is_named_where_it_lacks(
    place: Path, folder: Path, lacks: str, extra: str, file: str, words: list[str]
) -> None:
    (folder / file).parent.mkdir(exist_ok=True)
    if file.endswith(".model"):
        write_json(folder / file, {})
    else:
        (folder / file).write_bytes(b"\x89HDF\r\n\x1a\n")
    code = (
        f"import sys; sys.modules[{lacks!r}] = None; sys.argv = ['twistbench', *{words}]; "
        "from twistbench.__main__ import main; main()"
    )
    done = ended(place / "bin" / "python", "-c", code, cwd=folder)
    assert done.returncode == 2 and f"pip install 'twistbench[{extra}]'" in done.stderr, done.stderr
