"""A fitted model as two ONNX graphs, forward and inverse, with names, units and ranges in their metadata."""

import json
from typing import Any, Protocol

import onnx
from numpy.typing import DTypeLike

from ..ground.errors import BadInput
from ..ground.units import unit_of
from .caveats import facts
from .graph import Graph
from .inputs import ANSWER
from .interface import Exporter, Source, exporter
from .onnx_query import Query

GIVEN = {"forward": "motor_turns", "inverse": "displacement_mm"}


class OnnxExporter(Exporter, Protocol):
    """An exporter that gives ONNX graphs as well."""

    PRECISION: DTypeLike

    def answer(self, query: Query, source: Source) -> str:
        """The name of the node that holds the answers, of shape (points, 1), in turns or mm."""


def graphs(source: Source, name: str) -> dict[str, onnx.ModelProto]:
    """The checked graphs by their ways, "forward" and "inverse". Raises BadInput for a model without any."""
    return {
        way: _graph(source, _exporter(source.name), f"{name}_{way}", from_column) for way, from_column in GIVEN.items()
    }


def _exporter(name: str) -> OnnxExporter:
    """A model's exporter; raises BadInput for one that gives no ONNX."""
    module: Any = exporter(name)
    if not hasattr(module, "answer"):
        raise BadInput("--format", "onnx", f"is not there for {name}", "say --format c")
    onnx_exporter: OnnxExporter = module
    return onnx_exporter


def _graph(source: Source, onnx_exporter: OnnxExporter, name: str, from_column: str) -> onnx.ModelProto:
    """One graph: queries of shape (points, columns) to `value` and `inside`, each of shape (points,)."""
    graph = Graph(onnx_exporter.PRECISION)
    query = Query(graph, source.inputs, from_column)
    inside, value = query.inside(), onnx_exporter.answer(query, source)
    if from_column == "displacement_mm":
        value, inside = query.held(value, inside)
    fields = source.inputs.columns(from_column)
    metadata = {
        "model": source.name,
        "answer": json.dumps({"name": ANSWER[from_column], "unit": unit_of(ANSWER[from_column])}),
        "columns": json.dumps(
            [{"name": f.name, "unit": f.unit, "low": f.low, "high": f.high, "whole": f.whole} for f in fields]
        ),
        "materials": json.dumps(source.inputs.materials),
        "baked": json.dumps(source.inputs.baked),
        "assumed": json.dumps(source.inputs.assumed),
        "last_stroke_trained": str(source.inputs.last_stroke),
        **facts(source),
    }
    return graph.model(name, len(fields), value, inside, metadata)
