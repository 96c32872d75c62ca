"""Every file of pipeline/models that holds a MODEL keeps the interface: a new file is tested by being there."""

import ast
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import yaml
from made_dataset import made_dataset

from pipeline import models
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.ground.model_names import USUAL
from pipeline.models.interface import Model, about, make_model

FOLDER = Path(models.__file__).parent
MODELS = sorted(
    path.stem for path in FOLDER.glob("*.py") if re.search(r"^MODEL\b", path.read_text("utf-8"), re.MULTILINE)
)
# Budgets that make a test quick; a model that is not named here is fitted with its defaults.
QUICK = {
    "inn": {"blocks": 4, "width": 24, "layers": 2, "epochs": 16, "batch": 60, "rates": [8e-3, 4e-3, 1e-3, 5e-4]},
    "cinn": {"blocks": 4, "width": 16, "epochs": 16, "batch": 60},
    "mlp": {"width": 16, "epochs": 16, "batch": 60, "rate": 1e-2},
    "diagnosed": {"without": sorted({*mechanisms()} - {"backlash", "plastic_elongation", "radius_compaction"})},
}
LEARNS_MUCH = ("calibrated", "cinn", "diagnosed", "inn", "mlp", "polynomial", "spline")  # four tenths of the error go

named = pytest.mark.parametrize("name", MODELS)


def quick(name: str) -> Model:
    return make_model(name, **QUICK.get(name, {}))


def fitted(name: str, points: pd.DataFrame, seed: int = 0) -> Model:
    model = quick(name)
    model.fit(points, seed)
    return model


@pytest.fixture(scope="module", params=MODELS)
def case(request: pytest.FixtureRequest, points: pd.DataFrame) -> tuple[str, Model, pd.DataFrame]:
    """A model's name, the model fitted on the training points, and the held-out points."""
    model = fitted(request.param, points[points["within"] == "train"])
    return request.param, model, points[points["within"] == "test"]


def rmse(error: np.ndarray) -> float:
    return float(np.sqrt(np.mean(np.square(error))))


def test_the_folder_holds_the_papers_models() -> None:
    assert {"traditional", "calibrated", "polynomial", "inn", "mlp", "cinn", "spline", "diagnosed"} <= set(MODELS)


def test_predictions_are_finite_floats_one_a_point(case: tuple[str, Model, pd.DataFrame]) -> None:
    _, model, test = case
    for prediction in (model.forward(test), model.inverse(test)):
        assert prediction.shape == (len(test),)
        assert prediction.dtype == np.float64
        assert np.isfinite(prediction).all()


def test_a_saved_model_predicts_the_same(case: tuple[str, Model, pd.DataFrame], tmp_path: Path) -> None:
    name, model, test = case
    model.save(tmp_path / "model.bin")
    loaded = make_model(name)  # with default settings: the saved ones must replace them
    loaded.load(tmp_path / "model.bin")
    assert [path.name for path in tmp_path.iterdir()] == ["model.bin"]
    np.testing.assert_array_equal(loaded.forward(test), model.forward(test))
    np.testing.assert_array_equal(loaded.inverse(test), model.inverse(test))


def test_a_loaded_model_can_be_fitted_again(case: tuple[str, Model, pd.DataFrame], tmp_path: Path) -> None:
    name, model, test = case
    model.save(tmp_path / "model.bin")
    loaded = quick(name)
    loaded.load(tmp_path / "model.bin")
    loaded.fit(test, 3)
    np.testing.assert_array_equal(loaded.forward(test), fitted(name, test, 3).forward(test))


def test_each_map_ignores_the_answer_it_is_to_give(case: tuple[str, Model, pd.DataFrame]) -> None:
    _, model, test = case
    for lie in (np.nan, test["displacement_mm"].to_numpy()[::-1]):
        np.testing.assert_array_equal(model.forward(test.assign(displacement_mm=lie)), model.forward(test))
    for lie in (np.nan, test["motor_turns"].to_numpy()[::-1]):
        np.testing.assert_array_equal(model.inverse(test.assign(motor_turns=lie)), model.inverse(test))


def test_a_prediction_does_not_depend_on_the_points_beside_it(case: tuple[str, Model, pd.DataFrame]) -> None:
    _, model, test = case
    shuffled = test.sample(frac=1.0, random_state=1)
    order = test.index.get_indexer(shuffled.index)
    np.testing.assert_allclose(model.forward(shuffled), model.forward(test)[order], atol=1e-4)
    np.testing.assert_allclose(model.inverse(shuffled), model.inverse(test)[order], atol=1e-3)


