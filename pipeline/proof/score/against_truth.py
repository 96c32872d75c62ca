"""How a verdict compares with the truth: one word for each case."""

from ...ground.outside_library import is_outside
from ..verdict_json import VerdictJson

QUIET = ("consistent", "parameters")
RIGHT = ("exact", "tie with the truth", "quiet", "unknown as it should")
OUTCOMES = (*RIGHT, "extra", "part", "wrong", "tie without the truth", "missed", "unknown", "false alarm", "refused")


def sets_of(verdict: VerdictJson) -> list[frozenset[str]]:
    """Every set of mechanisms that a verdict names or cannot rule out, the best one first."""
    best = frozenset(mechanism["id"] for mechanism in verdict.get("mechanisms", []))
    return [best, *(frozenset(ids) for ids in verdict.get("alternatives", []))] if best else []


def said(verdict: VerdictJson) -> str:
    """The verdict's word; a verdict that names only mechanisms outside the library counts as `unknown`."""
    sets = sets_of(verdict)
    only_own = bool(sets) and all(is_outside(name) for ids in sets for name in ids)
    return "unknown" if only_own else str(verdict["verdict"])


def outcome(verdict: VerdictJson | None, truth: frozenset[str], nameless: bool) -> str:
    """One of OUTCOMES; `truth` is empty for a control, and `nameless` if no name of the library is right."""
    if verdict is None:
        return "refused"
    word, sets = said(verdict), sets_of(verdict)
    if not truth and not nameless:
        return "quiet" if word in QUIET else "false alarm"
    if word in QUIET:
        return "missed"
    if word == "unknown":
        return "unknown as it should" if nameless else "unknown"
    if word == "ambiguous":
        return "tie with the truth" if truth in sets and not nameless else "tie without the truth"
    if nameless:
        return "wrong"
    named = sets[0] if sets else frozenset()
    if named == truth:
        return "exact"
    return "extra" if named > truth else "part" if named and named < truth else "wrong"
