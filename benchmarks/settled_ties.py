"""How often a tie of a poor recording is settled within two more runs: the runs that `settle` proposes, and others.

Concealed single effects on the poor protocol, by every author; each tie goes on, on the same string, in four ways.
"""

import argparse
import itertools
import random
import sys
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, cast

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import pandas as pd
from kept_cases import kept_cases
from scipy.stats import binomtest

from pipeline.capture.motion_program import as_legs
from pipeline.diagnosis.choice.outcome import Study
from pipeline.diagnosis.in_memory import diagnosed
from pipeline.diagnosis.numerics.judge import judge
from pipeline.diagnosis.proposal.foretold import foretold, rivals
from pipeline.diagnosis.proposal.legs import CANDIDATES, Rig
from pipeline.diagnosis.proposal.legs import Leg as Part
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.proof import carry_on
from pipeline.proof.case import performed
from pipeline.proof.conceal_batch import drawn
from pipeline.proof.plan import Planned, effect_names
from pipeline.proof.size import OutOfReach as NotOnRig
from pipeline.rig.authors import authors
from pipeline.rig.authors.interface import Asked, Leg, OutOfReach
from pipeline.run.description import Run, parse_run
from pipeline.run.table.recorded_table import to_samples
from pipeline.settle.choose import Budget, chosen, firm
from pipeline.settle.proposed import ProposedRun
from pipeline.settle.step import Step

RIG = "rig"  # the project's own, which has no judge of its own
JUDGES = Path(__file__).resolve().parents[1] / "pipeline" / "proof" / "teach" / "judges"
KAPPAS = (1.0, 6.0)  # noise floors on the poor protocol
RUNS = 2  # after the first
BUDGET = Budget(RUNS, 1e9, 10**9)
Recording = tuple[dict[str, Any], pd.DataFrame]


@dataclass(frozen=True)
class Case:
    """One effect that somebody conceals."""

    author: str
    seed: int
    effect: str
    kappa: float


@dataclass(frozen=True)
class Ended:
    """How a tie ended in one way: what was said last, right or not, after how many runs, strokes and seconds."""

    way: str
    verdict: str
    right: bool
    runs: int
    strokes: int
    seconds: float


def cases(seed: int) -> list[Case]:
    """Every effect of every author once, drawn sizes, in a drawn order."""
    draw, found = random.Random(seed), []
    known = {name: [law for law in author.laws if not law.startswith("x_")] for name, author in authors().items()}
    for author, effects in {RIG: effect_names(False), **known}.items():
        for number, effect in enumerate(sorted(effects)):
            kappa = KAPPAS[0] * (KAPPAS[1] / KAPPAS[0]) ** draw.random()
            found.append(Case(author, seed + number, effect, round(kappa, 2)))
    draw.shuffle(found)
    return found


def recordings(case: Case, runs: Sequence[Sequence[Part]]) -> list[Recording]:
    """The first recording, and those of the runs after it, on one string; raises OutOfReach."""
    if case.author == RIG:
        return by_rig(case, runs)
    legs = tuple(Leg(*leg) for run in runs for leg in run)
    made = authors()[case.author].make(Asked(case.seed, (case.effect,), (case.kappa,), "poor", legs))
    if not made.table.notna().all(axis=None):
        raise OutOfReach("the law of this effect ends where the legs lead")
    return cut(made.content, made.table, runs, made.truth.get("protocol_s", float("inf")))


def by_rig(case: Case, runs: Sequence[Sequence[Part]]) -> list[Recording]:
    """The same of the project's own rig, whose load cell is always read."""
    planned = Planned("case", case.seed, "single", "poor", (case.effect,), (case.kappa,))
    concealed = replace(drawn(planned), load_cell=True)
    content = {key: value for key, value in concealed.bench.described("case", False).items() if key != "run"}
    found: list[Recording] = [(content, performed(concealed).table)]
    if runs:
        legs = [carry_on.Leg(*leg) for run in runs for leg in run]
        begins_s = float(concealed.protocol.told.time_s[-1])
        found += cut(content, carry_on.gone_on(concealed, legs, 3).table, runs, begins_s)[1:]
    return found


