"""The first blind round, whose answers are out: how it is named must not get worse."""

import json
from pathlib import Path

import pytest

from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem, study
from pipeline.run.samples import read_samples

ROUND = Path(__file__).parent.parent / "data" / "blind" / "round-1"
EXACT, HELD, PAIRS_HELD = (
    12,
    15,
    2,
)  # of 15 single effects, and of 3 pairs: what was reached, less one for other processors


pytestmark = pytest.mark.long  # 24 diagnoses


@pytest.fixture(scope="module")
def outcomes() -> dict[str, list[str]]:
    """How each recording's verdict compares with what was hidden in it, by kind."""
    by_kind: dict[str, list[str]] = {}
    for case in json.loads((ROUND / "truth.json").read_text(encoding="utf-8")):
        run, samples = read_samples(ROUND / f"case-{case['case']:03d}")
        result = study(make_problem([RecordedRun.cut(run, samples)]))
        truth, sets = set(case["effects"]), [set(explanation.ids) for explanation in result.sets]
        outcome = result.verdict
        if outcome in ("explained", "ambiguous"):
            outcome = (
                "exact" if sets == [truth] else "held" if truth in sets else "wrong" if len(sets) == 1 else "missed"
            )
        by_kind.setdefault(case["kind"], []).append(outcome)
    return by_kind


def test_single_effects_and_pairs_are_named(outcomes) -> None:
    singles, pairs = outcomes["single"], outcomes["pair"]
    assert len(singles) == 15 and singles.count("exact") >= EXACT, singles
    assert singles.count("exact") + singles.count("held") >= HELD - 1, singles
    assert pairs.count("exact") + pairs.count("held") >= PAIRS_HELD, pairs


def test_no_firm_name_is_wrong(outcomes) -> None:
    assert "wrong" not in [outcome for kind in outcomes.values() for outcome in kind], outcomes
    assert outcomes["open"] == ["unknown", "unknown"]
    assert set(outcomes["none"] + outcomes["parameters"]) <= {"consistent", "parameters"}
