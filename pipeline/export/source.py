"""A saved model for the exporters: loaded, with its inputs, and refused in one line where it cannot be exported."""

import os
from dataclasses import dataclass, replace
from functools import cache, partial
from pathlib import Path
from typing import Any, cast

import numpy as np

from ..ground.command import INSTALLED
from ..ground.errors import BadInput
from ..ground.stored import schemas
from ..ground.stored.given_table import opened as opened_table
from ..ground.words.jump_notes import NAME, beside_exports
from ..models.interface import Model, StringsApart, about, make_model
from ..models.interface import names as models_there
from ..models.parts.box import Box
from ..models.parts.divided import SPLITS, divided
from ..models.parts.fitted_to import Apart, apart
from ..models.parts.inside.assumed_stiffness import is_never_measured
from ..models.parts.inside.recorded_loads import loads_of
from ..models.parts.inside.recorded_strokes import Under
from ..models.parts.saved import read_bytes
from ..models.parts.saved_files import MODEL_FILE, dataset_beside, fit_command, in_words
from .caveats import zeroed_runs
from .held_out import errors_of
from .inputs import Inputs
from .interface import Source, exporter, names
from .recorded_ranges import pairs_recorded, strokes_foreseen, twists_recorded, values_recorded
from .start_state import start_values
from .trained_on import fitted_to_runs, one_answer_of, trained_on

UNTOLD = "Errors, zero and what was recorded are not told"
TRAIN = "train it first (the main job does)"  # in a checkout
TRIED = 20  # queries that a model must answer before it is exported


@dataclass(frozen=True)
class Beside:
    """Where to look for data that a model's file lacks; None: where the pipeline puts it."""

    dataset: Path | None = None
    split: str | None = None
    string: str | None = None


def opened(file: Path, name: str | None, beside: Beside) -> Source:
    """The model of a file, whose name is its folder's unless given.

    Raises BadInput where the file holds no such model, or a model that cannot be exported.
    """
    if file.is_dir():
        models = in_words(file.parent, names()) or MODEL_FILE
        raise BadInput(file, "model", "is a folder", f"name a file in it, such as {models}")
    name = name or Path(os.path.realpath(file)).parent.name
    models = in_words(file.parent.parent, names())
    if not file.is_file():
        first = f"fit it first: {fit_command(name if name in names() else '')}" if INSTALLED else TRAIN
        mend = f"name one of {models}" if models else f"{first}, or mend the path"
        raise BadInput(file, "model", "is not a file" if file.exists() else "is not there", mend)
    if name not in names():
        mend = f"choose one of {', '.join(names())}{'; fitted are ' * bool(models)}{models}"
        if name not in models_there():
            mend = f"{mend}; if it is one of them in another folder, say which by --model NAME"
        raise BadInput(file, "model", f'"{name}" cannot be exported', mend)
    if not read_bytes(file):
        raise BadInput(file, "model", "is empty: its split had too few strokes", "take another split's model")
    try:
        source = _loaded(file, name, beside)
        _try(source)
        source = replace(source, deaf=_deaf(source))
    except (BadInput, ModuleNotFoundError):  # such as torch, which is left to choose where twistbench is installed
        raise
    except Exception as error:  # whatever a file that is no such model makes its loaders stumble over
        what = f"is not a saved {name} ({type(error).__name__})"
        raise BadInput(file, "model", what, "train it again, or say --model") from error
    return source


def strings_apart(file: Path, name: str | None) -> list[str]:
    """The strings that a file's model keeps apart, each with its own export; none for any other model or file."""
    name = name or Path(os.path.realpath(file)).parent.name
    if name not in names() or not about(name).each_string_apart or not file.is_file():
        return []
    model: Any = make_model(name)
    try:
        model.load(file)
    except Exception:  # `opened` says what is wrong with the file
        return []
    return sorted(model.moves)