def test_no_model_is_worse_than_the_nominal_one_and_those_that_learn_much_are_better(
    case: tuple[str, Model, pd.DataFrame],
) -> None:
    name, model, test = case
    share = 0.6 if name in LEARNS_MUCH else 1.0
    nominal = make_model("traditional")
    for column, map_ in (("displacement_mm", "forward"), ("motor_turns", "inverse")):
        truth = test[column].to_numpy()
        assert rmse(getattr(model, map_)(test) - truth) <= share * rmse(getattr(nominal, map_)(test) - truth)


def test_fit_and_prediction_leave_the_points_alone(case: tuple[str, Model, pd.DataFrame]) -> None:
    name, _, test = case
    before = test.copy()
    model = fitted(name, test)
    model.forward(test)
    model.inverse(test)
    pd.testing.assert_frame_equal(test, before)


@named
def test_the_same_seed_gives_the_same_model_whatever_ran_before(name: str, points: pd.DataFrame) -> None:
    train = points[points["stroke"] <= 2]
    first = fitted(name, train, 7)
    fitted(name, train, 8)
    np.random.default_rng().normal()
    again = fitted(name, train, 7)
    np.testing.assert_array_equal(first.forward(points), again.forward(points))
    np.testing.assert_array_equal(first.inverse(points), again.inverse(points))


@named
def test_no_global_generator_is_touched(name: str, points: pd.DataFrame) -> None:
    import torch

    before = np.random.get_state()[1].copy(), torch.get_rng_state()
    fitted(name, points[points["stroke"] <= 2], 1)
    assert (np.random.get_state()[1] == before[0]).all()
    assert torch.equal(torch.get_rng_state(), before[1])


@named
def test_varying_dimensions_and_one_stroke_are_fine(name: str) -> None:
    """Two strings of different radius, a single stroke: n is the constant column, r is not."""
    parts = [made_dataset(40, 1), made_dataset(40, 1).assign(string="made-02", radius_mm=0.41)]
    points = pd.concat(parts, ignore_index=True)
    model = fitted(name, points)
    assert np.isfinite(model.forward(points)).all() and np.isfinite(model.inverse(points)).all()


@named
def test_a_pair_without_separator_is_fine(name: str, pair_points: pd.DataFrame) -> None:
    model = fitted(name, pair_points)
    error_mm = model.forward(pair_points) - pair_points["displacement_mm"]
    assert rmse(error_mm) < 1.0  # of 8 mm that the pair contracts, and at a quick budget
    assert np.isfinite(model.inverse(pair_points)).all()


def test_a_model_imports_torch_only_where_it_says_that_it_needs_it() -> None:
    needing = [name for name in MODELS if about(name).needs_torch]
    without = ["pipeline.stages.train", *(f"pipeline.models.{name}" for name in MODELS if name not in needing)]
    program = "".join(f"import {module}; assert 'torch' not in sys.modules, '{module}'\n" for module in without)
    program += "sys.modules['torch'] = None\n"  # from here on it is as where it is not installed
    program += "".join(
        f"try:\n import pipeline.models.{name}\nexcept ModuleNotFoundError as error:\n assert error.name == 'torch'\n"
        f"else:\n raise AssertionError('{name} needs no torch')\n"
        for name in needing
    )
    done = subprocess.run([sys.executable, "-c", f"import sys\n{program}"], capture_output=True, text=True)
    assert done.returncode == 0 and needing, done.stderr


WORK_ON_MODELS = [
    "predict.py",
    "stages/*.py",
    "stages/campaign/*.py",
    "export/[!c]*.py",
    "notebook/*.py",
    "workflow/*.py",
]


def test_what_works_on_models_names_none_but_the_first_and_the_last_of_the_tables() -> None:
    """What it must know of a model, the model's file says: by its ABOUT; which is the usual one, the ground says."""
    paths = [path for pattern in WORK_ON_MODELS for path in FOLDER.parent.glob(pattern)]
    for path in paths:
        nodes = ast.walk(ast.parse(path.read_text("utf-8")))
        quoted = {node.value for node in nodes if isinstance(node, ast.Constant)}
        assert quoted & set(MODELS) <= {"inn", "traditional"}, path
    assert len(paths) > 30 and USUAL in MODELS and not about(USUAL).needs_motion


def test_the_configuration_says_truly_who_is_told_the_direction(case: tuple[str, Model, pd.DataFrame]) -> None:
    """It decides the floor that a model is held against: who is told answers otherwise on the way back."""
    name, model, test = case
    listed = yaml.safe_load((FOLDER.parent / "config" / "default.yaml").read_text("utf-8"))["models"]
    if name not in listed:
        pytest.skip("the configuration does not list it")
    phase = test["phase"].map({"winding": "unwinding", "unwinding": "winding"})
    back = test.assign(direction=-test["direction"], phase=phase)
    answers = [np.stack([model.forward(way), model.inverse(way)]) for way in (test, back)]
    assert (not np.array_equal(*answers)) == listed[name].get("direction", False)
