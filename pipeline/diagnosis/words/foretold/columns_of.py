"""The columns of the table of foretold numbers: its explanations, their heads, and the likely ones that it lacks."""

from ...document.content import Verdict
from ...document.explanations import share_of
from ..explanations import rivals
from ..language.quantity import listing, percent
from .foretold_numbers import LEAST, compared, probability

NAMED = 3  # explanations that no table has, by name


def kept(content: Verdict) -> list[set[str]]:
    """The explanations that the verdict keeps, as sets of their effects."""
    return [{entry["id"] for entry in content["mechanisms"]}, *map(set, content["alternatives"])]


def not_in(content: Verdict) -> list[str]:
    """The likely rivals that the table lacks, and why; nothing where it lacks none."""
    first, *others = compared(content)
    foretold = [set(each["ids"]) for each in (first, *others)]
    more = [ids for ids in content["alternatives"] if set(ids) not in foretold]
    if more:
        names = listing([_called(content, ids) for ids in more[:NAMED]])
        rest = f" and {len(more) - NAMED} more" * (len(more) > NAMED)
        return [f"Likely too, but not in the table: {names}{rest}. Only {len(foretold)} explanations are foretold."]
    shares = [probability(content, other["ids"]) or 0.0 for other in others]
    id_sets = [set(each["ids"]) for each in content["evidence"]["expected"]["explanations"]]
    rivals_left = [
        each
        for each in rivals.entries(content, "beaten", "not needed")
        if set(each["ids"]) not in id_sets and share_of(each) > min(shares, default=1.0)
    ]
    if content["verdict"] != "explained" or not rivals_left:
        return []
    likeliest = max(rivals_left, key=share_of)
    name = _called(content, likeliest["ids"])
    if set(first["ids"]) < set(likeliest["ids"]):
        return [f"Not in the table: {name}, which only adds to the best one."]
    return [f"Not in the table: {name}, of which nobody would see a number differ from the best one's."]


def head(content: Verdict, ids: list[str], shared: set[str]) -> str:
    """An explanation with its probability, without the effects that all explanations share, if others are left."""
    apart = [id_ for id_ in ids if id_ not in shared]
    own = f"{'with ' * (0 < len(apart) < len(ids))}{rivals.called(apart or ids)}"
    return f"{own}{_share(content, ids)}"


def _called(content: Verdict, ids: list[str]) -> str:
    """An explanation in full with its probability, if it has one."""
    return f"{rivals.called(ids)}{_share(content, ids)}"


def _share(content: Verdict, ids: list[str]) -> str:
    share = probability(content, ids)
    return f" ({percent(share)})" if share is not None and share >= LEAST else ""
