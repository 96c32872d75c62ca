"""The blind round: recordings whose hidden physics nobody here knew, and the verdicts that were given on them once."""

import json
from pathlib import Path

import pytest

from pipeline.diagnose import diagnose

ROOT = Path(__file__).parents[2]
RECORDINGS = ROOT / "tests" / "data" / "blind" / "round-1"
VERDICTS = ROOT / "reports" / "blind" / "round-1"
RUNS = sorted(path.name for path in RECORDINGS.iterdir() if path.is_dir())
SECOND = ROOT / "reports" / "blind" / "round-2"


def verdict(run, verdicts=VERDICTS):
    return json.loads((verdicts / run / "diagnosis.json").read_text(encoding="utf-8"))


def test_every_recording_has_its_verdict_by_one_and_the_same_code():
    assert len(RUNS) == 24 and sorted(path.name for path in VERDICTS.iterdir() if path.is_dir()) == RUNS
    check(VERDICTS, RUNS)


def test_the_second_round_has_its_verdicts_by_one_and_the_same_code():
    check(SECOND, [f"case-{number:03}" for number in range(60)])


def check(verdicts, runs):
    """One verdict a run, all by one code, each of the form that its word asks for."""
    assert sorted(path.name for path in verdicts.iterdir()) == runs
    assert len({verdict(run, verdicts)["code"] for run in runs}) == 1
    for run in runs:
        content = verdict(run, verdicts)
        assert content["run"] == run
        named = content["verdict"] in ("explained", "ambiguous")
        assert bool(content["mechanisms"]) == named and bool(content["alternatives"]) == (
            content["verdict"] == "ambiguous"
        )


def named(content):
    """What a verdict says: its word, the effects that it names, and the sets that tie with them."""
    return content["verdict"], [entry["id"] for entry in content["mechanisms"]], content["alternatives"]


@pytest.mark.parametrize("run", RUNS[:2])
@pytest.mark.long
def test_a_verdict_is_given_again(run, tmp_path):
    """Code that has changed since still says the same of these two."""
    diagnose([RECORDINGS / run], tmp_path / run)
    then, again = verdict(run), verdict(run, tmp_path)
    assert named(again) == named(then)
    assert again["mismatch"]["rms_mm"] == pytest.approx(then["mismatch"]["rms_mm"], rel=0.02)
