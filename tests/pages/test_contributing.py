"""CONTRIBUTING.md, executed: its files dropped into a copy of the package, named as it says, and asked.

A model, an exporter, an effect, compared methods and a format are on that page; a mechanism and a system are on
docs/new_rig.md, which has a test of its own. What all of them together do to a checkout: `test_added_files.py`.
"""

import ast
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import copied
import numpy as np
import pytest
import yaml
from files_shown import shown
from formats.foreign_files import CHANNELS, GOOD, SERIES
from made_recording import content
from models.made_dataset import made_dataset

from pipeline.ground.stored import schemas
from pipeline.run.samples import read_samples

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "CONTRIBUTING.md").read_text()
FILES = shown("CONTRIBUTING.md")

MODEL_AND_HEADER = """
import sys
from pathlib import Path
import numpy as np, pandas as pd
from pipeline.export import c_header, interface, onnx_model, source
from pipeline.ground.errors import BadInput
from pipeline.models.about import About
from pipeline.models.interface import about, make_model, names

points = pd.read_parquet("points.parquet")
assert "shifted" in names() and about("shifted") == About()
model, plain = make_model("shifted"), make_model("traditional")
model.fit(points, 0)
file = Path("shifted/within-0.model")
file.parent.mkdir()
model.save(file)
again = make_model("shifted")
again.load(file)
x = again.forward(points.drop(columns="displacement_mm"))
err = lambda answers: float(np.sqrt(np.mean((answers - points["displacement_mm"]) ** 2)))
assert err(x) < err(plain.forward(points))
turns = again.inverse(points.drop(columns="motor_turns").assign(displacement_mm=x))
assert np.allclose(turns, points["motor_turns"], atol=1e-6)
assert "shifted" in interface.names()
opened = source.opened(file, None, source.Beside(Path("points.parquet")))
text = c_header.header(opened, "arm")
assert f"{model.zero_mm:.6g}"[:5] in text and "arm_raw_inverse" in text
Path("arm.h").write_text(text)
try:
    onnx_model.graphs(opened, "arm")
except BadInput as error:
    assert "say --format c" in str(error)
else:
    raise AssertionError("a model without `answer` has no graphs")
"""
METHOD = """
import sys
from pathlib import Path
import numpy as np
from pipeline.diagnosis.study import engine
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.proof.baselines import __main__ as command
from pipeline.proof.baselines.learnt import calibrated
from pipeline.run.samples import read_samples

folder = Path(sys.argv[1])
run, samples = read_samples(folder)
seen = calibrated(engine.make_problem([RecordedRun.cut(run, samples, folder=folder)]))
assert "cubic_fit" in command.names()
learnt = command.method("cubic_fit")(seen)
left = seen.residual_mm - learnt.adds_mm(seen.problem)
assert learnt.named is None and engine.rms(left) < engine.rms(seen.residual_mm)
"""
EFFECT = """
from pipeline.proof.case import draw_case, performed
from pipeline.proof.plan import effect_names
from pipeline.rig import effects

assert "x_mains_hum" in effects.names() and "x_mains_hum" in effect_names(open_set=True)
case = draw_case(1, "open", "rich", ["x_mains_hum"], [1.0])
assert case.rulings["x_mains_hum"].pure and abs(case.sizes["x_mains_hum"].kappa - 1.0) < 0.05
assert len(performed(case).table) > 5000
"""
BLACK_BOX = """
import numpy as np
from pipeline.real.black_boxes import learner, looks
from pipeline.report.real.figures import COLOURS, MARKERS
from pipeline.report.real.results import TITLES

assert TITLES["nearest"] == looks()["nearest"]["title"] == "nearest rows" and {"nearest"} <= {*COLOURS} & {*MARKERS}
learn, seeds = learner("nearest")
table = np.random.default_rng(0).normal(size=(400, 2))
predicted = learn(table, np.tanh(table[:, 0]), *seeds)(table[::7] + 0.01)
assert np.abs(predicted - np.tanh(table[::7, 0])).mean() < 0.1
"""
FORMAT = """
from pathlib import Path
import numpy as np
from pipeline.formats import format_of, read_foreign
from pipeline.foreign.folder_files import files_in
from pipeline.ground.errors import BadInput
from pipeline.ground.input.text_file import TextFile
from pipeline.foreign.imported import import_run

file, layout = Path("logs/a.npy"), TextFile.model_validate({})
assert format_of(file).name == "a NumPy array" and file in files_in(file.parent, "run", None).file_by_run.values()
import_run(file, Path("map.yaml"), "a-01", Path("raw"))
good, random, refused = file.read_bytes(), np.random.default_rng(1), 0
for number in range(300):
    broken = bytearray(good)
    for place in random.integers(0, len(good) if number % 2 else 128, 1 + number % 8):
        broken[place] = random.integers(0, 256)
    file.write_bytes(broken[: random.integers(100, len(good))] if number % 5 == 0 else broken)
    try:
        read_foreign(file, layout)
    except BadInput:
        refused += 1
assert 30 < refused < 290
"""
# files of tests that the page names for each of its files, and the id under which they run over it
RUN_OVER = {
    "shifted": ["tests/models/test_interface.py", "tests/export/test_export_equality.py"],
    "x_mains_hum": ["tests/rig/test_rig_string.py", "tests/proof/test_proof_case.py"],
    "cubic_fit": ["tests/proof/test_proof_baselines.py"],
}


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the package that holds the page's files too."""
    root = tmp_path_factory.mktemp("house")
    copied.package(root)
    for path, text in FILES.items():
        assert not (root / path).exists(), path
        (root / path).write_text(text)
    return root


