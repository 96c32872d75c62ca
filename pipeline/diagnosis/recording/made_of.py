"""The recordings that a diagnosis was made of: the run's own, and those that lie beside it."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from ...ground.errors import BadInput
from ...ground.input.complaint import key_name, short
from ...ground.names import RUN_NAME
from ...run.folder import has_recording
from ...run.samples import read_strokes
from ..document.content import Verdict
from .recorded_run import RecordedRun


def recordings_of(
    content: Verdict, place: Path, folder: Path, read_already: Sequence[RecordedRun] = ()
) -> list[RecordedRun]:
    """The recordings that a diagnosis at `place` was made of, in its order: of a run in `folder`, or beside it.

    Those of `read_already` are not read again. Raises BadInput for a diagnosis that names no run, and for a
    recording that is not there.
    """
    together = content.get("run", "")
    names = together if isinstance(together, list) else [together]
    run_by_folder = {each.folder.resolve(): each for each in read_already if each.folder}
    recorded = []
    for name in names:
        if not isinstance(name, str) or not RUN_NAME.fullmatch(name):
            raise BadInput(place, "run", f"is {short(name)}, no run", "give a diagnosis.json as it was made")
        own = folder.resolve()
        made_of = own if own.name == name else own.parent / name
        if not has_recording(made_of):
            problem = f"names {key_name(name)}, whose recording is not at {made_of}"
            raise BadInput(place, "run", problem, "put that run's folder beside the one that is simulated")
        read_before = run_by_folder.get(made_of.resolve())
        recorded.append(
            replace(read_before, folder=made_of) if read_before else RecordedRun(*read_strokes(made_of), made_of)
        )
    return recorded
