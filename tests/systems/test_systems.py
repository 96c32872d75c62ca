"""The interface test of systems: every module in the folder keeps to `systems/interface.py`, whoever wrote it."""

from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.ground.units import unit_of
from pipeline.run.description import STRING_ACTUATORS
from pipeline.systems import systems
from pipeline.systems.interface import PORTS

SAMPLES = 400
STRING = SimpleNamespace(radius_mm=0.5, length_mm=300.0, stiffness_n_per_mm=30.0)


@pytest.fixture(params=sorted(systems()))
def system(request):
    """Each system in turn."""
    return systems()[request.param]


@pytest.fixture
def run(system):
    """A run that gives every dimension a plain value."""
    return SimpleNamespace(string=STRING, rig=dict.fromkeys(system.rig, 1.0), tolerance={})


@pytest.fixture
def inputs():
    """A motion of two strokes, in whatever unit."""
    time_s = np.linspace(0.0, 8.0, SAMPLES)
    motion = 5.0 * (1.0 - np.cos(np.pi * time_s / 2.0))
    rate = np.gradient(motion, time_s)
    load = np.full(SAMPLES, 1.0)
    return SimpleNamespace(
        time_s=time_s, motion=motion, rate=rate, acceleration=np.gradient(rate, time_s), load=load
    )  # fmt: skip


def test_a_system_says_what_a_recording_holds(system):
    assert system.columns[:3] == ("time_s", system.driver, system.channel)
    assert len(set(system.columns)) == len(system.columns)
    assert unit_of(system.driver) != "1" and unit_of(system.channel) != "1"
    assert set(system.ports) <= set(PORTS) and "sensor" in system.ports
    assert system.never_zero | system.may_be_negative <= set(system.rig) | set(system.optional_rig)
    assert system.homed is None or "twist" in system.ports


def test_each_kind_of_string_is_one_of_the_string_actuators():
    """Models, datasets and exports ask for them by name: CONTRIBUTING.md, "A system", lists where."""
    assert {name for name, system in systems().items() if system.needs_string} == set(STRING_ACTUATORS)


def test_dimensions_are_named_once_and_have_tolerances(system, run):
    parameters = system.parameters(run)
    assert len({parameter.name for parameter in parameters}) == len(parameters)
    assert all(np.isfinite(parameter.nominal) and parameter.sigma >= 0.0 for parameter in parameters)
    assert any(parameter.sigma > 0.0 for parameter in parameters)
    run.tolerance = {key: 2.0 * value for key, value in system.tolerance.items()}
    for parameter, wider in zip(parameters, system.parameters(run), strict=True):
        assert wider.sigma == pytest.approx(2.0 * parameter.sigma)
    assert system.homed is None or system.homed in [parameter.name for parameter in parameters]


def test_it_reads_one_value_a_sample_and_each_dimension_and_port_moves_it(system, run, inputs):
    parameters = system.parameters(run)
    values = np.array([parameter.nominal for parameter in parameters])
    reading = system.simulate(values, inputs, {})
    assert reading.shape == (SAMPLES,) and np.isfinite(reading).all()
    for place, parameter in enumerate(parameters):
        if parameter.sigma > 0.0:
            moved = values + parameter.sigma * (np.arange(len(values)) == place)
            assert np.abs(system.simulate(moved, inputs, {}) - reading).max() > 0.0, parameter.name
    for port, key in system.ports.items():
        if port != "sensor":
            pushed = system.simulate(values, inputs, {key: np.full(SAMPLES, 0.01)})
            assert np.abs(pushed - reading).max() > 0.0, port


def test_lever_and_travel_are_finite(system, run, inputs):
    values = np.array([parameter.nominal for parameter in system.parameters(run)])
    sine, tangent = system.lever(values, inputs)
    assert np.isfinite(sine).all() and np.isfinite(tangent).all()
    assert np.isfinite(system.travel(values, inputs)).all()
    assert system.levered == (np.ptp(sine) > 0.0)


def test_a_stiffness_that_nobody_measured_may_be_moved_and_a_measured_one_may_not():
    rig = {"separator_mm": 8.0, "torsion_zone_mm": 150.0}
    unknown = SimpleNamespace(radius_mm=0.5, length_mm=300.0, stiffness_n_per_mm=None)
    for name, moves in (("separator", True), ("twisted_pair", False)):  # the pair's equation has no stiffness
        for string in (STRING, unknown):
            run = SimpleNamespace(string=string, rig=rig, tolerance={})
            stiffness = {parameter.name: parameter for parameter in systems()[name].parameters(run)}[
                "stiffness_n_per_mm"
            ]
            assert stiffness.nominal == pytest.approx(30.0 if string is STRING else 7000.0 * np.pi * 0.25 / 300.0)
            assert stiffness.sigma == (pytest.approx(0.3 * stiffness.nominal) if moves and string is unknown else 0.0)
