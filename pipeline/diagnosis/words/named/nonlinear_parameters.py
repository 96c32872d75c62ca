"""The meaning of mechanisms' nonlinear parameters, in the words of a rig, and the letters of their formulas."""

from ....ground.units import unit_of
from ...facts.mechanism_entries import unit_of_nonlinear
from ...fit.problem import Act
from ...mechanisms.interface import Mechanism
from ...mechanisms.library import mechanisms
from ...mechanisms.shared_meanings import MEANINGS
from ...recording.drivers import Drivers
from ...recording.system_units import Units
from ..language.quantity import number, quantity, said_unit
from ..language.vocabulary import Vocabulary

CHOSEN = "a number in the formula itself, chosen by the search or fitted"
SCALE = "a scale only: the numbers above hold for it"
LOAD = "_load"  # ends the name of a load, which the library counts in 10 N
MEANT = {  # letters of formulas
    "A": "the height of the ripple",
    "F": "the load",
    "F_ref": "the load at which the numbers hold",
    "K": "the stiffness of the string",
    "P": "how much longer the string is for good",
    "T": "the temperature",
    "a": "the helix angle, between a string and the axis",
    "c": "the strokes worked so far",
    "d": "the torsion zone",
    "delay": "by how much the reading is late",
    "dx": "what the effect adds to the displacement",
    "k": "the strength, from the first rows of the table",
    "p": "where in the turn the ripple begins",
    "q": "the twist",
    "r": "the radius of the string",
    "r_e": "the radius that acts",
    "reach": "how far the reading falls behind before it slips",
    "t": "the time",
    "tau": "a time constant",
    "theta": "the twist of the motor",
    "theta'": "the twist after the play",
    "theta_c": "the critical twist",
    "theta_s": "the twist that the string sees",
    "travel": "the distance travelled so far",
    "v": "the speed",
    "x": "the displacement, by the dimensions alone",
    "x_m": "the displacement that the sensor reads",
    "y": "the displacement, by the dimensions alone",
}


def meaning_of(key: str, mechanism: Mechanism) -> str:
    """The meaning of a mechanism's nonlinear parameter `key`, with fields for the rig's words; empty if unknown."""
    return {**MEANINGS, **mechanism.meanings}.get(key, "")


def on_this_rig(key: str, mechanism: Mechanism, words: Vocabulary) -> str:
    """The meaning of a mechanism's nonlinear parameter `key`, in the words of this rig."""
    fields = {"scale": SCALE, "motion": words.motion, "string": words.string, "motion_unit": words.motion_unit}
    return meaning_of(key, mechanism).format(**fields) or CHOSEN


def unit_of_parameter(key: str, name: str) -> str:
    """Unit of the nonlinear parameter `key`, which is called `name` on this rig; empty where it has none."""
    return said_unit(unit_of(name)) if unit_of_nonlinear(key) != "1" else ""


def with_its_unit(key: str, value: float, mechanism: Mechanism, units: Units) -> tuple[str, str]:
    """A nonlinear parameter with the unit that its name lacks; a load also with its form in run.yaml.

    Nothing of one whose name says its unit, or which has none.
    """
    unit = units.unit(mechanism.scale_units.get(key, "10N" if key.endswith(LOAD) else ""))
    counted = units.unit("10N")
    if counted not in unit:
        return (f"{number(value, 3)} {said_unit(unit)}" if unit else ""), ""
    spelled = f"{number(units.load_size * value, 3)} {said_unit(unit.replace(counted, units.load))}"
    return spelled, f"; run.yaml has it as {number(value, 3)}, in {said_unit(unit)}"


def measurable(act: Act, drivers: Drivers, words: Vocabulary) -> list[str]:
    """The parts of an effect that a person can measure at the rig, such as half of a play, a line each."""
    mechanism, coefficients, lines = mechanisms()[act.id], iter(act.coefficients), list[str]()
    for nonlinear in act.nonlinear:
        terms = mechanism.terms(drivers, nonlinear)
        values = {term.name: next(coefficients) for term in terms} | nonlinear
        for name, derive in mechanism.derived.items():
            meant = next((detail for detail in mechanism.details if f"{{{name}}}" in detail), "")
            value = derive(values)
            if not meant or not value:
                continue
            loads = [nonlinear[key] for key in nonlinear if key.endswith(LOAD) and f"{{{key}_n}}" in meant]
            number_of = meant.partition("{")[0].removesuffix("is ").rstrip()
            under = f" under {quantity(drivers.units.load_size * loads[0], drivers.units.load)}" if loads else ""
            lines.append(
                f"    To measure at the rig: {number_of} is {number(value, 3)} {said_unit(words.motion_unit)}{under}."
            )
    return lines
