"""What a person is told of a motor's zero that was homed anew, and of what else another run takes of a diagnosis."""

from ...prediction.carried_over import CarriedOver
from ...prediction.home import Home
from ..language.quantity import number, size


def of_home(home: Home, unit: str) -> str:
    """Where the motor's zero was found, and what that changes after the first stroke; `unit`: of the reading."""
    bound = ", as far as its tolerance lets it: give angle_turns a wider one if it may be further" * home.at_bound
    place = f"is {number(home.value, 3)} turns, where the diagnosis has {number(home.before, 3)}{bound}"
    errors = f"{size(home.error, unit)} rms, with the diagnosis' own zero {size(home.error_before, unit)}"
    return f"the motor's zero, homed on the first stroke of the recording, {place}. Error after that stroke: {errors}"


def of_carried_over(carried: CarriedOver, unit: str) -> list[str]:
    """That a part of the diagnosis alone is taken, and why; nothing where all is; `unit`: of the reading."""
    if carried.whole:
        return []
    taken = "the effects, with the dimensions of run.yaml" if carried.effects else "the dimensions, without the effects"
    if not carried.effects and not carried.dimensions:
        taken = "nothing but the motor's zero, so the simulator is that of run.yaml without effects"
    left = f"{size(carried.home.left, unit)} rms of the first stroke, where all of the diagnosis leaves"
    return [f"of the diagnosis this run takes {taken}: that leaves {left} {size(carried.left_by_all, unit)}"]
