"""By how much winding and unwinding will differ in a run, for each explanation: a person sees it at the rig."""

import numpy as np

from ..ground.kinematics import Array
from .proposed import Curves
from .step import Step

POINTS = 200  # of the twist, at which both ways are compared
DIGITS = 2


def expected_loops(step: Step, curves: Curves) -> list[str]:
    """A line for each stroke whose loop tells explanations apart, after a line on what a loop is; else nothing."""
    spans, lines = stroke_spans(step), []
    for number, span in enumerate(spans, start=1):
        widths = {name: loop_mm(curves, curve, span) for name, curve in curves["rivals"].items()}
        words = {name: f"{width:.{DIGITS}f} mm" for name, width in widths.items() if width is not None}
        if len(set(words.values())) < 2:
            continue
        which = f"stroke {number}: " if len(spans) > 1 else ""
        lines.append(f"  {which}{', '.join(f'{width} if {name} is right' for name, width in words.items())}")
    meaning = "The loop to expect, by how much winding and unwinding differ at most at one twist:"
    return [meaning, *lines] if lines else []


def stroke_spans(step: Step) -> list[tuple[float, float, float, float]]:
    """When each stroke winds and unwinds: start and end of each, in s since the run began."""
    spans, at, at_s = list[tuple[float, float, float, float]](), step.proposal.get("from", 0.0), 0.0
    wound: tuple[float, float] | None = None
    for leg in step.legs:
        to, ends_s = leg["motor_turns"], at_s + leg["seconds"]
        if to - at > step.still_turns:
            wound = at_s, ends_s
        elif at - to > step.still_turns and wound:
            spans.append((*wound, at_s, ends_s))
            wound = None
        at, at_s = to, ends_s
    return spans


def loop_mm(curves: Curves, curve: list[float], span: tuple[float, float, float, float]) -> float | None:
    """The widest difference of a curve's two ways at one twist in mm; None where the ways share no twist."""
    time_s, turns, reading_mm = (np.array(each) for each in (curves["time_s"], curves["motor_turns"], curve))
    ways = [_way(time_s, turns, reading_mm, *span[:2]), _way(time_s, turns, reading_mm, *span[2:])]
    low, high = max(way[0].min() for way in ways), min(way[0].max() for way in ways)
    if not high > low:
        return None
    at = np.linspace(low, high, POINTS)
    wound_mm, unwound_mm = (np.interp(at, *way) for way in ways)
    return float(np.abs(wound_mm - unwound_mm).max())


def _way(time_s: Array, turns: Array, reading_mm: Array, from_s: float, to_s: float) -> tuple[Array, Array]:
    """Turns in rising order and the reading in mm, of one way."""
    within = (time_s > from_s) & (time_s < to_s)
    at_s = np.concatenate([[from_s], time_s[within], [to_s]])
    way_turns, way_mm = (np.interp(at_s, time_s, values) for values in (turns, reading_mm))
    order = np.argsort(way_turns, kind="stable")
    return way_turns[order], way_mm[order]