def cut(content: dict[str, Any], table: pd.DataFrame, runs: Sequence[Sequence[Part]], at_s: float) -> list[Recording]:
    """A long recording cut where its runs end; each run's clock begins with it."""
    found, since_s = [], -1.0
    for run in [*runs, []]:
        part = table[(table["time_s"] > since_s) & (table["time_s"] <= at_s)].reset_index(drop=True)
        if len(part):
            part["time_s"] -= part["time_s"].iloc[0]
        found.append((content, part))
        since_s, at_s = at_s, at_s + sum(leg[0] for leg in run)
    return found


def asked(case: Case, made: Sequence[Recording]) -> tuple[dict[str, Any], Study, Run]:
    """What the diagnosis says of recordings together, by a judge that does not know their author."""
    runs, before = [], 0
    for number, (content, table) in enumerate(made):
        string = content["string"] | {"id": "one", "strokes_before": before}
        path = Path(f"run-{number}/run.yaml")
        run = parse_run({**content, "run": f"run-{number}", "string": string}, path)
        runs.append(RecordedRun.cut(run, to_samples(run, table, path, path)))
        before += strokes(table["motor_turns"].to_numpy())
    by = None if case.author == RIG else judge(JUDGES / f"without_{case.author}.json")
    content, found = diagnosed(runs, by=by)
    return content, found, runs[0].run


def strokes(turns: Any) -> int:
    """How often the twist rises through the middle of its range."""
    high = turns > 0.5 * (turns.min() + turns.max())
    return int((high[1:] & ~high[:-1]).sum())


def spent(legs: Sequence[Part]) -> tuple[int, float]:
    """Strokes begun and seconds of some legs."""
    ups = sum(1 for before, leg in itertools.pairwise(legs) if leg[1] > before[1] + 1e-6)
    return ups, sum(leg[0] for leg in legs)


def proposed(found: Study, run: Run, draw: random.Random) -> list[Part]:
    """The run that `settle` would make; none where it would end the loop."""
    step, _ = chosen(cast(list[ProposedRun], foretold(found, run, True)), 1, None, BUDGET)
    return [] if step is None else under_loads(step)


def under_loads(step: Step) -> list[Part]:
    """The legs of a step; one that tells no load has the one that hangs."""
    hanging_n = step.proposal["load"] or 0.0
    return [(leg.seconds, leg.turns, hanging_n if leg.load_n is None else leg.load_n) for leg in as_legs(step.legs)]


def repeated(found: Study, run: Run, draw: random.Random) -> list[Part]:
    """The last strokes again, four of them."""
    rig = Rig(found.problem.record)
    return [rig.home(), *rig.stroke() * 4]


def at_random(found: Study, run: Run, draw: random.Random) -> list[Part]:
    """One of the candidates, whichever."""
    rig = Rig(found.problem.record)
    return [rig.home(), *CANDIDATES[draw.choice(sorted(CANDIDATES))](rig)]


def rich(found: Study, run: Run, draw: random.Random) -> list[Part]:
    """A fixed protocol: nine strokes of three speeds under three loads, with a partial one, holds and rests."""
    rig = Rig(found.problem.record)
    legs = [rig.home()]
    for number, (slower, load) in enumerate((s, w) for w in (1.0, 2.0, 0.5) for s in (1.0, 2.0, 0.5)):
        top = 0.6 if number in (4, 7) else 1.0
        legs += [*rig.stroke(top, slower, load, (0.2, 5.0, 20.0)[number % 3]), *rig.rest((2.0, 10.0, 40.0)[number % 3])]
    return legs


WAYS: dict[str, Callable[[Study, Run, random.Random], list[Part]]] = {
    "settle": proposed, "repeated": repeated, "random": at_random, "rich": rich,
}  # fmt: skip


