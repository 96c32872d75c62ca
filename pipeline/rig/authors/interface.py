"""What is asked of an author of concealed physics, and what the author gives back."""

from dataclasses import dataclass
from typing import Any, Literal

import pandas as pd

Protocol = Literal["rich", "usual", "poor"]
PROTOCOLS: tuple[Protocol, ...] = ("rich", "usual", "poor")


class OutOfReach(Exception):
    """The motion and the rig that the seed drew cannot show an effect of the size that was asked."""


@dataclass(frozen=True)
class Asked:
    """One recording to make: from which seed, with which effects, how large, on which protocol.

    `kappas` has one size for each effect: its rms in noise floors after bounded recalibration.
    """

    seed: int
    effects: tuple[str, ...]
    kappas: tuple[float, ...]
    protocol: Protocol

    def __post_init__(self) -> None:
        if len(self.effects) != len(self.kappas):
            raise ValueError(f"{len(self.effects)} effects and {len(self.kappas)} sizes; give one size for each effect")
        if len(set(self.effects)) != len(self.effects):
            raise ValueError("an effect is asked twice; ask for each effect once")
        if not all(0.0 < kappa < float("inf") for kappa in self.kappas):
            raise ValueError("a size is not above 0; give sizes in noise floors")
        if self.protocol not in PROTOCOLS:
            raise ValueError(f"the protocol is {self.protocol!r}; use one of {', '.join(PROTOCOLS)}")


@dataclass(frozen=True)
class Made:
    """One recording: the content of its run.yaml without `run`, its table, and the answer that stays sealed.

    `truth` holds `effects`, a list with one entry for each effect asked, in that order: `id`, `law`, `parameters`,
    `rms_mm` (of the effect on the reading), `kappa` (reached); and `noise_floor_mm` and `heldout_noise_mm`.
    """

    content: dict[str, Any]
    table: pd.DataFrame
    truth: dict[str, Any]