def _loaded(file: Path, name: str, beside: Beside) -> Source:
    """The model of a file; raises BadInput if it cannot be exported, and any error for another file."""
    model: Any = make_model(name)
    model.load(file)
    dataset = dataset_of(file, beside)
    older, box, zero_mm = apart(file, dataset), getattr(model, "box", None), 0.0
    if box is None:
        box, zero_mm = _box_of_dataset(file, name, model, beside, older)
    conditions = getattr(model, "conditions", None)
    try:
        varying = (conditions.names, conditions.materials) if conditions else ((), ())
        inputs = Inputs.of(box, exporter(name).READS, *varying)
    except ValueError as error:
        raise BadInput(file, "model", f"was trained on {error}", "train one model for each kind") from error
    string = beside.string or (next(iter(model.moves)) if about(name).each_string_apart else "")
    errors = cache(partial(errors_of, file, name, model, dataset, string or None))
    source = Source(name, model, inputs, zero_mm, string, on_unseen=errors)
    if older:
        trained = fitted_to_runs(dataset, older.fitted_runs)
        return replace(source, trained=trained, older=f"{UNTOLD}, for {older.sentence}")
    last, foreseen = inputs.last_stroke, strokes_foreseen(dataset, string)
    points, trained = twists_recorded(dataset, last, string), trained_on(dataset, last, string)
    inputs = replace(inputs, never_measured=len(points) > 0 and is_never_measured(points))
    alike = "" if string else one_answer_of(dataset, last)
    return replace(
        source,
        inputs=inputs,
        zeroed=zeroed_runs(dataset, string),
        jumped=beside_exports(dataset.with_name(NAME), string) if len(points) else "",
        values=values_recorded(points),
        foreseen=foreseen,
        pairs=pairs_recorded(points),
        loads=loads_of(points) if len(points) else (),
        under=Under.of(points, foreseen[1]) if foreseen else None,
        trained=" ".join(filter(None, (trained, alike))),
        start=start_values(dataset, inputs, string),
    )


def _try(source: Source) -> None:
    """Ask a model both ways within its ranges; passes errors on, and raises ValueError if an answer is no number."""
    rng = np.random.default_rng(0)
    for ask, from_column in ((source.model.forward, "motor_turns"), (source.model.inverse, "displacement_mm")):
        if not np.isfinite(ask(source.inputs.points(from_column, source.inputs.drawn(from_column, TRIED, rng)))).all():
            raise ValueError("an answer is not a number")


def _deaf(source: Source) -> tuple[str, ...]:
    """Which of stroke and direction no answer depends on, among queries within the ranges."""
    inputs, rng, deaf = source.inputs, np.random.default_rng(0), []
    for field in inputs.fields[:2]:
        answers = []
        for ask, from_column in ((source.model.forward, "motor_turns"), (source.model.inverse, "displacement_mm")):
            queries, column = inputs.drawn(from_column, TRIED, rng), 1 + inputs.names.index(field.name)
            for end in (field.low, field.high):
                queries[:, column] = end
                answers.append(np.asarray(ask(inputs.points(from_column, queries)), float))
        same = np.array_equal(answers[0], answers[1]) and np.array_equal(answers[2], answers[3])
        deaf += [field.name] * (same and field.low < field.high)
    return tuple(deaf)


def dataset_of(file: Path, beside: Beside) -> Path:
    """The dataset that a model was fitted to: the one that is named, or where the pipeline puts it."""
    return beside.dataset or dataset_beside(file)


def _box_of_dataset(file: Path, name: str, model: Model, beside: Beside, older: Apart | None) -> tuple[Box, float]:
    """The box of a model without one: that of its training points; and the zero of its own string, in mm.

    The points of an `older` model are those of its runs, where the dataset has them as they were.
    """
    path = dataset_of(file, beside)
    split = beside.split or file.name.split("-")[0]
    if not path.is_file():
        raise BadInput(file, "ranges", f"a {name} keeps none and there is no {path}", "say --dataset FILE")
    if older and not older.has_grown:
        raise BadInput(file, "ranges", f"a {name} keeps none, and it {older.problem}", older.mend)
    if split not in (*SPLITS, "all"):
        raise BadInput(file, "split", f'"{split}" is none', f"say --split {' or --split '.join(SPLITS)}")
    table = opened_table(path, schemas.DATASET, "say --dataset FILE")
    points = table if split == "all" else divided(table, split, path)[0]
    points = points[points["run"].astype(str).isin(older.same)] if older else points
    if points.empty:
        raise BadInput(path, split, "has no points: the strings have too few strokes", "say --split with another")
    if not about(name).each_string_apart:
        points = points[points["string"].astype(str) == beside.string] if beside.string else points
        if points["actuator"].nunique() > 1:  # of which the models that keep no ranges know nothing
            problem = "was trained on strings with and without separator in one model"
            raise BadInput(file, "model", problem, "train one model for each kind")
        return Box.of(points), 0.0
    moves = cast(StringsApart, model).moves
    strings = sorted(moves)
    string = beside.string or (strings[0] if len(strings) == 1 else "")
    if string not in strings:
        problem = f'"{string}" is not among them' if string else "it knows more than one"
        raise BadInput(file, "string", problem, f"say --string with one of {', '.join(strings)}")
    move = dict(moves[string])
    zero_mm = move.pop("zero_mm")
    points = points[points["string"].astype(str) == string]
    if points.empty:
        raise BadInput(path, "string", f"has no points of {string}", "say --dataset with the one it was fitted on")
    return Box.of(points.assign(**{column: points[column] + by for column, by in move.items()})), zero_mm
