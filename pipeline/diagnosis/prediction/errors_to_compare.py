"""The numbers to compare an error on a recording with: the noise, and the diagnosis' error on unseen strokes."""

import math
from dataclasses import dataclass
from typing import Any

from ..document.content import Verdict
from ..fit.adopt import is_number


@dataclass(frozen=True)
class ToCompare:
    """The errors that a diagnosis states, rms, in the reading's unit; None where its file lacks one.

    `noise` is that of the readings as `simulate` compares them, `unseen` the error on strokes that no fit had seen.
    `runs` are the runs of the diagnosis.
    """

    noise: float | None
    unseen: float | None
    runs: tuple[str, ...]

    @classmethod
    def of(cls, content: Verdict, ending: str) -> "ToCompare":
        """The errors of a diagnosis; `ending` is that of its keys."""
        fit, evidence = _part(content, "fit"), _part(content, "evidence")
        floor, single = (
            _size(where, name) for where, name in ((fit, f"noise_floor_{ending}"), (evidence, f"single_floor_{ending}"))
        )
        unseen = _size(_part(fit, "heldout"), f"explained_{ending}")
        if floor and single and unseen:  # that was an error of averages, and single readings have more noise
            unseen = math.hypot(math.sqrt(max(unseen**2 - floor**2, 0.0)), single)
        runs = content.get("run", "")
        return cls(floor if single is None else single, unseen, tuple(runs if isinstance(runs, list) else [runs]))

    @property
    def expected(self) -> float | None:
        """The error to expect on another recording of the rig: that on unseen strokes, or the noise if larger."""
        sizes = [size for size in (self.noise, self.unseen) if size is not None]
        return None if self.unseen is None else max(sizes)


def _part(content: Any, key: str) -> dict[str, object]:
    part = content.get(key)
    return part if isinstance(part, dict) else {}


def _size(part: dict[str, object], key: str) -> float | None:
    value: Any = part.get(key)
    return float(value) if is_number(value) and value > 0.0 else None
