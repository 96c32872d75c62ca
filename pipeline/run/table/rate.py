"""The rates that a rig records at, and the unit of a time whose steps are none of them. It needs no pandas."""

from ...ground.units import conversion

CLOCK_UNITS = ("s", "ms", "us")  # in which a device may give its time
STEP_S = (0.5e-4, 0.2)  # 10 Hz to 10 kHz, with room for jitter
ROUNDED = 1e-4  # of a step: what stamps that are written with few digits make of it


def is_rate(step_s: float, slowest_s: float = STEP_S[1], fastest_s: float = STEP_S[0]) -> bool:
    """Whether a rig may take a sample every `step_s`, in s, if it takes one every `slowest_s` at least."""
    return fastest_s * (1.0 - ROUNDED) <= step_s <= slowest_s * (1.0 + ROUNDED)


def lasting(step_s: float) -> str:
    """The time between two samples, given in s, in words, in ms if it is short."""
    return f"{step_s:.4g} s" if step_s >= 0.1 else f"{1000.0 * step_s:.4g} ms"


def unit_of_rate(step_s: float, unit: str | None, slowest_s: float = STEP_S[1], fastest_s: float = STEP_S[0]) -> str:
    """How a mend names the one unit, other than the time's `unit`, in which a step in s is a rig's; else all units."""
    if unit is not None:
        now_s = conversion("time_s", unit)[0]
        steps_s = {each: step_s * conversion("time_s", each)[0] / now_s for each in CLOCK_UNITS}
        fitting = [each for each, own_s in steps_s.items() if is_rate(own_s, slowest_s, fastest_s)]
        if len(fitting) == 1:
            return f"to '{fitting[0]}'"
    return f"({', '.join(CLOCK_UNITS[:-1])} or {CLOCK_UNITS[-1]})"


def no_rate(step_s: float) -> str:
    """The words for a step, in s, that is no rig's."""
    return f"a sample every {lasting(step_s)} is no rate of a rig"
