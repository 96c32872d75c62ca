"""What a controller relies on: refusal outside, no NaN inside, the way back, a rising curve, a small header."""

import copy
import itertools
import re
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import programs
import pytest
from compiled import C99, ROOT, UNTOUCHED, WARNINGS, built, compiled, need
from first_few import first_few
from made_models import saved

from pipeline.export.c_header import CODES, header
from pipeline.export.inputs import Inputs
from pipeline.export.onnx_model import GIVEN
from pipeline.export.source import Beside, opened

EXACT = [("spline", "one"), ("spline", "campaign"), ("spline", "pair"), ("calibrated", "one"), ("cinn", "one")]
CINN, INN = [("cinn", "campaign", "float"), ("cinn", "pair", "float")], ("inn", "one", "float")
HELD, UNRECORDED = -1.0, -2.0
FORESEEN = {"one": 2, "short": 2, "switched": 1, "back": 3}  # strokes ahead: those recorded - 4, at most 3
ROUND_TRIP_TURNS = 1e-3
FLAT_MM_PER_TURN = 0.01  # below it the last digit of a contraction in single precision is 1e-4 turns


def grid(inputs: Inputs, column: str, of_given: int, of_field: int = 3) -> Any:
    """Queries on an even grid, the corners among them: all strokes and directions, some of every other field."""
    axes = [np.linspace(*getattr(inputs, column), of_given)]
    for field in inputs.fields:
        every = np.arange(field.low, field.high + 1, 2 if field.name == "direction" else 1)
        axes.append(every if field.whole else np.linspace(field.low, field.high, of_field))
    return np.array(list(itertools.product(*axes)))


def middle(inputs: Inputs, column: str) -> Any:
    """A query amid every range."""
    return np.array([field.high if field.whole else (field.low + field.high) / 2 for field in inputs.columns(column)])


@pytest.mark.parametrize(
    ("name", "kind", "real"),
    [("spline", "campaign", "float"), ("spline", "campaign", "double"), ("cinn", "campaign", "float"), INN],
)
def test_each_field_is_refused_just_outside_its_range(
    source: Any, program: Any, name: str, kind: str, real: str
) -> None:
    inputs, compiled_header = source(name, kind).inputs, program(name, kind, real)
    for way, column in GIVEN.items():
        rows, codes = [], []
        for at, field in enumerate(inputs.columns(column)):
            step = 1.0 if field.whole else 2e-6 * max(abs(field.low), abs(field.high), field.high - field.low)
            wrong = [field.low - step, field.high + step]
            wrong += [] if field.whole else [np.nan, np.inf, -np.inf]
            wrong += [0.0] if field.name == "direction" else []
            for value in wrong:
                rows.append(middle(inputs, column))
                rows[-1][at] = value
                codes.append(CODES.index(field.name) + 1)
        returned_codes, answers = compiled_header.answers(way, np.array(rows))
        assert returned_codes.tolist() == codes
        assert (answers == UNTOUCHED).all()
        if name == "spline":
            returned_codes, answers = compiled_header.prepared(way, np.array(rows))
            assert returned_codes.tolist() == codes
            assert (answers == UNTOUCHED).all()
        returned_codes, answers = compiled_header.answers(way, middle(inputs, column)[None])
        assert returned_codes[0] <= 0 and answers[0] != UNTOUCHED


@pytest.mark.parametrize(
    ("name", "kind", "real"),
    [*((*case, real) for case in EXACT for real in ("float", "double")), *CINN, INN],
)
def test_no_answer_in_the_box_is_nan_or_out_of_range(
    source: Any, program: Any, name: str, kind: str, real: str
) -> None:
    inputs = source(name, kind).inputs
    for way, column in GIVEN.items():
        codes, answers = program(name, kind, real).answers(way, grid(inputs, column, 41))
        assert np.isfinite(answers).all()
        assert set(codes) <= ({0.0} if way == "forward" else {0.0, HELD})
        if way == "inverse":
            low, high = inputs.motor_turns
            assert answers.min() >= low - 1e-5 and answers.max() <= high + 1e-5


