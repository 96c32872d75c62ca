"""The classes of creep and of heat from motion: any one time constant, and each way in which a later run can begin."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from scipy.optimize import nnls

from pipeline.diagnosis.fit.adopt import acts_from
from pipeline.diagnosis.fit.problem import Problem
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.mechanisms.shared_laws import AS_THE_FIRST, GOES_ON, LOADED_FOR_LONG
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study import engine
from pipeline.run.description import parse_run

STEP_S, LASTS_S, BREAK_S, LOADS_N = 0.1, 320.0, 60.0, (10.0, 30.0)
TIME_S = np.arange(0.0, LASTS_S, STEP_S)
TURNS = 20.0 * np.abs(np.sin(np.pi * TIME_S / 40.0))
STRING = {"material": "Z", "radius_mm": 0.4, "length_mm": 300.0, "stiffness_n_per_mm": 50.0}


def of_runs(*loads_n: float) -> Problem:
    """One string at work, in a run under each load."""
    recorded = []
    for load_n in loads_n:
        name = f"under-{load_n:g}-n"
        content = {"run": name, "actuator": "twisted_pair", "string": STRING, "rig": {"load_n": load_n}}
        table = pd.DataFrame({"time_s": TIME_S, "motor_turns": TURNS, "displacement_mm": 0.1 * TURNS, "load_n": load_n})
        recorded.append(RecordedRun.cut(parse_run(content, Path(name) / "run.yaml"), table))
    return engine.make_problem(recorded)


@pytest.fixture(scope="module")
def two_runs() -> Problem:
    return of_runs(*LOADS_N)


def followed(drive: list[np.ndarray], tau_s: float, kept: bool) -> np.ndarray:
    """What follows the drive of each run at a distance, by Euler's steps; lost or `kept` in the break between them."""
    state, out = 0.0, []
    for signal in drive:
        state = signal[0] + (state - signal[0]) * np.exp(-BREAK_S / tau_s) if out and kept else 0.0
        for value in signal:
            out.append(state)
            state += (value - state) * STEP_S / tau_s
    return np.array(out)


def left(problem: Problem, id_: str, truth: np.ndarray, way: float) -> float:
    """The least share of what a string does, beside a zero of each run, that no candidate of a beginning follows."""
    mechanism, drivers, shares = mechanisms()[id_], problem.drivers, []
    zeros = [np.where(np.arange(len(truth)) // len(TIME_S) == run, 1.0, 0.0) for run in (0, 1)]
    truth = truth - sum(zero * truth[zero > 0.0].mean() for zero in zeros)
    for nonlinear in mechanism.candidates(drivers):
        if nonlinear.get("later_runs") == way:
            signals = [term.signal for term in mechanism.terms(drivers, nonlinear)]
            columns = np.column_stack([*signals, *zeros, *(-zero for zero in zeros)])
            shares.append(nnls(columns, truth)[1] / np.linalg.norm(truth))
    return min(shares)


@pytest.mark.parametrize("tau_s", [3.0, 12.0, 21.0, 30.0, 45.0, 90.0, 170.0])
def test_creep_of_any_one_time_constant_is_followed_by_a_string_that_rested_between_runs(two_runs, tau_s) -> None:
    loads = [np.full(len(TIME_S), load_n) for load_n in LOADS_N]
    assert left(two_runs, "creep", followed(loads, tau_s, kept=False), AS_THE_FIRST) < 0.01


def test_a_string_that_is_done_creeping_when_a_later_run_begins_is_followed_by_no_other_way(two_runs) -> None:
    loads = [np.full(len(TIME_S), load_n) for load_n in LOADS_N]
    done = followed(loads, 12.0, kept=True)
    assert left(two_runs, "creep", done, LOADED_FOR_LONG) < 0.01
    assert min(left(two_runs, "creep", done, way) for way in (GOES_ON, AS_THE_FIRST)) > 0.3


def test_a_motor_that_cooled_between_runs_is_followed(two_runs) -> None:
    rate = np.abs(np.gradient(TURNS, STEP_S))
    heat = -followed([rate * load_n for load_n in LOADS_N], 90.0, kept=False)
    assert left(two_runs, "thermal", heat, AS_THE_FIRST) < 0.02 < left(two_runs, "thermal", heat, GOES_ON)


def test_one_run_has_no_beginning_to_choose() -> None:
    drivers = of_runs(10.0).drivers
    for id_ in ("creep", "thermal"):
        assert not [nonlinear for nonlinear in mechanisms()[id_].candidates(drivers) if "later_runs" in nonlinear]


@pytest.mark.long
def test_a_refinement_keeps_the_kind_that_needs_fewer_numbers() -> None:
    """Of two beginnings that fit alike, one bends the load's power to do what the other does without."""
    problem = of_runs(*LOADS_N)
    crept = 0.02 * followed([np.full(len(TIME_S), load_n) for load_n in LOADS_N], 60.0, kept=False)
    noise_mm = np.random.default_rng(3).normal(0.0, 0.01, len(crept))
    measured = problem.simulate(problem.nominal()) - crept + noise_mm
    studied = engine.study(replace(problem, measured=measured))
    (creep,) = studied.state.acts
    assert studied.best_ids == ("creep",) and creep.nonlinear[0]["later_runs"] == AS_THE_FIRST


def test_an_entry_of_one_run_acts_in_two_runs_and_one_of_two_runs_in_one(two_runs) -> None:
    shape = {"fresh": 1.0, "fastest_s": 1.0, "slowest_s": 1000.0, "loaded": 0.0}
    entry = {"id": "creep", "parameters": {**shape, "load_60_s_mm_per_10_n": 0.3}}
    later = {"id": "creep", "parameters": {**entry["parameters"], "later_runs": AS_THE_FIRST}}
    alone = of_runs(10.0)

    def effect(problem: Problem, content: dict) -> np.ndarray:
        nominal = problem.nominal()
        return problem.simulate(replace(nominal, acts=acts_from([content], problem.drivers))) - problem.simulate(
            nominal
        )

    assert effect(alone, later) == pytest.approx(effect(alone, entry))
    both, anew = effect(two_runs, entry), effect(two_runs, later)
    first = len(TIME_S)
    own = pytest.approx(effect(alone, entry))
    assert anew[:first] == own and both[:first] == own
    assert anew[first] == pytest.approx(0.0, abs=1e-3) and both[first] < -0.2
