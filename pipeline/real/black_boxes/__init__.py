"""Methods that learn a reading without physics, one file each: a file with LOOK, SEEDS and `learn` is found."""

import ast
import importlib
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import TypedDict

from ...ground.code.modules import holding, literal
from ...ground.kinematics import Array

FOUND_BY_NAME = ("pipeline.real.black_boxes.*",)  # for fingerprints
HERE = Path(__file__).parent
Predict = Callable[[Array], Array]  # standard columns, shape (rows, columns) -> the reading's unit, shape (rows,)
Learn = Callable[[Array, Array, int], Predict]  # the same, the reading of the rows in its unit, a seed


class Look(TypedDict):
    """How a method stands in tables and figures."""

    title: str
    colour: str
    marker: str


@cache
def looks() -> dict[str, Look]:
    """The look of each method, by its name, in the order of their titles; read as text, without importing it."""
    unnamed: Look = {"title": "", "colour": "", "marker": ""}
    trees = {name: ast.parse((HERE / f"{name}.py").read_text("utf-8")) for name in holding(HERE, r"def learn\(")}
    look_by_name = {name: literal(tree, "LOOK", unnamed) for name, tree in trees.items()}
    return dict(sorted(look_by_name.items(), key=lambda entry: entry[1]["title"].lower()))


def learner(name: str) -> tuple[Learn, tuple[int, ...]]:
    """The learning function of a method, and its seeds: their median is reported."""
    module = importlib.import_module(f"{__package__}.{name}")
    return module.learn, module.SEEDS
