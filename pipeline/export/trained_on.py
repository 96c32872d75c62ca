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
    named = ", ".join(runs[:SHOWN]) + (f" and {len(runs) - SHOWN} more" if len(runs) > SHOWN else "")
    folder = dataset.resolve().parent
    processed = folder.parent.name == "processed"
    material = f" of material {folder.name}" if processed else ""
    turns = points["motor_turns"]
    span = f"{counted(count, 'stroke')}, twists {turns.min():.4g} to {turns.max():.4g} turns"
    words = f"Fitted to points of run{'s' * (len(runs) > 1)} {named}{material}: {span}."
    made_up = processed and (folder.name == SYNTHETIC or _of_the_synthetic_rig(folder.parents[1] / "raw", runs))
    return f"{words} {NO_STRING}" if made_up else words


def one_answer_of(dataset: Path, last_stroke: int) -> str:
    """The strings of a dataset that a model with their sizes cannot tell apart; empty where it can."""
    points = points_to(dataset, last_stroke, ["string", *SIZES])
    groups = dict.fromkeys(strings_alike(points).values()) if len(points) else {}
    return " ".join(f"Strings {strings}{ALIKE}" for strings in groups)


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
