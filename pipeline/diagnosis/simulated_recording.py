"""The recorded motion of a run with its simulated reading: after the runs before it, homed anew if asked."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from ..ground.kinematics import Array
from .document.content import Simulated
from .fit.problem import Problem
from .prediction.carried_over import CarriedOver, carried_over
from .prediction.later_run import before_of, predicted_after, simulated_before
from .recording.recorded_run import RecordedRun
from .simulator import Simulator
from .study.engine import make_problem
from .study.own_rate import at_own_rate


@dataclass(frozen=True)
class SimulatedRecording:
    """One recorded run, and what simulates it; `home`: the motor's zero is found anew on its first stroke.

    `beside`: the other recordings that were diagnosed together with it; None where they lie beside its folder.
    """

    recorded: RecordedRun
    asked: Simulator
    home: bool = False
    beside: Sequence[RecordedRun] | None = None

    @cached_property
    def problem(self) -> Problem:
        """The run at its own rate, to be simulated."""
        return at_own_rate([self.recorded], thin=False, to_fit=False)

    @cached_property
    def carried(self) -> CarriedOver | None:
        """The part of the simulator that is used for this recording, its motor homed; None unless asked for.

        Raises BadInput for a rig that cannot be homed, or a recording without a stroke for it.
        """
        if not self.home:
            return None
        coarse = make_problem([self.recorded], to_fit=False)
        return carried_over(self.problem, self.asked.content, self.asked.source, self.recorded.run.run, coarse)

    @cached_property
    def simulator(self) -> Simulator:
        """The acting simulator: the one that was asked for, or the part of it that holds for this recording."""
        return self.asked.with_content(self.carried.content) if self.carried else self.asked

    @cached_property
    def before(self) -> Sequence[RecordedRun]:
        """The runs before it that were diagnosed together with it; none unless all of them are at hand."""
        content, run = self.simulator.content, self.recorded.run.run
        if self.beside is None:
            return simulated_before(content, run, self.recorded.place)
        return before_of(content, run, self.beside)

    @cached_property
    def predicted(self) -> Array:
        """The reading, of shape (samples,) in the channel's unit; raises BadInput where there is no number."""
        return self._predicted_by(self.simulator.content)

    @cached_property
    def without_effects(self) -> Array | None:
        """The reading with the same dimensions if no effect acted; None if none does.

        Shape (samples,), in the channel's unit.
        """
        content = self.simulator.content
        bare: Simulated = {**content, "simulation": []}
        return self._predicted_by(bare) if content["simulation"] else None

    def _predicted_by(self, content: Simulated) -> Array:
        return predicted_after(self.before, self.recorded, self.problem, content, self.simulator.source)