@pytest.mark.parametrize("real", ["float", "double"])
@pytest.mark.parametrize(("name", "kind"), EXACT)
def test_twist_comes_back_through_contraction(source: Any, program: Any, name: str, kind: str, real: str) -> None:
    """Within 1e-3 turns where the contraction is not refused.

    In single precision only where the curve is not flat, which in the campaign's unseen corners it may be: there the
    contraction of the twist that came back is the same.
    """
    inputs, compiled_header = source(name, kind).inputs, program(name, kind, real)
    grid_points = grid(inputs, "motor_turns", 301)
    _, mm = compiled_header.answers("forward", grid_points)
    _, exact_mm = program(name, kind, "double").answers("forward", grid_points)
    slope = np.gradient(exact_mm.reshape(301, -1), grid_points[:, 0].reshape(301, -1)[:, 0], axis=0).ravel()
    low, high = inputs.displacement_mm
    invertible = (mm > low) & (mm < high) & (slope > (FLAT_MM_PER_TURN if real == "float" else 0.0))
    assert invertible.mean() > 0.8 and (slope > FLAT_MM_PER_TURN).mean() > 0.95
    codes, turns = compiled_header.answers("inverse", np.column_stack([mm, grid_points[:, 1:]])[invertible])
    assert (codes <= 0).all()
    _, again_mm = compiled_header.answers("forward", np.column_stack([turns, grid_points[:, 1:][invertible]]))
    if (kind, real) == ("campaign", "float"):
        assert np.abs(again_mm - mm[invertible]).max() <= 1e-4
    else:
        assert np.abs(turns - grid_points[invertible, 0]).max() <= (
            ROUND_TRIP_TURNS if real == "float" or name == "cinn" else 1e-7
        )


@pytest.mark.parametrize("real", first_few(["float", "double"]))
@pytest.mark.parametrize("kind", ["short", "campaign", "one", "hung", "back"])
def test_the_header_says_which_twists_were_recorded_around_which_load_as_python_does(
    source: Any, program: Any, kind: str, real: str
) -> None:
    """Each number was checked alone, and a twist that no recording had under its load was answered by every header."""
    inputs, pairs = source("spline", kind).inputs, source("spline", kind).pairs
    queries = grid(inputs, "motor_turns", 161, of_field=41 if kind == "short" else 11)  # a million of two fields else
    queries = queries[queries[:, 1] == 1]
    points = inputs.points("motor_turns", queries)
    outside, near = np.zeros(len(queries), bool), np.zeros(len(queries), bool)
    for paired in pairs:
        outside |= np.array([bool(reason) for reason in paired.never(points, queries[:, 0])])
        for end in paired.turns(points):
            near |= np.abs(queries[:, 0] - end) < (1e-3 if real == "float" else 1e-9)
    under = source("spline", kind).under
    if under:
        outside |= np.array([bool(reason) for reason in under.never(points, queries[:, 0])])
        near |= np.min(np.abs(queries[:, :1] - under.levels), axis=1) < 1e-3
        for end in under.strokes(points, queries[:, 0]):
            near |= np.abs(np.minimum(queries[:, 1 + inputs.names.index("stroke")], under.last) - end) < 1e-3
    codes = program("spline", kind, real).recorded(queries)
    assert set(codes[~near]) <= {0.0, UNRECORDED}
    assert ((codes == UNRECORDED) == outside)[~near].all() and near.mean() < 0.1
    assert outside.any() == (kind != "one")
    answered = program("spline", kind, real).answers("forward", queries)[0]
    assert (answered == 0.0).all(), "the functions beside it answer as before"
    wrong = np.array([[np.nan, *queries[0, 1:]], [queries[0, 0], 99, *queries[0, 2:]]])
    assert program("spline", kind, real).recorded(wrong).tolist() == [1.0, 3.0]


