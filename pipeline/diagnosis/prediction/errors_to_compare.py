"""What an error against a recording is to be set beside: the noise, and what a diagnosis missed unseen strokes by."""

import math
from dataclasses import dataclass
from typing import Any

from ..document.content import Verdict
from ..fit.adopt import is_number


@dataclass(frozen=True)
class ToCompare:
    """What a diagnosis says of errors, rms, in the reading's unit; None where its file does not.

    `noise` is that of the readings as `simulate` compares them, `unseen` what strokes that no fit had seen were missed
    by. `runs` are those that it was made of.
    """

    noise: float | None
    unseen: float | None
    runs: tuple[str, ...]

    @classmethod
    def of(cls, content: Verdict, ending: str) -> "ToCompare":
        """What a diagnosis says; `ending` is that of its keys."""
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
        """What to expect of another recording of the same rig: the error on unseen strokes, or the noise if more."""
        sizes = [size for size in (self.noise, self.unseen) if size is not None]
        return None if self.unseen is None else max(sizes)


def _part(content: Any, key: str) -> dict[str, object]:
    part = content.get(key)
    return part if isinstance(part, dict) else {}


def _size(part: dict[str, object], key: str) -> float | None:
    value: Any = part.get(key)
    return float(value) if is_number(value) and value > 0.0 else None
