"""The run that is proposed next, among those that the diagnosis tried; or the reason why none is."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from ..capture.motion_program import LegJson, as_legs
from ..ground.words.counts import counted
from ..wire.motion import Leg, Limits
from .limits import ByHand, beyond
from .proposed import ProposedRun, without_curves
from .step import Step
from .tie import SETTLED_RIGHTLY, closest

FIRM = ("explained", "consistent", "parameters", "unknown")
SLOWER = 1.1  # times the shortest time for the way to where the proposed run begins
SLOWED = 1.1  # times as long a leg may take at most, where the rig goes no faster: that tells as much
HAIR = 1.002  # times the shortest time of a leg: the wire carries whole milliseconds
MANY = 100  # standard deviations, beyond which no person asks how many
SHOWN = 3  # runs that are named with a reason why they are not made


def firm(verdicts: Sequence[tuple[str, Sequence[str]]], doubted: bool) -> bool:
    """Whether the last verdict ends the loop; `verdicts` are the last two, each with the ids that it names.

    `doubted`: it holds one explanation, but not surely. Where the loop's own runs led to it, one more run has to name
    the same.
    """
    verdict, names = verdicts[-1]
    confirmed = len(verdicts) == 1 or (verdicts[-2][0] == verdict and set(verdicts[-2][1]) == set(names))
    return verdict in FIRM and (confirmed or not doubted)


@dataclass(frozen=True)
class Budget:
    """The budget for all runs; a first recording does not count as one."""

    runs: int
    minutes: float
    strokes: int

    def left(self, steps: Sequence[Step]) -> "Budget":
        """The budget left after so many steps."""
        spent = [step for step in steps if step.state in ("recorded", "diagnosed")]
        seconds, strokes = sum(step.seconds for step in spent), sum(step.strokes for step in spent)
        return Budget(
            self.runs - sum(step.number > 0 for step in spent), self.minutes - seconds / 60.0, self.strokes - strokes
        )

    def lacks(self, step: Step) -> str | None:
        """Which parts of the budget a run exceeds, in words."""
        if self.runs < 1:
            return "as many runs as --runs allows are made"
        if step.seconds > 60.0 * self.minutes:
            return f"it takes {step.seconds / 60:.1f} min, and of --minutes {max(self.minutes, 0):.1f} are left"
        if step.strokes > self.strokes:
            return f"it takes {counted(step.strokes, 'stroke')}, and of --strokes {max(self.strokes, 0)} are left"
        return None


def reachable(run: ProposedRun, limits: Limits | None) -> list[Leg]:
    """Legs of a proposal in a form that the rig can follow.

    The first one is slow enough to get from where the motor stands to where the run begins; of the others one that is
    a little too fast takes as long as it must.
    """
    legs = as_legs(run["legs"], run.get("load"))
    if limits is None:
        return legs
    at, slowed = limits.at_turns, list[Leg]()
    for number, leg in enumerate(legs):
        way_s = (HAIR if number else SLOWER) * limits.way_s(leg.turns - at)
        can = number == 0 or way_s <= SLOWED * leg.seconds
        slowed.append(Leg(max(leg.seconds, way_s) if can else leg.seconds, leg.turns, leg.load_n))
        at = leg.turns
    return slowed


def passed_over(refused: Sequence[tuple[str, str]]) -> str:
    """Runs that are not made, each a title and a reason; runs with the same reason together, a few by title."""
    by_reason: dict[str, list[str]] = {}
    for title, reason in refused:
        by_reason.setdefault(reason, []).append(title)
    words = []
    for reason, titles in by_reason.items():
        more = f" and {len(titles) - SHOWN} others" if len(titles) > SHOWN else ""
        words.append(f"{reason} ({', '.join(titles[:SHOWN])}{more})")
    return "; ".join(words)


def leg_json(leg: Leg) -> LegJson:
    """A leg as files have it."""
    entry: LegJson = {"seconds": leg.seconds, "motor_turns": leg.turns}
    if leg.load_n is not None:
        entry["load_n"] = leg.load_n
    return entry


def gaps(run: ProposedRun) -> tuple[float, float]:
    """The gap between the closest explanations without a run and with it, in standard deviations."""
    now, then = (math.sqrt(max(gap, 0.0)) for gap in (run["gap_now"], run["gap_then"]))
    return now, then


def apart(run: ProposedRun) -> str:
    """How far apart a run puts the two closest explanations, in words; empty where it separates none."""
    if "gap_then" not in run:
        return ""
    two = closest(run)
    pair = f"the closest two explanations{f', {two},' if two else ''}"
    return f"By the library's formulas it puts {pair} {in_words(gaps(run)[1])} apart; {SETTLED_RIGHTLY}."


def in_words(deviations: float) -> str:
    """A number of standard deviations in words for a person."""
    if deviations > MANY:
        return f"more than {MANY} standard deviations"
    size = f"{deviations:.0f}" if deviations >= 9.95 else f"{deviations:.1f}"
    return f"about {size} standard deviations"


def chosen(
    options: Sequence[ProposedRun], number: int, limits: Limits | None, budget_left: Budget
) -> tuple[Step | None, str]:
    """The best run that limits and budget allow, and why it is not a better one.

    Without such a run None, and the sentence that ends the loop.
    """
    raising = [run for run in options if run.get("raises", run["decides"])]
    if not raising:
        now, then = gaps(options[0])
        sentence = f"of the {counted(len(options), 'run')} tried none raises the expected gap: {in_words(now)}"
        return (
            None,
            f"{sentence} so far, {in_words(then)} with the best; as far as they show it is a tie by construction",
        )
    refused: list[tuple[str, str]] = []
    for run in raising:
        legs = reachable(run, limits)
        proposal: ProposedRun = {**without_curves(run), "legs": [leg_json(leg) for leg in legs]}
        if limits is not None and not isinstance(limits, ByHand):  # the rig says where its motor stands now
            proposal |= {"from": limits.at_turns, "turns_per_s2": limits.turns_per_s2}
        step = Step(number, "proposed", proposal=proposal)
        why = beyond(legs, limits) or budget_left.lacks(step)
        if why is None:
            return step, passed_over(refused)
        refused.append((run["title"], why))
    return None, f"no run that would raise the expected gap is allowed: {passed_over(refused)}"