@pytest.mark.parametrize("kind", ["one", "short", "switched", "back"])
def test_the_header_and_predict_say_the_same_of_every_stroke(tmp_path: Path, kind: str) -> None:
    """The header called strokes recorded up to twice those that were, where predict called them outside."""
    file = saved("spline", kind, tmp_path)
    model_file = opened(file, None, Beside())
    names, last = model_file.inputs.names, model_file.inputs.last_stroke
    strokes = [(stroke, turns) for stroke in range(1, 2 * last + 1) for turns in (4.0, 14.0, 19.0)]
    table = pd.DataFrame(strokes, columns=["stroke", "motor_turns"]).assign(direction=1)
    if "load_n" in names:
        loads = pd.DataFrame({"load_n": [20.0, 28.0, 35.0] if kind == "back" else [20.0, 30.0]})
        table = table.merge(loads, how="cross")
    table.to_csv(tmp_path / "questions.csv", index=False)
    words = "--saved", file, "--out", tmp_path / "answers.csv"
    done = programs.run("pipeline.predict", tmp_path / "dataset.parquet", tmp_path / "questions.csv", *words)
    assert done.returncode == 0, done.stderr
    inside = pd.read_csv(tmp_path / "answers.csv")["inside"].to_numpy()
    codes = compiled(model_file, tmp_path / "c", "double").recorded(table[["motor_turns", *names]].to_numpy(float))
    assert ((codes == 0.0) == inside).all() and inside.any()
    assert not inside[table["stroke"] > last + FORESEEN[kind]].any() and (codes[-1], len(set(codes))) == (UNRECORDED, 2)


def test_no_stroke_is_recorded_between_two_loads_that_only_one_of_them_came_near(source: Any, program: Any) -> None:
    """Of strokes 1 to 8, 4 to 6 were under 35 N and the others under 20 N: at 28 N the header called 2 recorded."""
    place = {name: 1 + at for at, name in enumerate(source("spline", "back").inputs.names)}
    queries = np.zeros((9, 1 + len(place)))
    queries[:, 0], queries[:, place["direction"]], queries[:, place["load_n"]] = 12.0, 1, 28.0
    queries[:, place["stroke"]] = np.arange(1, 10)
    codes = program("spline", "back", "double").recorded(queries)
    assert codes.tolist() == [UNRECORDED] * 2 + [0.0] * 5 + [UNRECORDED] * 2  # those beside a recorded one are near


@pytest.mark.parametrize("real", ["float", "double"])
def test_a_load_that_only_a_string_of_another_size_was_under_is_not_recorded(
    source: Any, program: Any, real: str
) -> None:
    """The header called 20 N recorded of the radius that was under 10 N alone: each was, of one string or the other."""
    inputs = source("spline", "apart").inputs
    pairs = np.array([[0.4, 10], [0.6, 20], [0.4, 20], [0.6, 10], [0.5, 15], [0.5, 12], [0.4, 10.4], [0.4, 11]])
    place = {name: 1 + at for at, name in enumerate(inputs.names)}
    queries = np.zeros((len(pairs), 1 + len(place)))
    queries[:, 0], queries[:, place["stroke"]], queries[:, place["direction"]] = 12.0, 2, 1
    queries[:, [place["radius_mm"], place["load_n"]]] = pairs
    codes = program("spline", "apart", real).recorded(queries)
    assert codes.tolist() == [0.0, 0.0, UNRECORDED, UNRECORDED, 0.0, UNRECORDED, 0.0, UNRECORDED]
    assert (program("spline", "apart", real).answers("forward", queries)[0] == 0.0).all(), "they are answered as before"
    (usage,) = re.findall(r"its load not around one of the string's sizes", header(source("spline", "apart"), "tsa"))
    assert usage