def run(house: Path, code: str, *words: object) -> None:
    environment = {**os.environ, "PYTHONPATH": str(house)}
    command = [sys.executable, "-c", code, *map(str, words)]
    done = subprocess.run(command, cwd=house, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_the_pages_model_learns_is_kept_and_is_exported(house: Path) -> None:
    schemas.write(made_dataset(60, 6), schemas.DATASET, house / "points.parquet")
    run(house, MODEL_AND_HEADER)


@pytest.mark.long
def test_the_pages_method_corrects_a_recording(house: Path, make_run: object) -> None:
    run(house, METHOD, make_run("method-01"))  # type: ignore[operator]


@pytest.mark.long
def test_the_pages_effect_is_concealed(house: Path) -> None:
    run(house, EFFECT)


@pytest.mark.long
def test_the_pages_black_box_learns_and_stands_in_figures(house: Path) -> None:
    run(house, BLACK_BOX)


@pytest.mark.long
def test_the_pages_format_is_imported_and_refused_in_words_where_it_is_damaged(house: Path) -> None:
    logged = np.zeros(len(GOOD), [(name, "f8") for name in SERIES])
    for name, values in SERIES.items():
        logged[name] = values
    (house / "logs").mkdir()
    np.save(house / "logs/a.npy", logged)
    (house / "map.yaml").write_text(yaml.safe_dump(content("x", run=None, channels=CHANNELS)))
    run(house, FORMAT)
    _, samples = read_samples(house / "raw/a-01")
    assert samples["displacement_mm"].to_numpy() == pytest.approx(GOOD["displacement_mm"].to_numpy())


@pytest.mark.long
@pytest.mark.parametrize("name", RUN_OVER)
def test_the_tests_that_the_page_names_run_over_its_files(house: Path, name: str) -> None:
    if not (house / "tests").exists():
        shutil.copytree(ROOT / "tests", house / "tests", ignore=shutil.ignore_patterns("__pycache__", "data"))
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *RUN_OVER[name], "-k", name]
    environment = {**os.environ, "PYTHONPATH": f"{house}{os.pathsep}{house / 'tests'}"}
    done = subprocess.run(command, cwd=house, env=environment, capture_output=True, text=True)
    ran = re.search(r"^(\d+) passed", done.stdout.splitlines()[-1])
    assert done.returncode == 0 and ran and int(ran[1]), done.stdout[-3000:]


def test_the_page_lists_where_a_new_kind_of_string_is_written() -> None:
    """Wherever there are names of the kinds of string, but for who conceals physics; and where their columns are."""
    (item,) = re.findall(r"^- A rig without a string needs no other file\. .*?(?=^- )", PAGE, re.M | re.S)
    package = ROOT / "pipeline"
    naming = {path.relative_to(package).as_posix() for path in package.rglob("*.py") if says(path, "twisted_pair")}
    of_others = {name for name in naming if name.startswith("rig/authors/")}
    assert of_others and set(re.findall(r"`([\w/]+\.py)`", item)) == naming - of_others | {"ground/stored/schemas.py"}


def says(path: Path, word: str) -> bool:
    """Whether a word stands in a string of a module."""
    text = path.read_text(encoding="utf-8")
    nodes = ast.walk(ast.parse(text)) if word in text else ()
    return any(isinstance(node, ast.Constant) and word in str(node.value) for node in nodes)


def test_what_the_page_names_is_there() -> None:
    for path in re.findall(r"`((?:pipeline|tests|docs)/[\w/]+\.(?:py|md|yaml))`|\((docs/[\w.]+)", PAGE):
        named = next(filter(None, path))
        assert named in FILES or (ROOT / named).is_file(), named
    rooms = "config|diagnosis|export|foreign|formats|ground|models|parts|proof|rig|run|systems"
    short = re.findall(rf"`((?:{rooms})/[\w/]+\.(?:py|yaml))`", PAGE)
    for name in short:
        assert any((ROOT / "pipeline" / room / name).is_file() for room in (".", "models")), name
