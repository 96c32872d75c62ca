"""How far verdicts move when a number that decides them is halved or doubled: one study a case, its end again."""

import argparse
import sys
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from pipeline.diagnosis.choice import judged, outcome, search
from pipeline.diagnosis.numerics.judge import judge
from pipeline.diagnosis.study import engine
from pipeline.proof.teach.lesson import PROTOCOLS, recorded
from pipeline.proof.verdicts import JUDGES
from pipeline.rig.authors import authors, names
from pipeline.rig.authors.interface import Asked, OutOfReach

CHANGES: dict[str, tuple[Any, str, tuple[float, float]]] = {
    "judged.HELD": (judged, "HELD", (0.7, 0.9)),
    "judged.UNKNOWN": (outcome, "UNKNOWN", (0.3, 0.5)),
    "search.LEAST_GAIN": (search, "LEAST_GAIN", (5.0, 20.0)),
    "search.LEAST_EFFECT": (search, "LEAST_EFFECT", (0.1, 0.4)),
    "search.EXPLAINED": (outcome, "EXPLAINED", (0.8, 0.95)),
    "outcome.UNKNOWN_FROM": (outcome, "UNKNOWN_FROM", (0.18, 0.7)),
    "outcome.CANCELS": (outcome, "CANCELS", (4.0, 16.0)),
    "outcome.HELPED": (outcome, "HELPED", (0.5, 0.9)),
}
DETECTING = ("search.LEAST_GAIN", "search.LEAST_EFFECT")
CONTROLS, OUTSIDE = 8, 6  # of each author, beside one case of each effect
SIZES = (0.5, 12.0)


def cases(author: str, seed: int) -> Iterator[Asked]:
    """One case of each effect of an author, some of what no library has, and some of nothing."""
    draw = np.random.default_rng(seed)
    known = sorted(authors()[author].laws)
    outside = [name for name in known if name.startswith("x_")]
    inside = [name for name in known if not name.startswith("x_")]
    chosen = [*((name,) for name in inside), *((str(draw.choice(outside)),) for _ in range(OUTSIDE))]
    for number, effects in enumerate([*chosen, *[()] * CONTROLS]):
        kappas = tuple(float(SIZES[0] * (SIZES[1] / SIZES[0]) ** draw.random()) for _ in effects)
        yield Asked(seed + number, effects, kappas, PROTOCOLS[int(draw.integers(len(PROTOCOLS)))])


@contextmanager
def changed(name: str, value: float) -> Iterator[None]:
    """One of the numbers at another value."""
    module, constant, _ = CHANGES[name]
    with mock.patch.object(module, constant, value):
        yield


def seen(found: search.Search, floor: float) -> bool:
    """Whether something is missing at all, as the present numbers see it."""
    return bool(found.forward(floor, largest=1).ids)


def again(problem: engine.Problem, told: tuple[Any, ...], name: str, value: float) -> outcome.Study:
    """The verdict with one number changed: its end again, or the whole study where something else is detected."""
    nominal, base, noise, best, shares, found, random = told[1:]
    with changed(name, value):
        if name in DETECTING and seen(found, noise.floor) != bool(shares.sets):
            if not shares.sets:
                return engine.study(problem)
            return outcome.decide(told[0], nominal, base, noise, base, judged.NOTHING, found, random)
        if name == "judged.HELD" and shares.likely:
            ids = list(shares.likely)
            places = judged.held(np.array([shares.likely[one] for one in ids]))
            first = shares.sets[:1]
            sets = [*first, *(found.explain(ids[place]) for place in places if ids[place] != first[0].ids)]
            shares = replace(shares, sets=sets)
        return outcome.decide(told[0], nominal, base, noise, best, shares, found, random)


def score(asked: Asked, found: outcome.Study) -> str:
    """How a verdict compares with what was hidden."""
    truth = {name for name in asked.effects if not name.startswith("x_")}
    firm, named = found.verdict == "explained", found.verdict in ("explained", "ambiguous")
    right = named and any(set(one.ids) == truth for one in found.sets)
    if not asked.effects:
        return "control named" if named else "control left alone"
    if not truth:
        return "outside: firm name" if firm else f"outside: {'unknown' if found.verdict == 'unknown' else 'other'}"
    if right:
        return "exactly" if firm else "in the set"
    return "firm and wrong" if firm else "unknown" if found.verdict == "unknown" else "other"


def main() -> None:
    """Print how often each outcome came, as the numbers are and with each of them changed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=900_000, help="of the first case")
    given = parser.parse_args()
    table: dict[str, Counter[str]] = {}
    for author in names():
        for asked in cases(author, given.seed):
            try:
                made = authors()[author].make(asked)
            except OutOfReach:
                continue
            case = recorded({"run": "case", **made.content}, made.table)
            problem = engine.make_problem([case], by=judge(JUDGES / f"without_{author}.json"))
            with mock.patch.object(engine, "decide", wraps=outcome.decide) as end:
                found = engine.study(problem)
            table.setdefault("as it is", Counter())[score(asked, found)] += 1
            for name, (_, _, values) in CHANGES.items():
                for value in values:
                    moved = again(problem, end.call_args.args, name, value)
                    table.setdefault(f"{name} = {value:g}", Counter())[score(asked, moved)] += 1
    for name, count in table.items():
        print(f"{name:28}", ", ".join(f"{key} {number}" for key, number in sorted(count.items())), flush=True)


if __name__ == "__main__":
    main()
