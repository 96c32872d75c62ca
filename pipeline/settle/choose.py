"""Which run is proposed next, of those that the diagnosis tried; or why none is."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from ..capture.motion import as_legs
from ..wire.motion import Leg, Limits
from .limits import beyond
from .step import Step, without_curves

FIRM = ("explained", "consistent", "parameters", "unknown")
SLOWER = 1.1  # times the shortest time for the way to where the proposed run begins


def firm(verdicts: Sequence[tuple[str, Sequence[str]]], doubted: bool) -> bool:
    """Whether the last verdict ends the loop; `verdicts` are it and the one before, each with the ids that it names.

    `doubted`: it holds one explanation, but not surely. Where the loop's own runs led to it, one more run has to name
    the same.
    """
    verdict, names = verdicts[-1]
    confirmed = len(verdicts) == 1 or (verdicts[-2][0] == verdict and set(verdicts[-2][1]) == set(names))
    return verdict in FIRM and (confirmed or not doubted)


@dataclass(frozen=True)
class Budget:
    """What may be spent in all; a first recording is not counted among the runs."""

    runs: int
    minutes: float
    strokes: int

    def left(self, steps: Sequence[Step]) -> "Budget":
        """What is left after so many steps."""
        spent = [step for step in steps if step.state in ("recorded", "diagnosed")]
        seconds, strokes = sum(step.seconds for step in spent), sum(step.strokes for step in spent)
        return Budget(
            self.runs - sum(step.number > 0 for step in spent), self.minutes - seconds / 60.0, self.strokes - strokes
        )

    def lacks(self, step: Step) -> str | None:
        """What of a run is not left, in words."""
        if self.runs < 1:
            return "as many runs as --runs allows are made"
        if step.seconds > 60.0 * self.minutes:
            return f"it takes {step.seconds / 60:.1f} min, and of --minutes {max(self.minutes, 0):.1f} are left"
        if step.strokes > self.strokes:
            return f"it takes {step.strokes} strokes, and of --strokes {max(self.strokes, 0)} are left"
        return None


def reachable(entry: dict[str, Any], limits: Limits | None) -> list[Leg]:
    """Legs of a proposal, the first one slow enough to get from where the motor stands to where the run begins."""
    legs = as_legs(entry["legs"], entry.get("load"))
    if limits is not None and legs:
        way_s = SLOWER * limits.way_s(legs[0].turns - limits.at_turns)
        legs[0] = Leg(max(legs[0].seconds, way_s), legs[0].turns, legs[0].load_n)
    return legs


def gaps(entry: dict[str, Any]) -> tuple[float, float]:
    """The gap between the closest explanations without a run and with it, in standard deviations."""
    now, then = (math.sqrt(max(entry[key], 0.0)) for key in ("gap_now", "gap_then"))
    return now, then


def chosen(
    options: Sequence[dict[str, Any]], number: int, limits: Limits | None, left: Budget
) -> tuple[Step | None, str]:
    """The run that raises the gap most of those that limits and budget allow, and why it is no better one.

    Without such a run None, and the sentence that ends the loop.
    """
    raising = [entry for entry in options if entry.get("raises", entry["decides"])]
    if not raising:
        now, then = gaps(options[0])
        said = f"of the {len(options)} runs that were tried none raises the expected gap: {now:.2g} standard deviations"
        return None, f"{said} so far, {then:.2g} with the best; as far as they show it is a tie by construction"
    refused: list[str] = []
    for entry in raising:
        legs = reachable(entry, limits)
        plain = [
            {"seconds": leg.seconds, "motor_turns": leg.turns} | ({} if leg.load_n is None else {"load_n": leg.load_n})
            for leg in legs
        ]
        step = Step(number, "proposed", proposal=without_curves(entry) | {"legs": plain})
        why = beyond(legs, limits) or left.lacks(step)
        if why is None:
            return step, "; ".join(refused)
        refused.append(f"{entry['title']}: {why}")
    return None, f"no run that would raise the expected gap is allowed ({'; '.join(refused)})"
