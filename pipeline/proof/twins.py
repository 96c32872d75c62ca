"""How much of each effect of the rig the library's mechanism of the same name leaves unexplained, without any noise."""

import argparse
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd

from ..diagnosis.choice.search import Search
from ..diagnosis.fit import calibrate
from ..diagnosis.fit.linear import Linear
from ..diagnosis.fit.problem import Problem
from ..diagnosis.mechanisms.library import mechanisms
from ..diagnosis.numerics.noise import white
from ..diagnosis.recording.recorded_run import RecordedRun
from ..diagnosis.study import engine
from ..ground.errors import program
from ..ground.kinematics import Array
from ..ground.stored.files import write_text
from ..run.description import parse_run
from .baselines.frozen import frozen
from .case import Case, draw_case
from .draws import NAMED
from .perform import perform
from .protocol import Kind
from .size import OutOfReach, rms

LEAST = 0.03  # of an effect's rms, which the library must leave of each
SEEDS = 3
TRIED = 5  # seeds for each that is wanted: some benches cannot show some effects
LEADERS = 3  # candidates of a mechanism from which the fit sets out
FINE = 1e-2  # of an effect's rms: weighs misfit so heavily that what more numbers cost does not count
COLUMNS = ["effect", "seed", "protocol", "raw_mm", "share"]


def noise_free(case: Case) -> tuple[Problem, Array]:
    """A case's effects on a bench whose dimensions are known exactly, as a problem; and what they do in mm, (samples,).

    Nothing is left to calibrate; a thermocouple is read where the case has one.
    """
    bench = replace(case.bench, measured=case.bench.true, scale=1.0, zero_mm=0.0)
    bare, shown = (perform(bench, case.protocol, hidden) for hidden in ({}, case.effects))
    channels = {"time_s": shown.time_s, "motor_turns": shown.motor_turns, "load_n": shown.load_n}
    channels |= {"displacement_mm": shown.displacement_mm}
    if case.thermocouple:
        channels["temperature_c"] = shown.temperature_c
    run = parse_run(bench.described("twin", load=False), Path("twin/run.yaml").resolve())
    problem = engine.make_problem([RecordedRun.cut(run, pd.DataFrame(channels))], most=len(shown.time_s))
    return frozen(problem, problem.nominal()), shown.displacement_mm - bare.displacement_mm


def unexplained_mm(problem: Problem, name: str) -> float:
    """Rms of what the best fit of one mechanism leaves, in mm; infinite where the recording cannot show it."""
    begin = problem.nominal()
    options = mechanisms()[name].candidates(problem.drivers)
    predicted = problem.simulate(begin)
    missed = problem.measured - predicted
    options = options + mechanisms()[name].suggest(problem.drivers, missed, predicted)
    if not options:
        return np.inf
    noise = white(FINE * rms(missed))
    left_mm: list[float] = []
    for _ in range(LEADERS):
        search = Search(Linear(problem, begin, noise, {name: options}))
        best = search.explain((name,))
        states = [search.linear.state_of(best.fit, best.keys)]
        states.append(calibrate.refine(problem, noise, states[0]))
        left_mm += [rms(problem.measured - problem.simulate(state)) for state in states]
        spent = [options[number] for _, number in best.keys]
        options = [nonlinear for nonlinear in options if nonlinear not in spent]
        if not options:
            break
    return min(left_mm)


def twin(name: str, seed: int, protocol: Kind, kappa: float) -> dict[str, str | int | float]:
    """A row of the table: the share of an effect that its twin leaves; raises OutOfReach where the bench shows none.

    Both are counted beside the zero of the reading, which is always free. `raw_mm` counts from the first sample.
    """
    problem, does_mm = noise_free(draw_case(seed, "single", protocol, [name], [kappa]))
    share = unexplained_mm(problem, name) / float(does_mm.std())
    return dict(zip(COLUMNS, (name, seed, protocol, rms(does_mm - does_mm[0]), share), strict=True))


def twins(names: Iterable[str], protocol: Kind, kappa: float) -> pd.DataFrame:
    """The table: for each effect the rows of the first seeds that can show it."""
    rows: list[dict[str, str | int | float]] = []
    for name in names:
        count = 0
        for seed in range(1, TRIED + 1):
            try:
                rows.append(twin(name, seed, protocol, kappa))
            except OutOfReach:
                continue
            count += 1
            if count == SEEDS:
                break
    return pd.DataFrame(rows, columns=COLUMNS)


def summary(table: pd.DataFrame) -> list[str]:
    """A line for each effect: the median share that its twin leaves, the least, and whether that is too little."""
    lines = []
    for name, shares in table.groupby("effect")["share"]:
        little = f"; below {LEAST:.0%}: a twin too alike" if shares.min() < LEAST else ""
        lines.append(f"{name}: {shares.median():.2%} left unexplained, at least {shares.min():.2%}{little}")
    return lines


@program
def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.proof.twins", description=__doc__)
    parser.add_argument("--effect", action="append", default=[], choices=NAMED, metavar="ID", help="instead of all")
    parser.add_argument("--kappa", type=float, default=1.0, help="size of the effects, in noise floors")
    parser.add_argument("--protocol", choices=("rich", "poor"), default="rich")
    parser.add_argument("--out", type=Path, required=True, help="the file of the table, csv; required")
    arguments = parser.parse_args()
    table = twins(arguments.effect or NAMED, arguments.protocol, arguments.kappa)
    write_text(arguments.out, table.to_csv(index=False, float_format="%.5g"))
    print("\n".join(summary(table)))


if __name__ == "__main__":
    main()
