"""What `benchmarks/settled_ties.py` plays on a concealed string is the run that `settle` proposes."""

from pathlib import Path

import pytest

from pipeline.settle.step import Step

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"


def test_a_leg_that_tells_no_load_is_played_under_the_one_that_hangs(monkeypatch: pytest.MonkeyPatch) -> None:
    """It was played without a load, and the run that should settle a tie was of a slack string."""
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    from settled_ties import under_loads

    kept = [{"seconds": 2.0, "motor_turns": 0.0}, {"seconds": 9.0, "motor_turns": 20.0}]
    step = Step(1, "proposed", proposal={"title": "", "load": 51.8, "legs": kept})
    assert under_loads(step) == [(2.0, 0.0, 51.8), (9.0, 20.0, 51.8)]
    changed = [{"seconds": 0.5, "motor_turns": 0.0, "load_n": 25.9}]
    assert under_loads(Step(1, "proposed", proposal={"title": "", "load": 51.8, "legs": changed})) == [(0.5, 0.0, 25.9)]
