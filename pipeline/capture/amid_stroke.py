"""A recording that joined a rig amid a stroke: what of its beginning belongs to no whole stroke."""

from ..ground.units import unit_of
from ..run.strokes import REST_BAND
from ..string.history import Recorded


def began_amid(recorded: Recorded) -> str:
    """A sentence on a recording whose first sample is no rest near the lowest twist; empty where it is one."""
    driver, first = recorded.run.system.driver, recorded.strokes.iloc[0]
    low, high = recorded.rows.extremes(driver)
    if first["start_turns"] <= low + REST_BAND * (high - low):
        return ""
    at = f"at {first['start_turns']:.3g} of {high:.3g} {unit_of(driver)}"
    if first["stroke"] > 0:
        return f"the recording began amid a winding, {at}: stroke 1 holds it from there on, and nothing is left out"
    winding = recorded.strokes.loc[recorded.strokes["stroke"] > 0, "start_s"].min()
    return (
        f"the recording began amid a stroke, {at}: its first {winding - first['start_s']:.3g} s, up to the first "
        "winding, belong to no stroke, and tables and models leave them out"
    )