def gone(case: Case, way: str, first: tuple[dict[str, Any], Study, Run]) -> Ended:
    """A tie that goes on in one way until a verdict is firm, or the runs are spent."""
    draw = random.Random(f"{case} {way}")
    content, found, run = first
    runs: list[list[Part]] = []
    verdicts = [(content["verdict"], [one["id"] for one in content["mechanisms"]])]
    while len(runs) < RUNS and not firm(verdicts, doubted=way == "settle" and bool(rivals(found))):
        legs = WAYS[way](found, run, draw)
        if not legs:
            break
        runs.append(legs)
        content, found, run = asked(case, recordings(case, runs))
        verdicts.append((content["verdict"], [one["id"] for one in content["mechanisms"]]))
    names = [one["id"] for one in content["mechanisms"]]
    right = content["verdict"] == "explained" and names == [case.effect]
    counts = [spent(legs) for legs in runs]
    return Ended(way, content["verdict"], right, len(runs), sum(n for n, _ in counts), sum(s for _, s in counts))


def measured(case: Case) -> dict[str, Any]:
    """A case: whether it ties, and how each way ends; `none` where its author cannot show the effect."""
    line: dict[str, Any] = {**asdict(case), "verdict": "none", "ways": []}
    try:
        first = asked(case, recordings(case, []))
    except (OutOfReach, NotOnRig):
        return line
    line["verdict"] = first[0]["verdict"]
    sets = [one["ids"] for one in first[0]["evidence"]["explanations"]] if line["verdict"] == "ambiguous" else []
    line["held"] = [case.effect] in sets
    for way in WAYS if line["verdict"] == "ambiguous" else ():
        try:
            line["ways"].append(asdict(gone(case, way, first)))
        except (OutOfReach, NotOnRig) as error:
            line["ways"].append({"way": way, "verdict": f"cannot be made: {error}", "right": False, "runs": None})
    return line


def table(lines: Sequence[dict[str, Any]]) -> str:
    """Ties settled by each way, by author, with exact 95 % intervals; runs, strokes and minutes in the median.

    `could be`: the ties that any of the ways settled rightly. The table leaves out ties whose string cannot go on.
    """
    ties = [line for line in lines if line["ways"] and all(one["runs"] is not None for one in line["ways"])]
    settled = [line for line in ties if any(one["right"] for one in line["ways"])]
    groups = {
        author: [line for line in ties if line["author"] == author] for author in sorted({t["author"] for t in ties})
    }
    rows = [
        "| ties | way | number | settled rightly | wrongly | runs | strokes | minutes |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for name, some in {**groups, "all": ties, "could be": settled}.items():
        for way in WAYS:
            ends = [one for line in some for one in line["ways"] if one["way"] == way]
            right = sum(one["right"] for one in ends)
            wrong = sum(one["verdict"] == "explained" and not one["right"] for one in ends)
            low, high = binomtest(right, len(ends)).proportion_ci(method="exact")
            middle = pd.DataFrame(ends)[["runs", "strokes", "seconds"]].median()
            share = f"{right} = {100 * right / len(ends):.0f} % ({100 * low:.0f} to {100 * high:.0f})"
            spending = f"{middle['runs']:.1f} | {middle['strokes']:.0f} | {middle['seconds'] / 60:.1f}"
            rows.append(f"| {name} | {way} | {len(ends)} | {share} | {wrong} | {spending} |")
    return "\n".join(rows)


def main() -> None:
    """Measure case by case, keep each in a file, and print the table; what the file has is not measured again."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=700_000)
    parser.add_argument("--cases", type=int, default=20, help="of the drawn order")
    parser.add_argument("--part", default="0/1", metavar="K/N", help="every N-th case from the K-th on")
    parser.add_argument("--out", type=Path, required=True, metavar="FILE", help="measured cases (.jsonl)")
    told = parser.parse_args()
    at, step = map(int, told.part.split("/"))

    def said(case: Case) -> dict[str, Any]:
        line = measured(case)
        print(case, line["verdict"], [(one["way"], one["verdict"], one["right"]) for one in line["ways"]])
        return line

    print(table(kept_cases(cases(told.seed)[: told.cases][at::step], told.out, said)))


if __name__ == "__main__":
    main()