def test_a_stroke_whose_last_rest_alone_was_under_a_load_is_not_recorded_under_it(source: Any, program: Any) -> None:
    """One sample of stroke 4 was under 30 N, at 0 turns: the header said strokes 4 to 5, and 12 turns were recorded."""
    hung_source = source("spline", "hung")
    place = {name: 1 + at for at, name in enumerate(hung_source.inputs.names)}
    queries = np.zeros((3, 1 + len(place)))
    queries[:, 0] = 12.0, 12.0, 0.1
    queries[:, place["stroke"]], queries[:, place["direction"]], queries[:, place["load_n"]] = (4, 5, 4), 1, 30.0
    assert program("spline", "hung", "double").recorded(queries).tolist() == [UNRECORDED, 0.0, 0.0]
    words = hung_source.values["load_n"]
    assert "strokes 1 to 4) and 29." in words and words.endswith("stroke 5, and stroke 4 only to 0 turns)")


@pytest.mark.parametrize("real", ["float", "double"])
@pytest.mark.parametrize("kind", ["one", "campaign"])
def test_the_spline_rises_with_twist_in_every_state(source: Any, program: Any, kind: str, real: str) -> None:
    inputs = source("spline", kind).inputs
    queries = grid(inputs, "motor_turns", 801)
    mm = program("spline", kind, real).answers("forward", queries)[1].reshape(801, -1)
    steps = np.diff(mm, axis=0)
    if real == "double":
        assert (steps > 0.0).all()
    else:  # it rises, but for the last digits of where it is all but flat
        assert (steps > -2.0 * np.spacing(np.float32(np.abs(mm).max()))).all()
        assert np.mean(steps > 0.0) > 0.999


def test_a_contraction_out_of_reach_holds_the_twist_at_its_end(source: Any, program: Any) -> None:
    inputs, compiled_header = source("spline", "campaign").inputs, program("spline", "campaign", "double")
    beyond = grid(inputs, "displacement_mm", 2)
    codes, turns = compiled_header.answers("inverse", beyond)
    for end, query in ((0, inputs.displacement_mm[0]), (1, inputs.displacement_mm[1])):
        is_held = (codes == HELD) & (beyond[:, 0] == query)
        assert is_held.any()
        assert (turns[is_held] == inputs.motor_turns[end]).all()


@pytest.mark.parametrize(("name", "kind"), [("spline", "one"), ("spline", "campaign"), ("cinn", "one"), ("mlp", "one")])
def test_the_header_says_its_size_and_a_spline_fits_a_microcontroller(
    source: Any, program: Any, name: str, kind: str
) -> None:
    size = int(re.search(r"Constant data: (\d+) bytes", header(source(name, kind), "tsa"))[1])  # type: ignore[index]
    assert size == program(name, kind, "float").bytes()
    if name == "spline":
        assert size <= 4096 and program(name, kind, "double").bytes() <= 8192


@pytest.mark.parametrize("name", ["spline", "cinn", "inn", "mlp", "polynomial", "calibrated"])
def test_no_compiler_complains(source: Any, tmp_path: Any, name: str) -> None:
    """C99 and C++17 in both precisions, as two headers in one file."""
    need("gcc", "g++")
    kind = "campaign" if name in ("spline", "polynomial") else "one"
    for prefix in ("tsa", "left_arm"):
        (tmp_path / f"{prefix}.h").write_text(header(source(name, kind), prefix))
    text = '#include "tsa.h"\n#include "left_arm.h"\nint main(void) { return TSA_OK + LEFT_ARM_OK; }\n'
    for ending, compiler in ((".c", C99), (".cpp", ("g++", "-std=c++17", *WARNINGS))):
        (tmp_path / f"both{ending}").write_text(text)
        built(*compiler, "-fsyntax-only", tmp_path / f"both{ending}")
    double = [word for word in C99 if word != "-Wdouble-promotion"]
    built(*double, "-fsyntax-only", "-DTSA_REAL=double", "-DLEFT_ARM_REAL=double", tmp_path / "both.c")


