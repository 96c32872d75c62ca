"""How probable each explanation is, on the page: the kept ones, the next best, the others, and none of the library."""

from ...document.bounds import of_later_run
from ...document.content import Verdict
from ...document.explanations import share_of
from ...mechanisms.interface import physics
from ..language.quantity import listing, percent, quantity
from ..language.text_table import aligned
from ..language.vocabulary import Vocabulary
from ..measured import to_measure, tolerances
from ..measured.dimensions import name_of
from . import closest, not_named, probability, rivals

HEADING = "How probable each explanation is"
KNOWS_BETTER = "Know one better, or less well? Write that into run.yaml (`tolerance`), and diagnose again."
BARE = "Explanations, the best one first"
NO_PERCENTAGES = "No percentages on this rig: they were learnt on strings."
KEPT, FEW = 5, 3  # of them by name, without and with probabilities; the others are counted
LEFT_OUT = 3  # of those that are no names, in the table
WORTH = 0.05  # a probability from which on the next best is named
OTHERS, NONE = "other explanations of the library", "physics that the library lacks"


def lines(content: Verdict) -> list[str]:
    """The table of explanations on the page; nothing where nothing is named or no probability is known.

    Nor where one explanation alone is kept, since the first line has its probability.
    """
    if content["verdict"] not in ("explained", "ambiguous") or not probability.known(content):
        return []
    kept, out = kept_shares(content), not_named.entries(content)
    if len(kept) < 2 and not out:
        return []
    rows = [[name, percent(share), "the best one" if place == 0 else ""] for place, (name, share) in enumerate(kept)]
    if len(rows) > FEW:
        rest = kept[FEW - 1 :]
        rows = [*rows[: FEW - 1], [f"{len(rest)} more (details.txt)", percent(sum(share for _, share in rest)), ""]]
    none = content["evidence"].get("probability_of_none") or 0.0
    sets = [entry["ids"] for entry in rivals.entries(content, "named", "tied")]
    others_share = max(1.0 - none - sum(share for name, share in kept if physics(tuple(name.split(" + ")))), 0.0)
    for entry in out[:LEFT_OUT]:
        rows.append([rivals.called(entry["ids"]), percent(share_of(entry)), "left out: see below"])
        others_share = max(others_share - share_of(entry), 0.0)
    following = next_best(content)
    if following:
        rows.append([following[0], percent(following[1]), "less likely"])
        others_share = max(others_share - following[1], 0.0)
    rows += [[OTHERS, percent(others_share), ""], [f"{NONE}{probability.stand_ins(sets)}", percent(none), ""]]
    return [*aligned(rows), *closest.stand_ins(sets), *not_named.lines(content)]


def bare(content: Verdict, words: Vocabulary) -> list[str]:
    """The explanations that tie, a line each, on a rig without probabilities; nothing elsewhere, or without a tie.

    The error beside each is what it leaves of the recording.
    """
    if content["verdict"] != "ambiguous" or probability.known(content):
        return []
    sets = [[entry["id"] for entry in content["mechanisms"]], *content["alternatives"]]
    entry_by_ids = {tuple(sorted(each["ids"])): each for each in rivals.entries(content, "named", "tied")}
    rows = []
    for ids in sets[:KEPT]:
        explanation = entry_by_ids.get(tuple(sorted(ids)))
        rows.append([rivals.called(ids), f"leaves {rivals.left(explanation, content, words)}" if explanation else ""])
    more = [f"{len(sets) - KEPT} more (details.txt)"] if len(sets) > KEPT else []
    return [*aligned(rows), *more, NO_PERCENTAGES]


def stands_on(content: Verdict, words: Vocabulary) -> list[str]:
    """The tolerances that the names depend on: those of dimensions that calibration moved by more than one."""
    sigmas = {name: abs(sigma) for name, sigma in content["evidence"]["moved_sigma"].items()}
    moved = {name: sigma for name, sigma in sigmas.items() if sigma > 1.0 and not of_later_run(name)}
    tolerance_by_name = {
        name: tolerances.marked(content, name, words) for name in sorted(moved, key=lambda name: -moved[name])
    }
    again = to_measure.to_measure(content)  # the table of step 1 has the tolerances of these
    more = {name: tolerance for name, tolerance in tolerance_by_name.items() if tolerance and name not in again}
    if again:
        also = f" and of the {listing([name_of(name) for name in more])}" if more else ""
        lines = [f"All this stands on the tolerances of step 1{also}."]
    else:
        named = listing([f"{name_of(name)} {tolerance}" for name, tolerance in more.items()])
        lines = [f"All this stands on these tolerances: {named}. {KNOWS_BETTER}"] if named else []
    stiffness = content["parameters"].get("stiffness_n_per_mm")
    if stiffness:
        guess = quantity(stiffness["nominal"], "N/mm", 3)
        lines.append(f"The stiffness of {guess} is assumed: run.yaml gives none.")
    return lines


def kept_shares(content: Verdict) -> list[tuple[str, float]]:
    """The explanations that the verdict keeps by name, each with its probability, the best one first."""
    best, ties = rivals.entries(content, "named"), rivals.entries(content, "tied")
    kept = [*best, *sorted(ties, key=lambda explanation: -share_of(explanation))]
    return [(rivals.called(explanation["ids"]), share_of(explanation)) for explanation in kept]


def next_best(content: Verdict) -> tuple[str, float] | None:
    """The likeliest explanation that is not kept, with its probability, if it is worth a word."""
    out = [entry["ids"] for entry in not_named.entries(content)]
    others = [other for other in rivals.entries(content, "beaten", "not needed") if other["ids"] not in out]
    likeliest = max(others, key=share_of, default=None)
    share = share_of(likeliest) if likeliest else 0.0
    return (rivals.called(likeliest["ids"]), share) if likeliest and share >= WORTH else None
