"""A fitted model as two ONNX graphs, forward and inverse, with names, units and ranges in their metadata."""

import json

import numpy as np
import onnx

from ..ground.schemas import unit_of
from .graph import Graph
from .inputs import ANSWER
from .onnx_curves import analytic, polynomial, spline
from .onnx_networks import coupling, pair_of_mlps
from .onnx_query import Query
from .source import Source

ANSWERS = {
    "spline": (spline, np.float64),
    "polynomial": (polynomial, np.float64),
    "traditional": (analytic, np.float64),
    "calibrated": (analytic, np.float64),
    "cinn": (coupling, np.float32),
    "inn": (coupling, np.float32),
    "mlp": (pair_of_mlps, np.float32),
}
GIVEN = {"forward": "motor_turns", "inverse": "displacement_mm"}


def graphs(source: Source, name: str) -> dict[str, onnx.ModelProto]:
    """The checked graphs by their ways, "forward" and "inverse"."""
    return {way: _graph(source, f"{name}_{way}", given) for way, given in GIVEN.items()}


def _graph(source: Source, name: str, given: str) -> onnx.ModelProto:
    """One graph: queries of shape (points, columns) to `value` and `inside`, each of shape (points,)."""
    answer, kind = ANSWERS[source.name]
    graph = Graph(kind)
    query = Query(graph, source.inputs, given)
    inside, value = query.inside(), answer(query, source)
    if given == "displacement_mm":
        value, inside = query.held(value, inside)
    fields = source.inputs.columns(given)
    metadata = {
        "model": source.name,
        "answer": json.dumps({"name": ANSWER[given], "unit": unit_of(ANSWER[given])}),
        "columns": json.dumps(
            [{"name": f.name, "unit": f.unit, "low": f.low, "high": f.high, "whole": f.whole} for f in fields]
        ),
        "materials": json.dumps(source.inputs.materials),
        "baked": json.dumps(source.inputs.baked),
        "assumed": json.dumps(source.inputs.assumed),
        "last_stroke_trained": str(source.inputs.last_stroke),
    }
    return graph.model(name, len(fields), value, inside, metadata)
