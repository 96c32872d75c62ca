"""What the numbers and letters in the formulas themselves mean, by their names: places, widths, times, strengths."""

from ....ground.units import unit_of
from ...facts.mechanism_entries import unit_of_nonlinear
from ..language.quantity import said_unit
from ..language.vocabulary import Vocabulary

CHOSEN = "a number in the formula itself, chosen by the search or fitted"
SCALE = "a scale only: the numbers above hold for it"
LOADS = ("from_load", "usual_load")  # loads, which the library counts in 10 N
MEANS = {
    "at_s": "when it happens, from the start of the recording; below 0: a little in every stroke",
    "back_share": "how much of the reach is given back at a slip, as a share of it",
    "critical_turns": "the {motion} from which on it acts",
    "damping": "how fast the swing dies: 0 never, 1 at once",
    "falls_turns_per_s": "the speed above which it is gone",
    "fastest_s": "the shortest time constant that the recording could show",
    "fastest_turns_per_s": "the highest speed of the recording, {scale}",
    "forgets_s": "how long it shows afterwards",
    "frequency_hz": "how fast it swings, under 10 N",
    "fresh": "1 means: the {string} was first loaded at the first sample, and 0: it had been loaded for long before",
    "from_load": "the load at which it does nothing",
    "from_turns": "where the travel begins",
    "half_turns": "half the width of the narrow stop that rounds the loop",
    "half_waves": "by how many half waves over the recording it may wander",
    "half_width_turns": "the widest part of the play; half the play is a share of it, which the verdict gives in turns",
    "heavy_slow": "1 means: it swings slower under a heavier load, and 0: always alike",
    "highest_pressure": "the highest load x tan(helix angle)^2 of the recording, {scale}",
    "highest_torque": "the highest torque of the recording, {scale}",
    "hz": "how often it comes in a second",
    "load_power": "to which power the load counts in the work: 0 not at all, 1 in proportion",
    "loaded": "1 means: the load varied, so that parts that grow with it were tried, and 0: it did not",
    "later_runs": (
        "0 means: each later run goes on from the one before, a minute after it; 1: it begins as the first one did; "
        "2: the {string} had been loaded for long before it"
    ),
    "loop_turns": "over which {motion} the part that rubs turns round",
    "measured": "1 means: it follows the measured temperature, and 0: one that is calculated from the motion",
    "pitch_turns": "how far the {motion} goes from one ripple to the next",
    "play_turns": "half the width of the widest play at the usual load",
    "reach_mm": "how far the reading falls behind before it slips",
    "rim_mm": "the reading at which it overflows, from where the recording begins",
    "sag_mm": "the whole slack, as a length",
    "second_hz": "how fast the second swing is",
    "side": "1 means: at the upper end; -1 means: at the lower end",
    "sign": "1 means: more, as thicker or longer, with what it follows; -1 means: less",
    "slow_turns_per_s": "the speed below which what slides begins to stick",
    "slowest_s": "the longest time constant that the recording could show",
    "soft_mm": "how softly the stop begins: 0 is hard",
    "softness": "how softly it ends, as a share of the slack",
    "softness_turns": "how softly it begins",
    "span_turns": "the range of the {motion}, {scale}",
    "steepest": "the largest tan(helix angle) of the recording, {scale}",
    "stop": "1 means: a stop holds the slack, as a length, and 0: it is {motion} that does nothing",
    "stop_mm": "where the reading stops, from where the recording begins",
    "take_up_mm": "the slack, as a length",
    "take_up_turns": "the {motion} that the slack takes up",
    "top_turns": "the highest {motion} of the recording, {scale}",
    "travel_turns": "the whole travel of the recording, {scale}",
    "usual_load": "the load at which the widths hold: they grow in proportion to the load",
    "usual_rate": "the usual speed, in {motion_unit}/s: far below it is slow",
    "warming_s": "in which time the zero has moved by 63 % of all that it will",
    "wheel_mm": "the circumference of the sensor's wheel; 0: it follows the motor's own turn",
    "whole_s": "the length of the recording, {scale}",
    "wide_half_turns": "half the width of the wide stop that rounds the loop",
    "within_s": "in which time it is over; 0: at once",
    "work": "the whole work of the recording, {scale}",
}
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


def meaning_of(key: str) -> str:
    """What the library's number `key` is, with fields for the rig's words; nothing where nobody said it."""
    return (
        "how much of what heats there usually is, {scale}"
        if key.startswith("usual_") and key not in MEANS
        else (MEANS.get(key, ""))
    )


def shape_number(key: str, words: Vocabulary) -> str:
    """Meaning of the library's number `key` on this rig."""
    fields = {"scale": SCALE, "motion": words.motion, "string": words.string, "motion_unit": words.motion_unit}
    return meaning_of(key).format(**fields) or CHOSEN


def unit_of_shape(key: str, name: str) -> str:
    """Unit of the library's number `key`, which is called `name` on this rig; empty where it has none."""
    return said_unit(unit_of(name)) if unit_of_nonlinear(key) != "1" else ""
