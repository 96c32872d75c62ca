"""Dimensions that calibration moved as far as it may: the best value may lie beyond it."""

BOUND = 2.95  # sigma, from which a dimension stands where calibration had to stop


def at_bound(moved_sigma: dict[str, float]) -> dict[str, str]:
    """Each dimension that stands at the bound of its tolerance, `upper` or `lower`, from how many sigma each moved."""
    return {name: "upper" if sigma > 0.0 else "lower" for name, sigma in moved_sigma.items() if abs(sigma) >= BOUND}
