"""Which of the tests that tell an effect from others a recording lacks: another load, another speed."""

import re

from ....run.planned_motion.motion_course import ALIKE
from ...document.content import Verdict
from ...mechanisms.library import mechanisms
from ..language.vocabulary import Vocabulary

LOADS = re.compile(r"two loads|second load|load steps|hold under load")
SPEEDS = re.compile(r"(two|three) speeds|another speed|at speed")


def recorded(content: Verdict, words: Vocabulary, id_: str) -> bool:
    """Whether the effect's test needs loads or speeds, and the recording has them."""
    test = mechanisms()[id_].told_apart_by
    asks = bool(LOADS.search(test) or SPEEDS.search(test)) and not mechanisms()[id_].acts_at_rest
    return asks and content["evidence"].get("covered") is not None and not missing(content, words, id_)


def missing(content: Verdict, words: Vocabulary, id_: str) -> list[str]:
    """Of `load` and `speed`, those that the effect's test needs two of, where the recording has only one.

    A second load that only a few strokes had is missing too. Nothing on a rig that is no string, and where an older
    file does not say what was recorded.
    """
    covered = content["evidence"].get("covered")
    if covered is None or not words.twisted:
        return []
    test = mechanisms()[id_].told_apart_by
    (_, most), (slow, fast) = covered["load"], covered["speed_per_s"]
    lacks = {
        "load": bool(LOADS.search(test)) and most > 0.0 and not content["evidence"]["loaded"],
        "speed": bool(SPEEDS.search(test)) and 0.0 < fast < ALIKE * slow,
    }
    return [what for what, lacking in lacks.items() if lacking]
