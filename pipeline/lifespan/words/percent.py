"""Shares as a person reads them."""


def percent(share: float) -> str:
    """A share in whole per cent, with the space that belongs before the sign: `10 %`."""
    return f"{100.0 * share:.0f} %"


def tail(share: float) -> str:
    """A share that may be less than a whole per cent, without the digits that arithmetic adds: `2.5 %`."""
    return f"{100.0 * share:.3g} %"


def of_100(share: float) -> str:
    """A share as a count: `3 in 100`."""
    return f"{100.0 * share:.0f} in 100"
