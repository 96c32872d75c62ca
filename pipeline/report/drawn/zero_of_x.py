"""The place of an untwisted string on the axis of the displacement, in words beneath a figure."""

import pandas as pd

from ...ground.kinematics import point_contraction_mm

MODEL = "traditional model"
LEAST_MM = 0.005  # less is 0 in two decimals
ANEW = (
    "A further run with `tare: run` in its run.yaml goes on where the run before ended, with what the string took back "
    "since. Where the two rest under other loads or at other twists it goes on from an earlier rest like its own, or "
    "from a straight line in load through earlier rests, or is set to the model's value."
)


def zero_of_x(points: pd.DataFrame) -> str:
    """A sentence on the tare of the displacement, and the resulting place without twist; empty without points.

    `points` are those of a dataset.
    """
    if points.empty:
        return ""
    of_strings = points.groupby("string", sort=False).head(1).assign(motor_turns=0.0)
    untwisted_mm = point_contraction_mm(of_strings)
    low, high = float(untwisted_mm.min()), float(untwisted_mm.max())
    several = (points.groupby("string", sort=False)["run"].nunique() > 1).any()
    words = f"x is tared once a string, on the rest before its first stroke, to the {MODEL}'s value at that twist."
    if high >= LEAST_MM:
        between = " to ".join(dict.fromkeys(f"{value:.2f}" for value in (low, high)))
        words += f" Without twist that is {between} mm, not 0, since the separator spreads the string."
    return f"{words} {ANEW}" if several else words
