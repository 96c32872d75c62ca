"""Kinematic models by name, in memory: the points of recordings, and models fitted to them."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from pickle import UnpicklingError

import pandas as pd

from ..diagnosis.words.language.quantity import listing
from ..ground.errors import BadInput
from ..ground.kinematics import Array
from ..ground.stored import schemas
from ..ground.words.counts import counted
from ..models.interface import Model, names
from ..models.parts.configured import configured, fitting
from ..run.description import STRING_ACTUATORS
from ..stages.dataset import make_dataset
from .as_arguments import as_arguments, settings_in_json
from .recording import Recording, as_recorded

MOST_NAMES = 3  # of strings, in the line that shows a model


def model_names() -> tuple[str, ...]:
    """Names of all models, sorted, as `fit` and `load` take them."""
    return names()


@dataclass(frozen=True, repr=False)
class FittedModel:
    """A model of a `name` that is fitted: it maps twist to contraction and back.

    `origin`: what it was fitted to, or the file that it was read from, in words.
    """

    name: str
    model: Model
    origin: str

    def forward(self, points: pd.DataFrame) -> Array:
        """The contraction in mm of each point's twist and conditions; shape (points,).

        The points have the columns that `points` of recordings gives, of which `displacement_mm` is not read. Raises
        BadInput where one is missing. Questions of one's own are easier asked of `answers`.
        """
        with _all_columns():
            return self.model.forward(points)

    def inverse(self, points: pd.DataFrame) -> Array:
        """The twist in turns of each point's contraction and conditions; shape (points,).

        The points have the columns that `points` of recordings gives, of which `motor_turns` is not read. Raises
        BadInput where one is missing.
        """
        with _all_columns():
            return self.model.inverse(points)

    def save(self, path: Path | str) -> None:
        """Write it to a file, as `load` and `twistbench export` read it; raises OSError."""
        model = self.model
        model.save(Path(path))

    def __repr__(self) -> str:
        return f"<FittedModel {self.name}, {self.origin}>"


@contextmanager
def _all_columns() -> Iterator[None]:
    """Raise BadInput where points lack a column."""
    try:
        yield
    except KeyError as error:
        mend = "take rows of points(recordings) and change them; a question of your own: answers(points, questions)"
        raise BadInput(
            "points", str(error.args[0]), "is no column of these points, and the model reads it", mend
        ) from None


def _in_words(points: pd.DataFrame) -> str:
    """To what a model was fitted: how many points, and of which strings."""
    names = sorted(map(str, points["string"].unique()))
    strings = listing(names) if len(names) <= MOST_NAMES else counted(len(names), "string")
    return f"fitted to {counted(len(points), 'point')} of {strings}"


def _unfitted(name: str, settings: dict[str, object]) -> Model:
    """The unfitted model of a name; raises BadInput in the words of a notebook."""
    with as_arguments():
        return configured(name, settings_in_json(name, settings))


def points(recordings: Sequence[Recording] | Recording) -> pd.DataFrame:
    """The moving points of a recording of a string, or of several, tared and numbered by stroke: one row a point.

    Tared: `Recording.tare_mm` is added, so that the zero is the model's, `x = L - d`, not the sensor's.

    Columns that tell where a point is from: `run`, `string`, `stroke` (from 1), `phase`, `direction` (1 winding, -1
    unwinding), `block` (which of the stretches that `within` holds out), `time_s` (s). What was measured:
    `motor_turns` (turns), `displacement_mm` (mm), `load_n` (N). What `run.yaml` says: `actuator`, `radius_mm`,
    `length_mm`, `torsion_zone_mm`, `separator_mm` (mm), `stiffness_n_per_mm` (N/mm), and one sigma of how well they
    were measured: `radius_tolerance` (a share of the radius), `length_tolerance_mm`, `torsion_zone_tolerance_mm`,
    `separator_tolerance_mm` (mm). `within` and `later` say whether a point is to train on ("train"), held out
    ("test") or neither (""), inside strokes and in the last quarter of the strokes. Raises BadInput for a rig that is
    no string.
    """
    if isinstance(recordings, Recording):
        recordings = [recordings]
    for recording in recordings:
        if recording.run.actuator not in STRING_ACTUATORS:
            problem = f"is {recording.run.actuator}: kinematic models are of strings"
            raise BadInput(recording.folder / "run.yaml", "actuator", problem, f"use {' or '.join(STRING_ACTUATORS)}")
    if not recordings:
        raise BadInput("points", "recordings", "are none", "give at least one recording")
    return make_dataset([as_recorded(recording) for recording in recordings])


def fit(name: str, points: pd.DataFrame, seed: int = 0, **settings: object) -> FittedModel:
    """The model of a name, fitted to points; the same points and seed give the same model.

    `points` has the columns of `schemas.DATASET`, as `points` of recordings gives them. The fitted model has `forward`
    (mm for turns), `inverse` (turns for mm) and `save`. Raises BadInput for an unknown name or setting, and for points
    that it cannot be fitted to.
    """
    absent = [column for column in schemas.DATASET.names if column not in points]
    if absent:
        raise BadInput("points", absent[0], "is no column of these points", "make them by points(recordings)")
    model = _unfitted(name, settings)
    with as_arguments(), fitting(name):
        model.fit(points, seed)
    return FittedModel(name, model, _in_words(points))


def load(name: str, path: Path | str, **settings: object) -> FittedModel:
    """The model of a name as `save` wrote it, with the settings it was fitted with; raises BadInput."""
    model = _unfitted(name, settings)
    try:
        model.load(Path(path))
    except OSError as error:
        problem = f"cannot be read ({error.strerror})"
        raise BadInput(path, "model", problem, "give the file that `save` wrote: load(name, path)") from None
    except (ValueError, KeyError, TypeError, UnpicklingError) as error:
        problem = f"is no saved {name} ({type(error).__name__})"
        raise BadInput(path, "model", problem, "give the name and the settings that it was fitted with") from error
    return FittedModel(name, model, f"read from {path}")
