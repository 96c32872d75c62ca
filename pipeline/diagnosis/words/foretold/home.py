"""The remarks on a motor's zero that was homed anew, and on the part of a diagnosis that another run uses."""

from ...prediction.carried_over import CLEARLY, CarriedOver
from ..language.quantity import number, percent, size
from ..language.text_table import aligned

PARTS = {
    (True, True): "all of the diagnosis: its effects and its dimensions",
    (True, False): "its effects, with the dimensions of run.yaml",
    (False, True): "its dimensions, without its effects",
    (False, False): "nothing of it: the dimensions of run.yaml, without effects",
}  # by whether effects and dimensions of a diagnosis are in it


def of_home(carried: CarriedOver, unit: str) -> list[str]:
    """Where the motor's zero was found, and what that changes after the first stroke; `unit`: of the reading.

    Nothing for a rig without such a zero.
    """
    home, whose = carried.home, "the diagnosis" if carried.dimensions else "run.yaml"
    if home is None:
        return []
    bound = ", as far as its tolerance lets it: give angle_turns a wider one if it may be further" * home.at_bound
    place = f"is {number(home.value, 3)} turns, where {whose} has {number(home.before, 3)}{bound}"
    errors = f"{size(home.error, unit)} rms, with the zero that {whose} has {size(home.error_before, unit)}"
    return [f"the motor's zero, homed on the first stroke of the recording, {place}. Error after that stroke: {errors}"]


def of_carried_over(carried: CarriedOver, run: str, unit: str) -> list[str]:
    """The residual of each part of the diagnosis on the first stroke, which part is taken, and why.

    `unit` is the reading's. Nothing where only one part could be tried.
    """
    if len(carried.left) < 2:
        return []
    taken = carried.effects, carried.dimensions
    rows = [["simulated with", f"leaves of the first stroke of {run}, rms", ""]]
    for kept, name in PARTS.items():
        if kept in carried.left:
            rows.append([name, size(carried.left[kept], unit), "taken" * (kept == taken)])
    tried = "homed and tried" if carried.home else "tried"
    return [f"Each part of the diagnosis was {tried} on the first stroke:", *aligned(rows), _why(carried, run)]


def _why(carried: CarriedOver, run: str) -> str:
    """Why a part of the diagnosis is taken, or all of it."""
    least = min(carried.left.values())
    if carried.whole:
        much = f"no part leaves less than {percent(CLEARLY)} of what it leaves"
        return f"All of the diagnosis is taken: {much if least < carried.left[True, True] else 'it leaves least'}."
    lost = {
        (True, False): "the dimensions of the diagnosis do not fit this recording, and are left out",
        (False, True): "the effects of the diagnosis do not fit this recording, and are left out",
        (False, False): "neither the effects nor the dimensions of the diagnosis fit this recording, so nothing of it "
        f"is taken. What is simulated is run.yaml{', its motor homed' if carried.home else ''}",
    }[carried.effects, carried.dimensions]
    return f"This part leaves less than {percent(CLEARLY)} of what all of it leaves: {lost}."
