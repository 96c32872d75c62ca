"""What is exported gives the Python model's answers: the C header in both precisions, and the ONNX graphs."""

import json
from typing import Any

import numpy as np
import onnxruntime
import pytest

from pipeline.export.interface import Source, exporter, names
from pipeline.export.onnx_model import GIVEN, graphs

CASES = [
    *((name, "one") for name in names()),
    *((name, "campaign") for name in ("spline", "cinn", "inn", "mlp", "polynomial", "calibrated")),
    *((name, "pair") for name in ("spline", "cinn", "traditional")),
]
POINTS = 2000
FLAT_TURNS = 1.0  # below it a pair's curve is flat: any rounding of x is a large one of the twist

cases = pytest.mark.parametrize(("name", "kind"), CASES)
cases_with_graphs = pytest.mark.parametrize(
    ("name", "kind"), [case for case in CASES if hasattr(exporter(case[0]), "answer")]
)


def single(name: str) -> bool:
    """Whether a model computes in single precision itself, as torch's do."""
    return getattr(exporter(name), "PRECISION", np.float64) is np.float32


def queries(source: Source, column: str, count: int = POINTS) -> Any:
    """Queries over the whole box, such that single precision holds them exactly."""
    drawn = source.inputs.drawn(column, count, np.random.default_rng(1)).astype(np.float32).astype(float)
    fields = source.inputs.columns(column)
    inside = [(drawn[:, at] >= field.low) & (drawn[:, at] <= field.high) for at, field in enumerate(fields)]
    return drawn[np.all(inside, axis=0)]


def wanted(source: Source, way: str, query_rows: Any) -> Any:
    """The Python model's answers, a twist held in its range."""
    points = source.inputs.points(GIVEN[way], query_rows)
    if way == "forward":
        return source.model.forward(points) + source.zero_mm
    points = points.assign(displacement_mm=points["displacement_mm"] - source.zero_mm)
    return np.clip(source.model.inverse(points), *source.inputs.motor_turns)


def furthest(source: Source, kind: str, way: str, query_rows: Any, answers: Any) -> float:
    """Largest difference from the Python model in standard deviations of its answer over the box."""
    truth = wanted(source, way, query_rows)
    steep = truth > FLAT_TURNS if (kind, way) == ("pair", "inverse") else np.full(len(truth), True)
    return float(np.abs(answers - truth)[steep].max() / truth.std())


def test_the_models_that_were_ever_exported_still_are() -> None:
    assert {"spline", "cinn", "inn", "polynomial", "mlp", "traditional", "calibrated"} <= set(names())


@cases
def test_the_header_gives_the_models_answers(source: Any, program: Any, name: str, kind: str) -> None:
    model = source(name, kind)
    for way, column in GIVEN.items():
        query_rows = queries(model, column)
        codes, answers = program(name, kind, "float").answers(way, query_rows)
        assert set(codes) <= ({0.0, -1.0} if way == "inverse" else {0.0})
        assert len(query_rows) >= 0.99 * POINTS
        assert furthest(model, kind, way, query_rows, answers) <= 1e-5


@pytest.mark.parametrize(("name", "kind"), [("cinn", "one"), ("polynomial", "one"), ("calibrated", "one")])
def test_in_double_precision_as_well(source: Any, program: Any, name: str, kind: str) -> None:
    model = source(name, kind)
    for way, column in GIVEN.items():
        query_rows = queries(model, column)
        _, answers = program(name, kind, "double").answers(way, query_rows)
        assert furthest(model, kind, way, query_rows, answers) <= (1e-5 if single(name) else 1e-9)


@pytest.mark.parametrize("kind", ["one", "campaign"])
def test_a_spline_in_double_precision_is_the_python_one(source: Any, program: Any, kind: str) -> None:
    model = source("spline", kind)
    for way, column in GIVEN.items():
        query_rows = queries(model, column)
        assert (
            furthest(model, kind, way, query_rows, program("spline", kind, "double").answers(way, query_rows)[1])
            <= 1e-12
        )


@pytest.mark.parametrize("real", ["float", "double"])
@pytest.mark.parametrize("kind", ["one", "campaign"])
def test_prepared_tables_give_the_plain_answers(source: Any, program: Any, kind: str, real: str) -> None:
    compiled = program("spline", kind, real)
    for way, column in GIVEN.items():
        query_rows = queries(source("spline", kind), column)
        np.testing.assert_array_equal(compiled.prepared(way, query_rows), compiled.answers(way, query_rows))


@cases_with_graphs
def test_the_graphs_give_the_models_answers(source: Any, program: Any, name: str, kind: str) -> None:
    model = source(name, kind)
    for way, graph in graphs(model, "tsa").items():
        query_rows = queries(model, GIVEN[way])
        value, inside = answered(graph, query_rows)
        assert furthest(model, kind, way, query_rows, value) <= (1e-5 if single(name) else 1e-12)
        codes, _ = program(name, kind, "float").answers(way, query_rows)
        assert np.mean(inside == (codes == 0)) >= 0.999  # a twist at its range's very end may round either way


@pytest.mark.parametrize(("name", "kind"), [("spline", "campaign"), ("cinn", "one")])
def test_a_graph_says_what_it_reads_and_what_lies_outside(source: Any, name: str, kind: str) -> None:
    model = source(name, kind)
    for way, graph in graphs(model, "tsa").items():
        metadata = {prop.key: prop.value for prop in graph.metadata_props}
        fields, columns = model.inputs.columns(GIVEN[way]), json.loads(metadata["columns"])
        assert [column["name"] for column in columns] == [field.name for field in fields]
        assert json.loads(metadata["materials"]) == list(model.inputs.materials)
        middle = queries(model, GIVEN[way], 1)[0]
        for at, column in enumerate(columns):
            step = 1.0 if column["whole"] else 1e-3 * (column["high"] - column["low"])
            for wrong in (column["low"] - step, column["high"] + step, np.nan, np.inf, -np.inf):
                query = middle.copy()
                query[at] = wrong
                assert not answered(graph, query[None])[1][0], (column["name"], wrong)
        for field, wrong in (("stroke", 1.5), ("direction", 0.0)):
            query = middle.copy()
            query[[column["name"] for column in columns].index(field)] = wrong
            assert not answered(graph, query[None])[1][0]


def answered(graph: Any, query_rows: Any) -> tuple[Any, Any]:
    """A graph's value and inside."""
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = 1
    session = onnxruntime.InferenceSession(graph.SerializeToString(), options)
    kind = np.float64 if "double" in session.get_inputs()[0].type else np.float32
    return session.run(["value", "inside"], {"queries": query_rows.astype(kind)})
