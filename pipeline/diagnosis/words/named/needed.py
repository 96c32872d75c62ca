"""What to think of an effect of the best explanation that is less likely than not, in words."""

from ...document.content import Verdict
from ..language.quantity import listing, percent, reaches
from . import certainty

ABSENT = ("more likely absent than", "about as likely absent as")  # below `certainty.EVEN`, and from there on

IN_PLACE = "{} open: explanations of {} have {}, and the others that are likely have another effect in its place."


def lines(content: Verdict) -> list[str]:
    """What to think of an effect of the best explanation that is less likely than not."""
    best = {entry["id"] for entry in content["mechanisms"]}
    others = [set(ids) for ids in content["alternatives"]]
    lines, in_place = list[str](), dict[str, list[str]]()
    less = {id_: share for id_, share in certainty.known(content).items() if not reaches(share, certainty.PROBABLE)}
    for id_, share in less.items():
        rest = best - {id_}
        swapped = [ids - rest for ids in others if ids >= rest]
        if others and len(swapped) == len(others) and all(len(swap) == 1 for swap in swapped):
            instead = dict.fromkeys(other for swap in swapped for other in sorted(swap))
            lines.append(f"One of {listing([id_, *instead])} is needed; it is not known which.")
        elif others and all(ids - best for ids in others if id_ not in ids) and any(id_ not in ids for ids in others):
            in_place.setdefault(percent(share), []).append(id_)
        else:
            lines.append(f"{id_} is {ABSENT[share >= certainty.EVEN]} at work ({percent(share)}).")
    for share_of_all, ids in in_place.items():
        are, each = ("are", "each") if ids[1:] else ("is", "it")
        lines.append(IN_PLACE.format(f"{listing(ids)} {are}", share_of_all, each))
    return lines
