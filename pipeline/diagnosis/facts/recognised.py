"""How the recogniser classes a mismatch that nothing explains: each single effect, and physics outside the library.

Nothing here decides: the verdict is already made.
"""

import math

from ...ground.outside_library import is_outside
from ..choice.outcome import Study
from ..document.evidence import Evidence
from ..numerics.recogniser import DOUBT, OF_ALL, OF_EXPLANATION


def recognised(study: Study) -> Evidence:
    """`looks_like`: shares of 1 by effect, and `outside`; nothing where an effect is named or no class was found."""
    weighed = study.judged.weighed
    if study.verdict != "unknown" or not weighed or OF_ALL not in weighed[0].signs:
        return {}
    own = OF_EXPLANATION[0]
    singles = {each.ids[0]: each.signs[own] for each in weighed if len(each.ids) == 1 and own in each.signs}
    shares = {id_: _share(sign) for id_, sign in singles.items() if not is_outside(id_)}
    return {"looks_like": {**shares, "outside": _share(weighed[0].signs[OF_ALL])}}


def _share(sign: float) -> float:
    """The share whose logarithm a sign is."""
    return max(math.exp(sign) - DOUBT, 0.0)
