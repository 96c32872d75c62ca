"""What an explanation leaves that was fitted to the whole recording, beside the size of an effect in it; in words."""

import math

from ...document.content import Verdict
from ...document.made_keys import amount, by_name, interval
from ..language.quantity import size
from ..language.vocabulary import Vocabulary
from . import unseen

MUCH = 0.1  # of an effect's own part: where more is left, another law, and so another effect, may be at work
LEFT = "what is still missing, {} without the noise, is more than a tenth as large"


def much_left(content: Verdict, words: Vocabulary, id_: str) -> str:
    """Why an effect is not sure though it is likely: much is left beside it; ends a phrase, or is empty."""
    noises = unseen.fitted_times(content, words, named=True)
    if noises is None or not unseen.inexact(content, words):
        return ""
    whole_rms = {entry["id"]: interval(entry, f"rms_{words.ending}")["value"] for entry in content["mechanisms"]}
    own_rms = by_name(content["evidence"], f"beyond_dimensions_{words.ending}").get(id_, whole_rms.get(id_, 0.0))
    left_rms = math.sqrt(noises**2 - 1.0) * amount(content["evidence"], f"floor_{words.ending}")
    return LEFT.format(size(left_rms, words.unit)) if left_rms > MUCH * own_rms else ""
