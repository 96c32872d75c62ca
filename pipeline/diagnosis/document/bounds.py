"""Dimensions that calibration moved as far as it may: the best value may lie beyond it."""

import re

BOUND = 2.95  # sigma, from which a dimension stands where calibration had to stop
HOME_REACH = 20.0  # tolerances that the motor's zero of a later run may move: in a break a person may change it


def at_bound(moved_sigma: dict[str, float]) -> dict[str, str]:
    """Each dimension at the bound of its tolerance, `upper` or `lower`, from the sigma that each dimension moved."""
    return {
        name: "upper" if sigma > 0.0 else "lower"
        for name, sigma in moved_sigma.items()
        if abs(sigma) >= BOUND and not of_later_run(name)
    }


def of_later_run(name: str) -> bool:
    """Whether a parameter belongs to a later run alone, such as `angle_turns_2`, and so is no dimension."""
    return re.search(r"_turns_\d+$", name) is not None
