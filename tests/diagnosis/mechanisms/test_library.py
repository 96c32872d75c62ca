"""The interface test: every mechanism in the folder keeps to `diagnosis/mechanisms/interface.py`, whoever wrote it."""

import ast
import re
from pathlib import Path

import numpy as np
import pytest
from imported import imported

import pipeline.diagnosis
from pipeline.diagnosis.fit.adopt import acts_from, entries
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.proposal.legs import Rig
from pipeline.diagnosis.proposal.next_runs import appended
from pipeline.diagnosis.recording.drivers import drivers_of
from pipeline.systems import systems

CONTRACT = [  # the names that verdicts have given, which other programs read: none may go; new ones need no entry
    *("plastic_elongation", "creep", "stiffening", "axial_elasticity", "thermal", "radius_compaction", "wear"),
    *("friction_hysteresis", "viscous_loss", "stick_slip", "backlash", "shaft_windup", "count_slip", "slack", "jam"),
    *("overtwist", "sensor_lag", "sensor_drift", "sensor_offset", "eccentricity", "clamp_slip", "end_stop"),
    "load_swing",
]
HERE = Path(pipeline.diagnosis.__file__).parent
PUBLISHED = re.compile(r"[A-Z][a-zé]+.*\b(1[6-9]|20)\d\d\b")  # an author or a standard, then its year


def test_no_name_that_a_verdict_may_have_given_goes_missing() -> None:
    assert set(CONTRACT) <= set(mechanisms())
    assert not any(id_.startswith("x_") for id_ in CONTRACT), "alone such a name says nothing"


def test_a_mechanism_is_in_the_file_of_its_name_and_says_what_it_is() -> None:
    for id_, mechanism in mechanisms().items():
        assert (HERE / "mechanisms" / f"{id_}.py").is_file()
        for text in (mechanism.driver, mechanism.equation, mechanism.source, mechanism.told_apart_by):
            assert text
        assert "{size}" in mechanism.sentence


@pytest.mark.parametrize("id_", mechanisms())
def test_a_mechanism_names_whom_to_read_by_author_and_year(id_: str) -> None:
    source = mechanisms()[id_].source
    assert PUBLISHED.search(source), source
    assert not re.search(r"text ?book|^none\b", source, re.IGNORECASE), source


@pytest.mark.parametrize("id_", mechanisms())
def test_terms_are_finite_named_once_and_as_long_as_the_recording(id_: str, problem) -> None:
    mechanism = mechanisms()[id_]
    for nonlinear in mechanism.candidates(problem.drivers)[:40:7]:
        terms = mechanism.terms(problem.drivers, nonlinear)
        assert len({term.name for term in terms} | set(nonlinear)) == len(terms) + len(nonlinear)
        for term in terms:
            signal = term.signal(problem.measured) if callable(term.signal) else term.signal
            assert signal.shape == problem.measured.shape and np.isfinite(signal).all()
            assert term.low < term.high and term.high > 0.0


def test_the_engine_names_no_mechanism_and_no_system_and_mechanisms_know_no_other() -> None:
    names = set(mechanisms()) | set(systems())
    for path in HERE.rglob("*.py"):
        tree = ast.parse(path.read_text())
        exempt_nodes = [
            node.value for node in ast.walk(tree) if isinstance(node, ast.keyword) and node.arg == "confused_with"
        ]
        words = {node.value for node in ast.walk(tree) if isinstance(node, ast.Constant) and node not in exempt_nodes}
        assert not words & (names - {path.stem}), path


def test_diagnosis_imports_nothing_of_rig_models_or_torch() -> None:
    for path in HERE.rglob("*.py"):
        never = ("pipeline.rig", "pipeline.models", "torch")
        assert not any(name.startswith(never) for name in imported(path)), path


@pytest.mark.parametrize("id_", mechanisms())
def test_a_shape_means_the_same_on_a_longer_recording(id_: str, one_load) -> None:
    """Its terms keep their names, and their values on what was recorded, whatever is recorded after it."""
    problem, run = one_load
    mechanism, rows, rig = mechanisms()[id_], len(problem.record), Rig(problem.record)
    longer = appended(problem.record, [*rig.stroke(load=2.0), *rig.stroke(slower=0.25, dwell_s=300.0)])
    drivers = drivers_of(problem.system, longer, run)
    for nonlinear in mechanism.candidates(problem.drivers)[:40:7]:
        before, after = mechanism.terms(problem.drivers, nonlinear), mechanism.terms(drivers, nonlinear)
        assert [term.name for term in after] == [term.name for term in before]
        for old, new in zip(before, after, strict=True):
            was = old.signal(problem.measured) if callable(old.signal) else old.signal
            now = new.signal(longer.measured) if callable(new.signal) else new.signal
            early = slice(0, rows - 20)
            np.testing.assert_allclose(now[early], was[early], atol=0.02 * np.abs(was).max() + 1e-12, err_msg=old.name)


def test_what_the_recording_cannot_show_can_be_adopted_all_the_same(one_load) -> None:
    problem, _ = one_load
    parameters = {
        "axial_elasticity": {"from_load": 1.0, "straight_mm_per_10_n": 0.1},
        "x_wave": {"hz": 0.5, "sine_mm": 0.1},
    }
    acts = acts_from([{"id": id_, "parameters": values} for id_, values in parameters.items()], problem.drivers)
    assert [entry["parameters"] for entry in entries(acts, problem.drivers)] == list(parameters.values())


def test_two_lines_of_a_spectrum_are_suggested_together(problem) -> None:
    suggested = mechanisms()["load_swing"].suggest(problem.drivers, two_swings(problem), problem.measured)
    assert any("second_hz" in nonlinear for nonlinear in suggested)


@pytest.mark.parametrize("id_", [id_ for id_, mechanism in mechanisms().items() if mechanism.suggest])
def test_what_one_recording_suggests_can_be_simulated_where_another_does_not(id_: str, problem, one_load) -> None:
    share = problem.record.time_s / problem.record.time_s[-1]
    steps = 0.5 * (share > 0.3) + 1.0 * (share > 0.7)
    walk = 0.05 * np.cumsum(np.random.default_rng(1).standard_normal(len(share)))
    other, name_of = one_load[0].drivers, problem.drivers.units.name
    for residual in (two_swings(problem), steps, walk, problem.measured - problem.measured.mean()):
        for nonlinear in mechanisms()[id_].suggest(problem.drivers, residual, problem.measured - residual):
            parameters = {name_of(name): value for name, value in nonlinear.items()}
            (act,) = acts_from([{"id": id_, "parameters": parameters}], other)
            assert act.nonlinear == (nonlinear,)


def two_swings(problem):
    """A residual of two lines of the spectrum, of 1.5 and 2.6 Hz, in the reading's unit and shape."""
    time_s = problem.record.time_s
    noise = np.random.default_rng(0).standard_normal(len(time_s))
    return 0.1 * np.sin(2.0 * np.pi * 1.5 * time_s) + 0.07 * np.sin(2.0 * np.pi * 2.6 * time_s) + 0.01 * noise
