"""The folder of a made run: its name, its description, waiting for it, and its recording."""

import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from ..capture.commit import recover
from ..capture.log import NAME, in_use
from ..foreign.made_run import make_run
from ..ground.errors import BadInput
from ..ground.input.strict_yaml import read_yaml
from ..run.copied_run import as_in, with_given
from ..run.ended_words import PERSON, ending
from ..run.folder import CAPTURED, RECORDINGS, capture_info, unfinished
from ..run.run_yaml import RunYaml
from .step import Step

DESCRIBED = "run.yaml"
LEAST_SAMPLES = 200  # of a recording that was cut short, to be of use
LOOKS_S = 0.5


def free_dir(first: Path, like: Path) -> Path:
    """A free run folder beside the first one; an empty one of an earlier proposal is removed."""
    number = 1
    while (folder := first.parent / f"{first.name}-s{number}").exists():
        if _is_left_empty(folder, like):
            (folder / DESCRIBED).unlink()
            folder.rmdir()
            break
        number += 1
    return folder


def _is_left_empty(folder: Path, like: Path) -> bool:
    """Whether a folder holds only a run.yaml that this program wrote, whatever its load."""
    if not folder.is_dir() or [path.name for path in folder.iterdir()] != [DESCRIBED]:
        return False
    with suppress(BadInput):
        would_be = with_given(as_in(like), {"run": folder.name}, like)
        return _but_load(read_yaml(folder / DESCRIBED)) == _but_load(would_be)
    return False


def _but_load(content: RunYaml) -> RunYaml:
    return {**content, "rig": {key: value for key, value in (content.get("rig") or {}).items() if key != "load_n"}}


def waits_for_a_person(step: Step, makes: str) -> bool:
    """Whether a run that a person makes (`makes`) has not begun yet."""
    return step.state == "approved" and step.approved_by == makes and not begun(Path(step.run_dir or ""))


def describe(folder: Path, first: Path, step: Step) -> None:
    """Make the run's folder with a run.yaml like the first one's, unless it is there.

    A load that run.yaml gives, since nothing measures it, is that of the step's motion where it moves under one load.
    """
    if (folder / DESCRIBED).exists():
        return
    like = as_in(first)
    own: RunYaml = {"run": folder.name}
    if "load_n" in like.get("rig", {}) and len(step.loads_n) == 1:
        own["rig"] = {"load_n": step.loads_n[0]}
    make_run(with_given(like, own, first), None, folder.parent, material_known=True)


def begun(folder: Path) -> bool:
    """Whether something was recorded into a run's folder, to its end or not."""
    return any((folder / name).is_file() for name in (*RECORDINGS, *CAPTURED))


def mended(folder: Path) -> bool:
    """Repair a run that an earlier start of this program left unfinished; False where the rig had not moved yet.

    The capture writes HELLO before it says START. Raises BadInput where a program still records there.
    """
    path = folder / NAME
    if not unfinished(folder):
        return True
    if path.is_file() and path.stat().st_size == 0 and not in_use(path):
        return False
    recover(folder)
    return True


def wait_for(folder: Path, stopped: Callable[[], bool]) -> bool:
    """Wait until a person has recorded a run; False where somebody stopped the loop before."""
    while not begun(folder) or unfinished(folder):
        if stopped():
            return False
        time.sleep(LOOKS_S)
    return True


def came(step: Step) -> tuple[Step, bool]:
    """The step with the end of its recording, and whether a person ended it."""
    info = capture_info(Path(step.run_dir or ""))
    status = info.get("exit_status", "complete")
    if status == "complete":
        return step.at("recorded"), False
    samples = int((info.get("samples") or {}).get("received", 0))
    ended = info.get("fault") or ending(info)
    return step.at("recorded", ended=ended, used=samples >= LEAST_SAMPLES), info.get("ended_by") == PERSON
