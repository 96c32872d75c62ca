"""Which recordings a model was fitted to, in a sentence, and whether they are of the project's synthetic rig."""

import json
from collections.abc import Sequence
from pathlib import Path

from ..ground.errors import BadInput
from ..ground.names import SYNTHETIC, SYNTHETIC_DEVICE
from ..ground.stored.regular_file import read_regular
from ..ground.words.counts import counted
from ..models.parts.box import SIZES
from ..models.parts.questions.strings_alike import strings_alike
from ..models.parts.saved_files import RAW, material_of
from .recorded_ranges import points_to

SHOWN = 3  # runs that are named
LARGEST = 10_000_000  # bytes of a capture.json
ALIKE = " are of the same sizes and have one answer, that of all of them together."
NO_STRING = "They are of twistbench's synthetic rig: a simulation, and no real string. Do not drive a real rig by this."


def trained_on(dataset: Path, last_stroke: int, string: str = "") -> str:
    """The runs and the material that a dataset's points up to a stroke are of, of one string if it is named.

    Empty where no dataset is there.
    """
    points = points_to(dataset, last_stroke, ["run", "string", "motor_turns"], string)
    if not len(points):
        return ""
    runs = list(dict.fromkeys(points["run"].astype(str)))
    count = len(points[["string", "stroke"]].drop_duplicates())
    turns = points["motor_turns"]
    span = f"{counted(count, 'stroke')}, twists {turns.min():.4g} to {turns.max():.4g} turns"
    return _with_rig(f"Fitted to points of {_in_words(runs)}{_material(dataset)}: {span}.", dataset, runs)


def fitted_to_runs(dataset: Path, runs: Sequence[str]) -> str:
    """The runs that a model was fitted to whatever points its dataset has now, and whether they are of no real rig."""
    return _with_rig(f"Fitted to points of {_in_words(runs)}{_material(dataset)}.", dataset, runs)


def one_answer_of(dataset: Path, last_stroke: int) -> str:
    """The strings of a dataset that a model with their sizes cannot tell apart; empty where it can."""
    points = points_to(dataset, last_stroke, ["string", *SIZES])
    groups = dict.fromkeys(strings_alike(points).values()) if len(points) else {}
    return " ".join(f"Strings {strings}{ALIKE}" for strings in groups)


def _in_words(runs: Sequence[str]) -> str:
    """The first runs by name, and how many more."""
    more = f" and {len(runs) - SHOWN} more" if len(runs) > SHOWN else ""
    return f"run{'s' * (len(runs) > 1)} {', '.join(runs[:SHOWN])}{more}"


def _material(dataset: Path) -> str:
    """Of which material a dataset at the main job's place is; empty for any other."""
    material = material_of(dataset)
    return f" of material {material}" if material else ""


def _with_rig(words: str, dataset: Path, runs: Sequence[str]) -> str:
    """The words, with a warning where the runs of a dataset are of the synthetic rig.

    They are looked for in the `raw/` beside a `processed/` that it lies in, else in that of the current folder.
    """
    folder = dataset.resolve().parent
    raw = folder.parents[1] / RAW if material_of(dataset) else RAW
    made_up = folder.name == SYNTHETIC or _of_the_synthetic_rig(raw, runs)
    return f"{words} {NO_STRING}" if made_up else words


def _of_the_synthetic_rig(raw: Path, runs: Sequence[str]) -> bool:
    """Whether a run was recorded from the synthetic rig, by what the device called itself."""
    for run in runs:
        try:
            said_hello = json.loads(read_regular(raw / run / "capture.json", LARGEST))["hello"]["device"]
        except (BadInput, ValueError, KeyError, TypeError, RecursionError):
            continue
        if said_hello == SYNTHETIC_DEVICE:
            return True
    return False
