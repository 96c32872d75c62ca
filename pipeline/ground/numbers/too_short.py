"""Whether the torsion zone can lie within the string."""

MOST_STRETCH = 1 / 3  # of the length: no string stretches by more


def too_short(length_mm: float, zone_mm: float) -> str:
    """Field, problem and mend of a length in mm that no load can stretch to the torsion zone in mm; else empty."""
    if length_mm * (1.0 + MOST_STRETCH) >= zone_mm:
        return ""
    problem = f"is {length_mm:g} mm, but the torsion zone within it is {zone_mm:g} mm"
    return f"string.length_mm: {problem}; give string.length_mm and rig.torsion_zone_mm in mm, as they were measured"
