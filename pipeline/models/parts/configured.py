"""A model by its name and settings, and its fit; errors of both are told in words."""

from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
from pydantic import ValidationError

from ...ground.command import HOUSE
from ...ground.errors import BadInput
from ..interface import Model, make_model, names, settings_of
from .settings import Refused, refusal, shown, told


def configured(name: str, settings: str) -> Model:
    """The unfitted model of a name with settings from a JSON object; raises BadInput for settings that it refuses."""
    if name not in names():
        problem = f"is no file of {HOUSE}/models that has a MODEL"
        raise BadInput("--model", shown(name) or '""', problem, f"choose one of {', '.join(names())}")
    try:
        parsed = told(settings)
        try:
            return make_model(name, **parsed)
        except (TypeError, ValidationError) as error:
            raise refusal(error, settings_of(name), parsed) from error
    except Refused as error:
        raise BadInput("--settings", f"{name}.{error.field}", error.problem, error.mend) from error


@contextmanager
def fitting(name: str) -> Iterator[None]:
    """Raise BadInput if a fit, or an answer of it, overflows or has no solution."""
    try:
        yield
    except (ArithmeticError, np.linalg.LinAlgError) as error:
        mend = "lower its rate or its size in --settings, or take another model; see whether the points are all alike"
        raise BadInput("--model", name, f"cannot be fitted to these points: {error}", mend) from error
