"""Which of the likeliest explanations a proposed run can tell apart, and which it cannot, in words."""

from itertools import combinations

from ...document.content import Verdict, proposal
from ...document.expected import NextRun
from ...proposal import design
from ..explanations import rivals
from ..language.quantity import listing

Ids = tuple[str, ...]


def sentence(content: Verdict) -> str:
    """Which explanations the run tells apart and which not; nothing for two, or where an older file lacks it."""
    run = proposal(content)
    names = _order(content, run)
    if len(names) < 3:
        return ""
    groups = together(run, names)
    if len(groups) == len(names):
        return f"It can tell all {len(names)} likeliest explanations apart."
    close, own = _close(run), {ids: _called(ids, names) for ids in names}
    if len(close) == len(names) * (len(names) - 1) // 2:
        return f"It is not sure to tell any of the {len(names)} likeliest explanations from all others."
    alone = [own[group[0]] for group in groups if len(group) == 1]
    apart = f"{', '.join(alone[:-1])}, and {alone[-1]}," if len(alone) > 1 and "+" in "".join(alone) else listing(alone)
    parts = [f"it can tell {apart} from the others"] if alone else []
    together_parts = [part for group in groups if len(group) > 1 for part in _left(group, close, own)]
    parts += (
        ["it can tell these apart"] if not alone and all("stay together" in part for part in together_parts) else []
    )
    return f"Of the {len(names)} likeliest explanations {'; '.join([*parts, *together_parts])}."


def _left(group: list[Ids], close: set[frozenset[Ids]], own: dict[Ids, str]) -> list[str]:
    """Which explanations of a group a run leaves together, in words; if it parts some pairs, these come first.

    `close` are the pairs that the run may not part.
    """
    pairs = [frozenset(pair) for pair in combinations(group, 2)]
    if close.issuperset(pairs):
        return [f"{listing([own[ids] for ids in group], 'and')} stay together"]
    clauses, to_part = list[str](), [pair for pair in pairs if pair not in close]
    for pattern, rest in (
        ("it can tell {} from {}", to_part),
        ("it need not tell {} from {}", [*close.intersection(pairs)]),
    ):
        while rest:
            first = max(group, key=lambda ids: sum(ids in pair for pair in rest))
            others = [own[ids] for ids in group if ids != first and frozenset((first, ids)) in rest]
            clauses.append(pattern.format(own[first], listing(others, "or" if "need not" in pattern else "and")))
            rest = [pair for pair in rest if first not in pair]
    return clauses


def some(content: Verdict) -> bool:
    """Whether the run parts some of three or more explanations, but not all."""
    run = proposal(content)
    names = _order(content, run)
    return len(names) > 2 and 1 < len(together(run, names)) < len(names)


def together(run: NextRun, names: list[Ids]) -> list[list[Ids]]:
    """The explanations in groups; the run may not decide between members of one group, directly or over a third."""
    groups = [[ids] for ids in names]
    for pair in _close(run):
        ends = [next(group for group in groups if ids in group) for ids in pair]
        if ends[0] is not ends[1]:
            groups.remove(ends[1])
            ends[0] += ends[1]
    return sorted((sorted(group, key=names.index) for group in groups), key=lambda group: names.index(group[0]))


def _close(run: NextRun) -> set[frozenset[Ids]]:
    """The pairs of explanations between which the run may not decide."""
    apart = (pair for pair in run["pairs"] if not design.decides(pair["gap_now"], pair["gap_then"]))
    return {frozenset(tuple(ids) for ids in pair["ids"]) for pair in apart}


def _order(content: Verdict, run: NextRun) -> list[Ids]:
    """The explanations that were compared, in the order of the verdict."""
    best = [entry["id"] for entry in content["mechanisms"]]
    ordered = [tuple(ids) for pair in run.get("pairs", []) for ids in pair["ids"]]
    rank = [tuple(sorted(ids)) for ids in (best, *content["alternatives"])]
    places = {ids: rank.index(tuple(sorted(ids))) if tuple(sorted(ids)) in rank else len(rank) for ids in ordered}
    return sorted(dict.fromkeys(ordered), key=lambda ids: places[ids])


def _called(ids: Ids, names: list[Ids]) -> str:
    """An explanation without the effects that all compared ones share, if others are left."""
    shared = set.intersection(*map(set, names))
    return rivals.called([id_ for id_ in ids if id_ not in shared] or list(ids))
