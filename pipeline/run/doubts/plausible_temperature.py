"""Whether a room can have the logged temperature: kelvin may have been read as degrees Celsius, or the reverse."""

from pathlib import Path

from ...ground.errors import BadInput
from ...ground.stored.rows import Rows

ROOM_C = (-60.0, 150.0)  # a temperature beyond is a mistake: of its unit, or of its sensor


def temperature_mistake(samples: Rows, path: Path) -> BadInput | None:
    """The argument against a logged temperature; None where it is possible, or none was logged."""
    if "temperature_c" not in samples.columns:
        return None
    coldest_c, warmest_c = samples.extremes("temperature_c")
    if ROOM_C[0] <= coldest_c and warmest_c <= ROOM_C[1]:
        return None
    problem = f"is {coldest_c:.4g} to {warmest_c:.4g} °C, which no room has"
    mend = "set channels.temperature_c.unit to the unit of its column (degC or K), and check its scale"
    return BadInput(path, "temperature_c", problem, mend)
