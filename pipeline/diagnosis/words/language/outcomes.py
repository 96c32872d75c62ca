"""The meaning of each outcome of a run that tests what a nameless mismatch follows, by the title of the run."""

from .text_table import aligned
from .vocabulary import Vocabulary

HEAD = ["if what is missing", "it would mean"]
OUTCOMES = {
    "another load, then half the speed": [
        ("stays as large at the same {motion}", "it follows the {motion} alone: geometry, or the scale of a sensor"),
        ("grows with the load", "something yields or rubs: stretch, a frame that bends, friction"),
        ("has another size at half the speed", "it follows the speed or the time: a lag, losses, creep"),
    ],
    "reversals within a stroke, at two speeds": [
        ("is there after each reversal, at both speeds", "play or friction: it follows the direction alone"),
        ("shrinks at the lower speed", "a lag, or losses that follow the speed"),
        ("depends on how far the way went before", "a material that remembers: hysteresis of more than one width"),
    ],
    "a rest at the lowest twist, then one stroke": [
        ("goes on at the same pace in the rest", "a sensor that drifts, or the surroundings"),
        ("goes on in the rest, slower and slower", "creep, or something that cools"),
        ("stands in the rest", "it came with the strokes: settling, wear"),
    ],
    "a rest with the motor off, then one stroke": [
        ("swings in the rest too", "it comes from outside of the motor: the load, the table, the sensor"),
        ("stops in the rest", "it comes from the motor or its control"),
    ],
    "half and a quarter of the speed": [
        ("shrinks with the speed", "a lag, or losses that follow the speed"),
        ("grows as the stroke takes longer", "creep, or a drift"),
        ("stays as large", "it does not follow the speed: geometry, play, friction"),
    ],
    "a slow stroke": [
        ("comes back at the same angle of each turn", "geometry of the motor's side: an eccentric shaft, a gear"),
        ("comes back after the same time", "a vibration, or a sensor's disturbance"),
    ],
    "abrupt stops at half twist": [
        ("rings on after each stop", "a mass on something elastic"),
        ("follows each stop late and once", "a lag"),
        ("stays as it was", "it does not follow starts and stops"),
    ],
    "load steps at half twist": [
        ("follows each step at once and comes back", "stretch of the {string} or of the frame"),
        ("goes on after each step", "something flows: creep"),
        ("does not come back", "friction, or a {string} that stays longer"),
    ],
    "a long rest while the rig warms by 5 K, then one stroke": [
        ("moves with the temperature in the rest", "expansion, or a sensor that drifts with it"),
        ("stands in the rest", "the temperature only went along: it comes with the motion"),
    ],
    "one stroke under half the load": [
        ("halves with the load", "friction or stretch: both follow the load"),
        ("stays as large", "it does not follow the load: play, geometry"),
    ],
}  # fmt: skip


def table(title: str, words: Vocabulary) -> list[str]:
    """The meaning of each outcome of the run with this title, a line each; nothing for other runs."""
    rows = [[cell.format(**words.fields) for cell in row] for row in OUTCOMES.get(title, ())]
    return aligned([HEAD, *rows]) if rows else []
