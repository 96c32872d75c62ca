"""Where the reading of an unknown mismatch goes off for a while and comes back."""

from ..choice.outcome import Study
from ..document.content import Part


def gone_off(study: Study, ending: str) -> Part:
    """`excursions`: when, for how long and by how much, in s and in the reading's unit `ending`; nothing if none is."""
    entries = [{"at_s": each.at_s, "lasts_s": each.lasts_s, f"size_{ending}": each.size} for each in study.gone_off]
    return {"excursions": entries} if entries else {}
