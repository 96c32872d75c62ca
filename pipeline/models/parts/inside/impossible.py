"""Contractions that cannot be: a model that is asked far beyond its points may answer anything.

No string contracts by more than its length. Nor does it by far more than the paper's equation gives for its twist. The
limit is a multiple of that, or of how many times that much was recorded; near the untwisted string, where a multiple
says little, it is the equation and how far above it strings were recorded. Nor does a string lengthen by more than it
ever contracted. What lies within these limits may be wrong all the same. A contraction far below the equation is
possible: a jammed string falls behind.

Source: eq. 4 of Liu et al., "Kinematic Modeling of Twisted String Actuator Based on Invertible Neural Networks".
"""

import numpy as np
import pandas as pd

from ....ground.kinematics import Array, point_contraction_mm

MULTIPLE = 1.5  # of the equation's contraction, or of how many times that much was recorded
SPARE = 0.25  # of the largest recorded contraction: what a load or a stroke that nobody recorded may add


def impossible(points: pd.DataFrame, contractions_mm: Array, recorded: pd.DataFrame) -> list[str]:
    """For each question whose answered contraction in mm cannot be, a sentence on that; else an empty text.

    `points` are the questions, with `contractions_mm` of shape (points,); `recorded` are the recorded points.
    """
    equation_mm, recorded_mm = point_contraction_mm(recorded), recorded["displacement_mm"].to_numpy(float)
    top = int(np.argmax(recorded_mm))
    largest_mm = float(np.abs(recorded_mm).max())
    above_mm = max(float((recorded_mm - equation_mm).max()), 0.0) + SPARE * largest_mm
    times = MULTIPLE * max(1.0, float(recorded_mm[top] / equation_mm[top]) if equation_mm[top] > 0.0 else 1.0)
    length_mm, given_mm = points["length_mm"].to_numpy(float), point_contraction_mm(points)
    most_mm, sentences = np.maximum(times * given_mm, given_mm + above_mm), [""] * len(points)
    for row, answer_mm in enumerate(contractions_mm):
        if not np.isfinite(answer_mm):
            sentences[row] = "the model's answer is no number"
        elif given_mm[row] > max(length_mm[row], equation_mm.max()):
            sentences[row] = f"the paper's equation gives more than the string's length, {length_mm[row]:.4g} mm, there"
        elif answer_mm > length_mm[row]:
            sentences[row] = f"the model's answer is more than the string's length, {length_mm[row]:.4g} mm"
        elif answer_mm > most_mm[row]:
            equation = f"where the paper's equation gives {given_mm[row]:.3g} mm"
            sentences[row] = f"the model's answer is more than {most_mm[row]:.3g} mm, {equation}"
        elif answer_mm < -largest_mm:
            longer = f"longer than untwisted by more than {largest_mm:.3g} mm, the most that any one contracted"
            sentences[row] = f"the model's answer is a string {longer}"
    return [f"no number is given: {sentence}, which cannot be" if sentence else "" for sentence in sentences]
