"""The simulator of a run: a diagnosis that a person gives, or what the run's own run.yaml has adopted."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import cast

from ..run.description import Run
from .document.content import Simulated, Verdict
from .fit.adopt import checked
from .prediction.later_run import adopted_by
from .prediction.prediction_band import adopted_diagnosis
from .prediction.simulation import read_diagnosis
from .prediction.without_a_name import to_simulate
from .words.language.quantity import listing


@dataclass(frozen=True)
class Simulator:
    """Effects and dimensions that act in a run, and where they are from.

    `content` holds them, from the file `source`. `given`: the diagnosis that a person gave; None where they are what
    run.yaml has adopted.
    """

    content: Simulated
    source: Path
    given: Verdict | None = None

    @classmethod
    def of(cls, run: Run, source: Path, diagnosis: Verdict | None = None) -> "Simulator":
        """The simulator of a run: the diagnosis that is given, or what its run.yaml has adopted.

        Raises BadInput for an effect that is none of the library's.
        """
        content = adopted_by(run) if diagnosis is None else to_simulate(diagnosis, run.run)
        for number, entry in enumerate(content["simulation"]):
            checked(entry, f"simulation[{number}]", str(source))
        return cls(content, source, diagnosis)

    @classmethod
    def read(cls, run: Run, folder: Path, file: Path | None) -> "Simulator":
        """As `of`, of a diagnosis in a file, or of the run.yaml in the run's folder; raises BadInput."""
        return cls.of(run, file, read_diagnosis(file)) if file else cls.of(run, folder / "run.yaml")

    def with_content(self, content: Simulated) -> "Simulator":
        """The same simulator with other effects or dimensions, as far as they hold for another recording."""
        return replace(self, content=content)

    def diagnosis(self, run: Run) -> tuple[Path, Verdict | None]:
        """The file of the diagnosis that the simulator is from, and its content; None where it is gone.

        Raises BadInput for a file that is no diagnosis.
        """
        return (self.source, cast(Verdict, self.content)) if self.given is not None else adopted_diagnosis(run)

    @property
    def acting(self) -> str:
        """The mechanisms that act, as a sentence names them."""
        return listing(list(dict.fromkeys(entry["id"] for entry in self.content["simulation"]))) or "no mechanism"
