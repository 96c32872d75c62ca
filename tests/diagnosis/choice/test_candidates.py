"""Which candidates a search begins with, and what else may stand for a mismatch."""

from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.diagnosis.choice import candidates
from pipeline.diagnosis.fit.problem import Act
from pipeline.diagnosis.mechanisms.library import mechanisms


def term(port, signal=None):
    """A term at a port; its signal is an array, or a function of the state."""
    return SimpleNamespace(port=port, signal=np.ones(3) if signal is None else signal)


def made(library, ports, terms=None):
    """A problem with such a library, of a system with such ports."""
    return SimpleNamespace(
        library=library, drivers="drivers", rows=2, measured=np.array([3.0, 4.0, 9.0]),
        simulate=lambda state: np.array([1.0, 2.5, 7.0]), system=SimpleNamespace(ports=ports),
        terms=lambda mechanism, nonlinear: (terms or {})[nonlinear["at"]],
    )  # fmt: skip


def test_what_a_residual_suggests_is_asked_of_the_rows_that_may_be_seen():
    calls = []
    library = {"creep": SimpleNamespace(suggest=lambda *arguments: calls.append(arguments) or [{"at": 1.0}])}
    assert candidates.suggested(made(library, candidates.PORTS), "state") == {"creep": [{"at": 1.0}]}
    ((drivers, residual, predicted),) = calls
    assert drivers == "drivers" and residual.tolist() == [2.0, 1.5] and predicted.tolist() == [1.0, 2.5]


def test_what_can_act_nowhere_on_a_system_is_no_candidate():
    """Suggested candidates come after a mechanism's own; one without any is not in the catalogue."""
    options = {"creep": [{"at": 1.0}, {"at": 2.0}], "jam": [{"at": 3.0}], "wear": []}
    library = {id_: SimpleNamespace(candidates=lambda drivers, own=own: own) for id_, own in options.items()}
    more = {"creep": [{"at": 4.0}], "jam": [], "wear": []}
    ports = {1.0: "length", 2.0: "twist", 3.0: "twist", 4.0: "length"}
    terms = {at: [term(port)] for at, port in ports.items()}
    everywhere = candidates.catalogue(made(library, candidates.PORTS, terms), more)
    assert everywhere == {"creep": [{"at": 1.0}, {"at": 2.0}, {"at": 4.0}], "jam": [{"at": 3.0}]}
    without_twist = candidates.catalogue(made(library, ("length", "sensor"), terms), more)
    assert without_twist == {"creep": [{"at": 1.0}, {"at": 4.0}]}


def test_suggested_waves_of_the_reading_are_beside_the_columns_without_physics(monkeypatch):
    monkeypatch.setattr(candidates.generic, "dictionary", lambda drivers: np.zeros((2, 3)))
    wave = np.array([1.0, -1.0, 1.0])
    terms = {
        1.0: [term("sensor", wave), term("length")],
        2.0: [term("sensor", lambda state: wave)],
        3.0: [term("twist")],
    }
    more = {"creep": [{"at": 1.0}, {"at": 2.0}], "jam": [{"at": 3.0}]}
    columns = candidates.without_physics(made({}, candidates.PORTS, terms), more)
    assert columns.tolist() == [[0.0] * 3, [0.0] * 3, wave.tolist()]
    assert candidates.without_physics(made({}, candidates.PORTS), {}).shape == (2, 3)


def test_refined_parameters_are_added_once_and_those_adopted_are_not():
    """The catalogue that is given stays as it is."""
    adopted, acting = Act("jam", ({"at": 9.0},), (1.0,)), Act("creep", ({"at": 1.0}, {"at": 5.0}), (1.0, 1.0))
    catalogue = {"creep": [{"at": 1.0}], "jam": [{"at": 3.0}]}
    states = [SimpleNamespace(acts=(adopted, acting)), SimpleNamespace(acts=(acting,))]
    refined = candidates.with_refined(SimpleNamespace(included=(adopted,)), catalogue, states)
    assert refined == {"creep": [{"at": 1.0}, {"at": 5.0}], "jam": [{"at": 3.0}]}
    assert catalogue == {"creep": [{"at": 1.0}], "jam": [{"at": 3.0}]}


@pytest.mark.parametrize(
    ("ids", "are_apart"),
    [((), True), (("creep",), True), (("creep", "jam"), True), (("jam", "overtwist"), False)],
)
def test_two_laws_of_one_driver_are_not_apart(ids, are_apart):
    assert candidates.apart(ids) == are_apart
    assert mechanisms()["jam"].driver == mechanisms()["overtwist"].driver
