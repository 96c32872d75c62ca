"""The interface of a kinematic model: it is fitted on points, and maps twist to contraction and back."""

import ast
import importlib
from functools import cache
from pathlib import Path
from typing import Protocol

import pandas as pd

from ..ground.code.modules import holding, said_true
from ..ground.kinematics import Array
from .about import About


class Model(Protocol):
    """One model of one material; `points` has the columns of `schemas.DATASET`."""

    def fit(self, points: pd.DataFrame, seed: int) -> None:
        """Learn from points; the same points and seed give the same model."""

    def forward(self, points: pd.DataFrame) -> Array:
        """Contraction in mm for the points' `motor_turns` and conditions; reads no `displacement_mm`.

        Shape (points,).
        """

    def inverse(self, points: pd.DataFrame) -> Array:
        """Twist in turns for the points' `displacement_mm` and conditions; reads no `motor_turns`. Shape (points,)."""

    def save(self, path: Path) -> None:
        """Write the fitted model to a file."""

    def load(self, path: Path) -> None:
        """Take over the fitted model that a file holds."""


class StringsApart(Protocol):
    """A model with separate numbers for every string, as its `ABOUT` says (`each_string_apart`)."""

    moves: dict[str, dict[str, float]]  # by string: what each dimension is moved by, and `zero_mm`; all in mm


@cache
def names() -> tuple[str, ...]:
    """Names of all models: of the files in this folder that define MODEL."""
    return holding(Path(__file__).parent, r"MODEL\b")


@cache
def names_for_new_strings() -> tuple[str, ...]:
    """Names of the models that answer single questions about a string that nobody recorded, as `ABOUT` declares.

    None is imported: some take seconds, or need a package that is not installed.
    """
    return tuple(name for name in names() if not _declared(name) & {"each_string_apart", "needs_motion"})


@cache
def names_with_motion() -> tuple[str, ...]:
    """Names of the models that answer along a whole motion alone, as `ABOUT` declares; none is imported."""
    return tuple(name for name in names() if "needs_motion" in _declared(name))


def _declared(name: str) -> frozenset[str]:
    return said_true(ast.parse(Path(__file__).with_name(f"{name}.py").read_text("utf-8")), "ABOUT")


def settings_of(name: str) -> type | None:
    """The dataclass of a model's settings, None for a model without any."""
    settings: type | None = getattr(importlib.import_module(f"{__package__}.{name}"), "Settings", None)
    return settings


def about(name: str) -> About:
    """The entry `ABOUT` of a model's file; the defaults where it has none."""
    about_model: About = getattr(importlib.import_module(f"{__package__}.{name}"), "ABOUT", About())
    return about_model


def make_model(name: str, **settings: object) -> Model:
    """The unfitted model that `pipeline/models/<name>.py` holds, with its settings from the configuration."""
    model: Model = importlib.import_module(f"{__package__}.{name}").MODEL(**settings)
    return model
