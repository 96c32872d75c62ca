"""A diagnosis in memory: the verdict, what explains the mismatch with its intervals, what ties, and its page."""

from __future__ import annotations

import base64
import html
import io
import json
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from ..diagnosis import written
from ..diagnosis.choice.outcome import Study
from ..diagnosis.document import made_keys
from ..diagnosis.document.content import Verdict, VerdictWord
from ..diagnosis.in_memory import Say, diagnosed
from ..diagnosis.numerics.judge import Judge
from ..diagnosis.prediction.simulation import read_diagnosis
from ..diagnosis.recording.recorded_run import RecordedRun
from ..diagnosis.words.pages.details import details_text
from ..diagnosis.words.pages.verdict import verdict_text
from ..ground.errors import BadInput
from ..ground.units import unit_of
from ..string.history import Recorded, in_order
from ..systems import System, systems
from .kind_of_rig import kind_of_rig
from .mechanism import Interval, Mechanism, interval
from .recording import Recording, as_recorded

if TYPE_CHECKING:  # what draws takes 40 MB, and is imported when the search has let go of more
    from matplotlib.figure import Figure

SHOWN_DOTS = 80  # an inch, of the page in a notebook


@dataclass(frozen=True, repr=False)
class Diagnosis:
    """What a diagnosis says. `content` is what `diagnosis.json` holds; the other names give its parts as objects."""

    content: Verdict
    actuator: str
    _found: Study | None = field(default=None, compare=False)
    recorded: tuple[RecordedRun, ...] = field(default=(), compare=False)  # what it was made of; none if it was read

    @classmethod
    def of(
        cls, *recordings: Recording, without: frozenset[str] = frozenset(), say: Callable[[str], None] | None = None
    ) -> Diagnosis:
        """The diagnosis of one recording, or of several of one rig together, in the order of their recording.

        The library lacks the mechanisms whose ids are in `without`. `say` is called with the name of each step as it
        begins: `say=print` shows how far it is. Raises BadInput for recordings that are not of one rig, for two of one
        name, and for one too poor to decide anything.
        """
        if not recordings:
            raise BadInput("Diagnosis.of", "recordings", "are none", "give at least one recording")
        for each in recordings:
            if not isinstance(each, Recording):
                problem = f"are {type(each).__name__}"
                mend = "make each by Recording.read(folder) or Recording.of(table, description); give each by itself"
                raise BadInput("Diagnosis.of", "recordings", problem, mend)
        return diagnosis_of([as_recorded(each) for each in recordings], without, say=say)

    @classmethod
    def read(cls, path: Path | str, actuator: str | None = None) -> Diagnosis:
        """The diagnosis that a `diagnosis.json` holds; it has no page of figures.

        `actuator` is the kind of rig as in `run.yaml`; without it the file tells, by its units and its motion. Raises
        BadInput for a file that is no diagnosis, and for a kind of rig that the file is not about or does not tell.
        """
        content = read_diagnosis(Path(path))
        return cls(content, kind_of_rig(Path(path), content, actuator))

    @property
    def system(self) -> System:
        """The rig that it is about."""
        return systems()[self.actuator]

    @property
    def verdict(self) -> VerdictWord:
        """consistent, parameters, explained, ambiguous or unknown."""
        return self.content["verdict"]

    @cached_property
    def mechanisms(self) -> tuple[Mechanism, ...]:
        """The best explanation: its mechanisms, the largest first; empty where nothing is named."""
        unit = self.system.channel.rpartition("_")[2]
        return tuple(
            Mechanism(
                entry["id"],
                float(entry["confidence"]),
                interval(made_keys.interval(entry, f"rms_{unit}"), unit),
                {name: interval(each) for name, each in entry["parameters"].items()},
                entry["sentence"],
            )
            for entry in self.content["mechanisms"]
        )

    @property
    def alternatives(self) -> tuple[tuple[str, ...], ...]:
        """Every other explanation that the recording cannot rule out, each the names of its mechanisms."""
        return tuple(tuple(ids) for ids in self.content["alternatives"])

    @cached_property
    def parameters(self) -> dict[str, Interval]:
        """The rig's dimensions as calibrated, by name, each in the unit that its name ends with."""
        return {name: interval(entry, unit_of(name)) for name, entry in self.content["parameters"].items()}

    @property
    def words(self) -> str:
        """The verdict on one page, as `verdict.txt` has it."""
        return verdict_text(self.content, self.system, self._folders)

    @property
    def details(self) -> str:
        """All that the verdict stands on, in words, as `details.txt` has it."""
        return details_text(self.content, self.system, self._folders)

    @property
    def _folders(self) -> list[Path]:
        runs = self.content["run"]
        return [Path("raw", run) for run in ([runs] if isinstance(runs, str) else runs)]

    def figure(self) -> Figure:
        """The page of figures: recording over simulation, maps of the mismatch, explanations, error on unseen strokes.

        Raises BadInput for a diagnosis that was read from a file: it holds no recording.
        """
        from ..diagnosis.drawing import figures

        return figures.drawn(study_of(self), self.content)

    def to_json(self) -> str:
        """It as `diagnosis.json` holds it."""
        return json.dumps(self.content, indent=1, ensure_ascii=False) + "\n"

    def save(self, folder: Path | str) -> Path:
        """Write what the program writes, each file whole: json, words, what can be adopted; if made here, figures.

        What an earlier diagnosis wrote there is replaced. Returns the folder.
        """
        folder = Path(folder)
        if self._found is not None:
            written.draw(self._found, self.content, folder / "diagnosis")
        written.write_block(self.content, self.system, folder)
        written.write_words(self.content, self.system, self._folders, folder, [])
        return folder

    def __repr__(self) -> str:
        named = " + ".join(mechanism.id for mechanism in self.mechanisms) or "nothing named"
        ties = f", or {len(self.alternatives)} more" if self.alternatives else ""
        return f"<Diagnosis of {self.content['run']}: {self.verdict}; {named}{ties}>"

    def _repr_html_(self) -> str:
        """What a notebook shows: the verdict in words, and the page."""
        shown = f"<pre style='white-space: pre-wrap'>{html.escape(self.words)}</pre>"
        if self._found is None:
            return shown
        from matplotlib.backends.backend_agg import FigureCanvasAgg

        drawn = io.BytesIO()
        page = self.figure()
        page.set_dpi(SHOWN_DOTS)
        FigureCanvasAgg(page).print_png(drawn)
        picture = base64.b64encode(drawn.getvalue()).decode()
        return f"{shown}<img alt='the page of figures' src='data:image/png;base64,{picture}'>"


