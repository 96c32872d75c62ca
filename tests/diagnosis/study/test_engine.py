"""The diagnosis of recordings made by another hand: names, abstention, no false alarm."""

import numpy as np
import pytest

from pipeline.diagnosis.choice.search import Search
from pipeline.diagnosis.proposal import design, next_runs
from pipeline.diagnosis.proposal.legs import Rig
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study import engine
from pipeline.diagnosis.study.engine import make_problem, study
from pipeline.run.samples import read_samples


def verdict(folder) -> tuple[str, tuple[str, ...]]:
    run, samples = read_samples(folder)
    outcome = study(make_problem([RecordedRun.cut(run, samples)]))
    return outcome.verdict, outcome.best_ids


LONG = [pytest.param(kind, marks=pytest.mark.long) for kind in ("backlash", "jam", "sensor_lag")]


@pytest.mark.parametrize("kind", ["axial_elasticity", *LONG])
def test_one_effect_is_named(kind: str, conceal) -> None:
    assert verdict(conceal(kind)[0]) == ("explained", (kind,))


def test_two_effects_are_both_named(conceal) -> None:
    assert verdict(conceal("axial_elasticity", "backlash", seed=11)[0]) == (
        "explained",
        ("axial_elasticity", "backlash"),
    )


@pytest.mark.parametrize("nuisance", ["plain", "colour", "outliers", "jitter"])
def test_no_false_alarm(nuisance: str, conceal) -> None:
    assert verdict(conceal(nuisance=nuisance, seed=21)[0])[0] in ("consistent", "parameters")


@pytest.mark.long
def test_what_no_mechanism_makes_is_unknown(conceal) -> None:
    assert verdict(conceal("u_bump", kappa=3.0, seed=5)[0])[0] == "unknown"


@pytest.mark.long
def test_an_experiment_under_another_load_can_be_thought_of_after_one_load(one_load, monkeypatch) -> None:
    problem, run = one_load
    outcome = study(problem)
    rivals = outcome.search.all_of(1)[:3]
    assert any(problem.ports(outcome.search.linear.state.acts))
    proposal = next_runs.best(problem, run, outcome.noise, outcome.search, rivals)
    possible = design.parts(Rig(problem.record), loads=True, faster=True)
    assert set(proposal.title.split("; ")) <= set(possible) and all(leg[0] > 0 for leg in proposal.legs)
    entry = proposal.entry(run, fixed_load=True)
    assert entry["gap_then"] >= entry["gap_now"] > 0.0 and all(entry["parts"])
    assert len(entry["pairs"]) == 3, "each two of three"
    assert min(pair["gap_then"] for pair in entry["pairs"]) == entry["gap_then"]
    assert min(pair["gap_now"] for pair in entry["pairs"]) == entry["gap_now"]
    assert [leg["seconds"] for leg in entry["legs"]] == [leg[0] for leg in proposal.legs]
    record_lengths, plain = [], next_runs.separations

    def counted(*arguments):
        record_lengths.append(len(arguments[-1]))
        return plain(*arguments)

    monkeypatch.setattr(next_runs, "separations", counted)
    first = next_runs.best(problem, run, outcome.noise, outcome.search, rivals)
    alone = len(record_lengths)
    every = next_runs.options(problem, run, outcome.noise, outcome.search, rivals)
    assert (first.title, first.legs, first.then) == (proposal.title, proposal.legs, proposal.then)
    assert (every[0].title, every[0].then) == (first.title, first.then)  # the best is the first, for less
    assert 0 < alone < len(record_lengths) - alone


def test_a_swaying_floor_is_no_physics_of_the_string(conceal) -> None:
    run, samples = read_samples(conceal(seed=31)[0])
    sway = samples.assign(displacement_mm=samples["displacement_mm"] + 0.1 * np.sin(4.1 * samples["time_s"]))
    outcome = study(make_problem([RecordedRun.cut(run, sway)]))
    assert outcome.verdict == "unknown" and outcome.best_ids == ("x_wave",)


@pytest.mark.parametrize("kind", [pytest.param("u_clock", marks=pytest.mark.long), "u_swelling"])
@pytest.mark.long
def test_clocks_that_part_and_damp_air_are_never_called_physics_of_the_string(kind: str, conceal) -> None:
    verdict_word, ids = verdict(conceal(kind, kappa=3.0, seed=5)[0])
    helper = {"u_clock": "x_clock", "u_swelling": "x_swelling"}[kind]
    assert verdict_word == "unknown" and helper in ids


@pytest.mark.long
def test_nothing_acts_twice_in_an_explanation_whose_jerks_are_seen_as_well(conceal) -> None:
    run, samples = read_samples(conceal("stick_slip", kappa=3.0, seed=5)[0])
    outcome = study(make_problem([RecordedRun.cut(run, samples)]))
    assert "stick_slip" in outcome.best_ids
    assert len(outcome.best.acts) == len({act.id for act in outcome.best.acts})


@pytest.mark.long
def test_an_explanation_that_refining_takes_back_is_none(conceal, monkeypatch):
    select, calls = Search.select, []

    def fickle(self, floor, largest=3):
        calls.append(floor)
        return select(self, floor, largest) if len(calls) == 1 else self.nothing

    monkeypatch.setattr(Search, "select", fickle)
    run, samples = read_samples(conceal("creep")[0])
    outcome = study(make_problem([RecordedRun.cut(run, samples)]))
    assert len(calls) == 2 and outcome.sets == [] and outcome.best is outcome.base and outcome.verdict == "unknown"


@pytest.mark.long
@pytest.mark.parametrize(("loud", "rounds"), [([False], 1), ([True, False], 2), ([True, True, True], 3)])
def test_the_noise_is_told_once_more_while_it_is_louder_than_what_is_left(loud, rounds, conceal, monkeypatch):
    """A noise of three times the sensor's hid what four explanations differ by."""
    asked_again, steps = iter(loud), []
    monkeypatch.setattr(engine, "too_loud", lambda noise, chosen: next(asked_again))
    run, samples = read_samples(conceal("creep")[0])
    study(make_problem([RecordedRun.cut(run, samples)]), steps.append)
    assert sum(step.startswith("refining") for step in steps) == rounds
