"""What learns a reading without physics, one method a file: it holds LOOK, SEEDS and `learn`, and is found by that."""

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
    """How each method looks, by its name, in the order of their titles; read as text: to learn takes a library."""
    unnamed: Look = {"title": "", "colour": "", "marker": ""}
    trees = {name: ast.parse((HERE / f"{name}.py").read_text("utf-8")) for name in holding(HERE, r"def learn\(")}
    look_by_name = {name: literal(tree, "LOOK", unnamed) for name, tree in trees.items()}
    return dict(sorted(look_by_name.items(), key=lambda entry: entry[1]["title"].lower()))


def learner(name: str) -> tuple[Learn, tuple[int, ...]]:
    """How a method of a name learns, and with which seeds: the median of those is told."""
    module = importlib.import_module(f"{__package__}.{name}")
    return module.learn, module.SEEDS
