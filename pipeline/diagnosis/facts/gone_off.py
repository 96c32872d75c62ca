"""Where the reading of an unknown mismatch goes off for a while and comes back."""

from ..choice.outcome import Study
from ..document.evidence import Evidence, Excursion
from ..document.keyed import with_made


def gone_off(study: Study, ending: str) -> Evidence:
    """`excursions`: when, for how long and by how much, in s and in the reading's unit `ending`; nothing if none is."""
    times: list[tuple[Excursion, float]] = [
        ({"at_s": each.at_s, "lasts_s": each.lasts_s}, each.size) for each in study.gone_off
    ]
    entries = [with_made(when, {f"size_{ending}": size}) for when, size in times]
    return {"excursions": entries} if entries else {}
