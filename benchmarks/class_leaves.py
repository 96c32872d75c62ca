"""What the class of a mechanism leaves of other authors' laws of it, calibration free: rms over the mismatch."""

import argparse
import statistics
import sys
from collections import defaultdict
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from pipeline.diagnosis.choice import candidates
from pipeline.diagnosis.choice.search import Search
from pipeline.diagnosis.fit import calibrate
from pipeline.diagnosis.fit.linear import Linear
from pipeline.diagnosis.numerics.noise import white
from pipeline.diagnosis.study import engine
from pipeline.proof.teach.lesson import recorded
from pipeline.rig.authors import authors, names
from pipeline.rig.authors.interface import Asked, OutOfReach

KAPPAS = (10.0, 5.0, 2.5)  # noise floors: the largest that the rig can show
REFINED = 2  # times


def left(author: str, effect: str, seed: int) -> tuple[str, float] | None:
    """The law that the seed draws, and the share of its mismatch that the class leaves, noise taken off."""
    for kappa in KAPPAS:
        try:
            made = authors()[author].make(Asked(seed, (effect,), (kappa,), "rich"))
            break
        except OutOfReach:
            continue
    else:
        return None
    problem = engine.make_problem([recorded({"run": "case", **made.content}, made.table)])
    problem, _ = calibrate.without_outliers(problem, calibrate.base(problem))
    base = calibrate.base(problem)
    more = candidates.suggested(problem, base)
    options = {effect: candidates.catalogue(problem, more).get(effect, [])}
    if not options[effect]:
        return None
    floor = engine.noise_of(problem, base, candidates.without_physics(problem, more), engine.SURPRISES).floor
    noise, state = white(floor), base
    for _ in range(REFINED + 1):
        search = Search(Linear(problem, state, noise, options))
        one = search.explain((effect,))
        state = calibrate.refine(problem, noise, search.linear.state_of(one.fit, one.keys))
        options = candidates.with_refined(problem, options, [state])
    sizes = [
        np.mean(np.square((problem.measured - problem.simulate(at))[: problem.rows])) - floor**2 for at in (state, base)
    ]
    law = str(made.truth["effects"][0]["law"])
    return law, float(np.sqrt(max(sizes[0], 0.0) / max(sizes[1], 1e-300)))


def main() -> None:
    """Print each law with the median share that is left, by mechanism; the worst laws last."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=4, help="cases of each effect of each author")
    parser.add_argument("--effect", nargs="*", metavar="ID", help="only these mechanisms")
    parser.add_argument("--seed", type=int, default=77_000_000, help="of the first case")
    given = parser.parse_args()
    found: dict[tuple[str, str, str], list[float]] = defaultdict(list)
    for author in names():
        for effect in authors()[author].laws:
            left_out = effect.startswith("x_") or (given.effect and effect not in given.effect)
            for number in range(0 if left_out else given.seeds):
                told = left(author, effect, given.seed + 31 * number)
                if told:
                    found[effect, author, told[0]].append(told[1])
    print("| mechanism | author | law | cases | left, median |\n|---|---|---|---|---|")
    for (effect, author, law), shares in sorted(found.items(), key=lambda one: (one[0][0], statistics.median(one[1]))):
        print(f"| {effect} | {author} | {law} | {len(shares)} | {100.0 * statistics.median(shares):.1f} % |")


if __name__ == "__main__":
    main()
