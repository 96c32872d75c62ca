"""A stop acts on the reading: beside a jam that keeps the reading below it, it must still be weighed on its own."""

import numpy as np
import pytest

from pipeline.diagnosis.fit.calibrate import base
from pipeline.diagnosis.fit.linear import Linear
from pipeline.diagnosis.fit.problem import Act, State
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.numerics.noise import white
from pipeline.diagnosis.study.engine import study
from pipeline.proof.teach.lesson import Lesson, problem_of

STOPPED = Lesson("lattice", 165_006, ("end_stop",), (11.669,), "rich")


@pytest.fixture(scope="module")
def problem():
    """A recording by a stranger that is held at a stop."""
    return problem_of(STOPPED)


@pytest.mark.long
def test_beside_a_jam_a_stop_has_each_candidate_on_the_reading_without_the_jam_too(problem) -> None:
    calibrated = base(problem)
    top = float(np.percentile(problem.drivers.motion, 99.9))
    jam = Act("jam", ({"critical_turns": 0.8 * top, "softness_turns": 0.01 * top},), (1.0, 0.0))
    catalogue = {id_: mechanisms()[id_].candidates(problem.drivers) for id_ in ("end_stop", "sensor_lag")}
    alone, jammed = (
        Linear(problem, State(calibrated.values, calibrated.zeros, acts), white(1.0), catalogue)
        for acts in ((), (jam,))
    )
    count = len(catalogue["end_stop"])
    assert len(alone.catalogue["end_stop"]) == count and len(jammed.catalogue["end_stop"]) == 2 * count
    assert len(jammed.catalogue["sensor_lag"]) == len(alone.catalogue["sensor_lag"])
    for number in range(count):
        bare = jammed.index["end_stop", count + number]
        assert jammed.catalogue["end_stop"][number] == jammed.catalogue["end_stop"][count + number]
        assert jammed.table[bare] == pytest.approx(alone.table[alone.index["end_stop", number]])
    high = [number for number in range(count) if np.abs(alone.table[alone.index["end_stop", number]]).max() > 0.0]
    assert any(np.abs(jammed.table[jammed.index["end_stop", number]]).max() == 0.0 for number in high)


def test_behind_a_stop_its_rivals_move_the_reading_and_what_it_holds_does_not(problem) -> None:
    """A jam was weighed behind the stop that it had to replace, where nothing moves: it could never be found."""
    calibrated = base(problem)
    top, reach = float(np.percentile(problem.drivers.motion, 99.9)), float(np.ptp(problem.drivers.contraction))
    stopped = Act("end_stop", ({"stop_mm": 0.8 * reach, "side": 1.0, "soft_mm": 0.0},), (1.0,))
    jam = {"critical_turns": 0.8 * top, "softness_turns": 0.01 * top}
    state = State(calibrated.values, calibrated.zeros, (stopped,))
    both = {"end_stop": list(stopped.nonlinear), "jam": [jam]}
    beside, bare = (
        Linear(problem, State(calibrated.values, calibrated.zeros, acts), white(1.0), both) for acts in ((stopped,), ())
    )
    assert beside.table[beside.index["jam", 0]] == pytest.approx(bare.table[bare.index["jam", 0]])
    assert beside.table[beside.calibration] == pytest.approx(bare.table[bare.calibration], rel=1e-3, abs=1e-3)
    alone = Linear(problem, state, white(1.0), {"end_stop": list(stopped.nonlinear)})
    at_stop = problem.simulate(state)[: problem.rows] > problem.simulate(state).max() - 1e-6
    radius = alone.calibration[problem.runs]
    assert at_stop.sum() > 20 and np.abs(alone.table[radius][at_stop]).max() < 0.05 * np.abs(alone.table[radius]).max()


@pytest.mark.long
def test_a_stop_whose_best_rival_is_a_jam_is_held(problem) -> None:
    """Both leave about a hundredth; neither may be lost for what the simulator of the other one does."""
    studied = study(problem)
    likeliest = sorted(studied.judged.likely, key=studied.judged.likely.get)[-2:]
    assert set(likeliest) == {("end_stop",), ("jam",)}
    assert ("end_stop",) in {explanation.ids for explanation in studied.judged.sets}
