"""The rig at a port with a person's limits: its present limits for programs, and recording of a program."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from ..capture.handshake import greet
from ..capture.motion_program import as_legs
from ..capture.port import Port
from ..capture.session import capture
from ..ground.errors import BadInput
from ..wire.motion import Limits
from .limits import FREE, Allowed, beyond
from .step import Place, Step

LONGER, AND_S = 2.0, 60.0  # than its legs take: then a recording is ended


@dataclass(frozen=True)
class Motor:
    """`port` is None where a person moves the rig; with `all_limits` nothing moves until every limit is given."""

    port: str | None
    baud: int
    allowed: Allowed
    all_limits: bool

    def takes(self) -> Limits | None:
        """The rig's present limits for programs; None if it takes none.

        Raises BadInput if there is no rig, or a limit lacks. It asks the device each time: where the motor stands is in
        its answer.
        """
        if not self.port:
            return None
        with Port(self.port, self.baud) as port:
            limits = greet(port, self.port, self.baud)[0].program
        if limits is not None and self.all_limits:
            self.allowed.check_unattended(limits)
        return limits

    def limits(self) -> Limits | None:
        """What rig and person both allow."""
        rig = self.takes()
        return self.allowed.within(rig) if rig else None

    def bounds(self) -> Limits | None:
        """The limits of every proposed run; for a rig that takes no program, a person's own ones, if any."""
        limits = self.limits()
        return self.allowed.within(FREE) if limits is None and self.allowed.given else limits

    def follow(self, step: Step, place: Place, stopped: Callable[[], bool]) -> None:
        """Make an approved run and record it; raises BadInput where the present limits forbid it."""
        why = beyond(as_legs(step.legs), self.limits())
        if why is not None:
            mend = f"widen --limits if that is safe, or remove {place.folder(step.number)} to have another proposed"
            raise BadInput(step.run_dir or "", "approved run", why, mend)
        longest_s = LONGER * step.seconds + AND_S
        capture(self.port or "", Path(step.run_dir or ""), self.baud, longest_s, as_legs(step.legs), stopped)
