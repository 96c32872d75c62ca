"""What a person is told of a motor's zero that was homed anew."""

from ...prediction.home import Home
from ..language.quantity import number, size


def of_home(home: Home, unit: str) -> str:
    """Where the motor's zero was found, and what that changes after the first stroke; `unit`: of the reading."""
    bound = ", as far as its tolerance lets it: give angle_turns a wider one if it may be further" * home.at_bound
    place = f"is {number(home.value, 3)} turns, where the diagnosis has {number(home.before, 3)}{bound}"
    errors = f"{size(home.error, unit)} rms, with the diagnosis' own zero {size(home.error_before, unit)}"
    return f"the motor's zero, homed on the first stroke of the recording, {place}. Error after that stroke: {errors}"