def test_the_limit_of_strokes_is_the_users_to_set(source: Any, tmp_path: Any) -> None:
    model = source("calibrated", "one")
    compiled_header = compiled(model, tmp_path, options=("-O1", "-DTSA_STROKE_MAX=3"))
    query = middle(model.inputs, "motor_turns")
    rows = np.tile(query, (2, 1))
    rows[:, 1] = (3.0, 4.0)
    assert compiled_header.answers("forward", rows)[0].tolist() == [0.0, CODES.index("stroke") + 1.0]


def test_the_example_loop_runs(source: Any, tmp_path: Any) -> None:
    need("gcc")
    example = (ROOT / "examples" / "control_loop.c").read_text()

    def loop_output(name: str, kind: str, text: str) -> str:
        (tmp_path / "tsa.h").write_text(header(source(name, kind), "tsa"))
        (tmp_path / "loop.c").write_text(text)
        built(*C99, "-O1", "-I", tmp_path, tmp_path / "loop.c", "-o", tmp_path / "loop", "-lm")
        return subprocess.run([tmp_path / "loop"], capture_output=True, text=True, check=True).stdout

    def with_load(load: str) -> str:
        begin = "tsa_state state = tsa_start();"
        assert begin in example
        return example.replace(begin, f"{begin} state.load_n = {load};")

    for name, kind in (("spline", "one"), ("cinn", "one"), ("spline", "campaign")):
        lines = loop_output(name, kind, example)
        assert re.search(r"^ 500 ms: \S+ mm → \S+ turns$", lines, re.MULTILINE), "the target stands beside the twist"
        assert "turns" in lines and "nan" not in lines.lower()
        assert re.search(
            r"ms: \S+ mm refused, TSA_BAD_DISPLACEMENT_MM:", lines
        )  # past the end of the range, and only there
        assert " 0 of 3000 targets ask" not in f" {lines}", "no double negation"
        if "not recorded" not in lines:
            assert re.search(r"^all [0-9]+ answered targets ask for a twist that was recorded with", lines, re.M)
        words = lines.splitlines()[-1].split()  # "273 of 3000 targets refused, 273 of them ..., on purpose"
        assert 0 < int(words[0]) < 500 and words[5] == words[0] and lines.endswith("range, on purpose\n")
        sent = [float(turns) for turns in re.findall(r"mm(?: →|: it stays at) (\S+) turns$", lines, re.MULTILINE)]
        assert len(sent) == 6 and min(sent) >= 0.0, "it was sent to -0.2 turns: wound backwards"
    assert "load_n" in source("spline", "campaign").inputs.names
    lines = loop_output("spline", "campaign", with_load("TSA_LOAD_N_MAX"))
    words = lines.splitlines()[-2].split()  # "2677 of 3000 targets ask for a twist that was not recorded ..."
    assert "stroke 1 was not recorded under 32.9 N (recorded: load_n 19." in lines and 0 < int(words[0]) < 3000, lines
    lines = loop_output("spline", "campaign", with_load("0"))
    assert (
        re.search(r"^   0 ms: \S+ mm refused, TSA_BAD_LOAD_N:", lines, re.MULTILINE)
        and "3000 of 3000 targets refused, " in lines
    )


def test_a_bin_without_rise_gives_no_nan(source: Any, tmp_path: Any) -> None:
    """A rise that single precision loses beside the value, at the ends of the range where a share is exactly 0 or 1."""
    model = source("spline", "one")
    flat = copy.deepcopy(model.model)
    bins = flat.settings.bins
    flat.weights[[1, bins], 0] = -40.0
    compiled_header = compiled(replace(model, model=flat), tmp_path)
    for way, column in GIVEN.items():
        assert np.isfinite(compiled_header.answers(way, grid(model.inputs, column, 101))[1]).all()
