"""Whether a bench can have a string of such dimensions: metres that are read as mm, or N/m as N/mm."""

from pathlib import Path

import numpy as np

from ...ground.errors import BadInput
from ..description import Run
from .tolerances_given import tolerance_questions

LONGEST_MM = 10_000.0  # of a string that a bench winds
STIFFEST_MPA = 1e6  # modulus that no fibre has: the stiffest carbon has 0.9 of it


def dimension_questions(run: Run, path: Path) -> list[BadInput]:
    """Dimensions and tolerances in `path` that are possible, but likely mistakes: each with its mend."""
    if run.string is None:
        return tolerance_questions(run, path)
    length_mm, radius_mm, zone_mm = run.string.length_mm, run.string.radius_mm, run.rig.get("torsion_zone_mm", 0.0)
    odd = []
    if length_mm < zone_mm:
        problem = f"is {length_mm:g} mm, less than the torsion zone within it, {zone_mm:g} mm"
        odd.append(BadInput(path, "string.length_mm", problem, "measure it from clamp to clamp, and the zone again"))
    elif length_mm > LONGEST_MM:
        problem = f"is {length_mm / 1000.0:g} m, which no bench has"
        odd.append(BadInput(path, "string.length_mm", problem, "give string.length_mm in mm"))
    stiffness_n_per_mm = run.string.stiffness_n_per_mm or 0.0
    modulus_mpa = stiffness_n_per_mm * length_mm / (np.pi * radius_mm**2)
    if modulus_mpa > STIFFEST_MPA and not odd:
        of = f"a modulus of {modulus_mpa / 1000.0:.4g} GPa with {length_mm:g} mm length and {radius_mm:g} mm radius"
        problem = f"is {stiffness_n_per_mm:g} N/mm, {of}, which no fibre has"
        mend = "is it in N/m? Give it in N/mm, or leave it out where nobody measured it; else check length and radius"
        odd.append(BadInput(path, "string.stiffness_n_per_mm", problem, mend))
    return [*odd, *tolerance_questions(run, path)]
