"""A share as a person reads it."""


def percent(share: float) -> str:
    """A share in whole per cent, with the space that belongs before the sign: `10 %`."""
    return f"{100.0 * share:.0f} %"