def diagnosis_of(
    recorded_runs: list[Recorded],
    without: frozenset[str] = frozenset(),
    by: Judge | None = None,
    say: Say | None = None,
) -> Diagnosis:
    """As `Diagnosis.of`, of runs as the stages know them; `by` judges in place of the library's judge.

    `say` is told each step. Raises BadInput as `Diagnosis.of` does.
    """
    ordered = in_order(recorded_runs)
    names = [each.run.run for each in ordered]
    if twice := [name for name in names if names.count(name) > 1]:
        mend = "give each a name of its own: run, in its description or its run.yaml"
        raise BadInput("Diagnosis.of", "recordings", f"{len(twice)} have one name, {twice[0]}", mend)
    recorded = [RecordedRun(each.run, each.table, each.strokes, each.folder) for each in ordered]
    content, study = diagnosed(recorded, without, by, say or (lambda _: None))
    if len(ordered) > 1:
        content["run"] = names
    return Diagnosis(content, ordered[0].run.actuator, study, tuple(recorded))


def study_of(diagnosis: Diagnosis) -> Study:
    """What a diagnosis was made from; raises BadInput for one that was read from a file: it holds no recording."""
    if diagnosis._found is None:
        problem = "is not there: this diagnosis was read from a file"
        raise BadInput("diagnosis", "recording", problem, "diagnose the recording: Diagnosis.of(recording)")
    return diagnosis._found
