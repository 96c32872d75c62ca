"""A diagnosis in memory holds the recordings that it was made of: which of them are beside one, and doubts of it."""

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from ..diagnosis.document.content import Verdict
from ..diagnosis.prediction.later_run import said_of
from ..diagnosis.recording.recorded_run import RecordedRun
from ..diagnosis.simulator import Simulator
from ..diagnosis.simulator_words import of_another
from ..ground.errors import BadInput

RESTORE = (  # the past of a later run, in a notebook
    "simulate with the diagnosis that Diagnosis.of gave, or read runs that lie in one folder, by Recording.read"
)
ADOPTED = "keep the runs in one folder, and read this one by Recording.read"


class Explained(Protocol):
    """What says how a rig is simulated: a diagnosis."""

    @property
    def content(self) -> Verdict:
        """What `diagnosis.json` holds."""

    @property
    def recorded(self) -> Sequence[RecordedRun]:
        """The recordings that it was made of, in their order; none where it was read from a file."""


def beside(own: RecordedRun, diagnosis: Explained | None) -> list[RecordedRun] | None:
    """The other recordings that a diagnosis was made of with a run; None where it holds none, so that folders tell.

    Raises BadInput for a run that has the name of another recording of the diagnosis.
    """
    if diagnosis is None or not diagnosis.recorded:
        return None
    name = own.run.run
    namesakes = [each for each in diagnosis.recorded if each.run.run == name]
    if namesakes and not _alike(own, namesakes[0]):
        problem = f"was made of another recording that is called {name} too"
        mend = f"give this recording a name of its own: run, in its description, in place of {name}"
        raise BadInput("Recording.simulate", "diagnosis", problem, mend)
    return [each for each in diagnosis.recorded if each not in namesakes] if namesakes else []


def _alike(own: RecordedRun, other: RecordedRun) -> bool:
    """Whether two recordings hold the same samples."""
    mine, others = own.samples, other.samples
    return mine.shape == others.shape and list(mine) == list(others) and np.allclose(mine, others, atol=1e-9)


def doubts(
    own: RecordedRun, before: Sequence[RecordedRun], simulator: Simulator, diagnosis: Explained | None
) -> list[str]:
    """What must be known of a run that is simulated after those `before`: it lacks its past, or is of another rig."""
    source, mend = ("what it has adopted", ADOPTED) if diagnosis is None else ("the diagnosis", RESTORE)
    words = [] if before else said_of(simulator.content, own.run.run, before, source, mend)
    if diagnosis is None:
        return words
    return [*words, *of_another(simulator, own.run, own.place, [each.run for each in diagnosis.recorded])]
