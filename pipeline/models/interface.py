"""What a kinematic model is: fitted on points, it maps twist to contraction and back."""

import importlib
from pathlib import Path
from typing import Protocol

import pandas as pd

from pipeline.kinematics import Array


class Model(Protocol):
    """One model of one material; `points` has the columns of `schemas.DATASET`."""

    def fit(self, points: pd.DataFrame, seed: int) -> None:
        """Learn from points; the same points and seed give the same model."""

    def forward(self, points: pd.DataFrame) -> Array:
        """Contraction in mm for the points' `motor_turns` and conditions; reads no `displacement_mm`."""

    def inverse(self, points: pd.DataFrame) -> Array:
        """Twist in turns for the points' `displacement_mm` and conditions; reads no `motor_turns`."""

    def save(self, path: Path) -> None:
        """Write the fitted model to a file."""

    def load(self, path: Path) -> None:
        """Take over the fitted model that a file holds."""


def make_model(name: str, **settings: object) -> Model:
    """The unfitted model that `pipeline/models/<name>.py` holds, with its settings from the configuration."""
    model: Model = importlib.import_module(f"pipeline.models.{name}").MODEL(**settings)
    return model
