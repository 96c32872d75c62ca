"""Effects that are too small for the sensor's steps: whatever their probability, they are not called sure.

A reading that is rounded errs by up to half a step, and where little noise stirs it that error repeats from stroke to
stroke as an effect does (Widrow and Kollár, Quantization Noise, 2008).
"""

import math

from ...document.content import Verdict
from ...document.effects_named import MechanismEntry
from ...document.made_keys import amount, amount_or_none, by_name, interval
from ..language.quantity import size
from ..language.vocabulary import Vocabulary

STIRRED = 0.6  # of a step: noise of single samples that is larger makes averages as fine as one likes
ROUNDED = 1.0 / math.sqrt(12.0)  # of a step: the standard deviation of what rounding takes


def too_small(content: Verdict, words: Vocabulary, id_: str) -> str:
    """Why an effect is too small to be called sure; ends a phrase with `while`. Else empty, also if unknown.

    Only the part of the effect counts that no dimension could imitate.
    """
    step = amount_or_none(content["evidence"], f"resolution_{words.ending}") or 0.0
    if not step or amount(content["fit"], f"noise_floor_{words.ending}") > STIRRED * step:
        return ""
    own = min((_own(content, entry, words) for entry in content["mechanisms"] if entry["id"] == id_), default=math.inf)
    if own >= ROUNDED * step:
        return ""
    return f"{size(own, words.unit)} is too small for a sensor that reads in steps of {size(step, words.unit)}"


def _own(content: Verdict, entry: MechanismEntry, words: Vocabulary) -> float:
    """The rms of an effect, or of its part that no dimension could imitate."""
    beyond = by_name(content["evidence"], f"beyond_dimensions_{words.ending}").get(entry["id"], math.inf)
    return min(float(interval(entry, f"rms_{words.ending}")["value"]), float(beyond))
