"""What a person reads at the end of the loop: where the verdict lies, and what comes next."""

import json
from pathlib import Path

import pytest

from pipeline.settle.choose import Budget
from pipeline.settle.ending import settled
from pipeline.settle.step import Place, Step

RUNS = [Path("raw/a"), Path("raw/a-s1")]


def said(tmp_path, capsys, verdict: str, why: str, sentence: str) -> str:
    place, ids = Place(tmp_path / "out"), ["creep"] if verdict == "explained" else []
    place.folder(1).mkdir(parents=True)
    found = {"verdict": verdict, "mechanisms": [{"id": id_} for id_ in ids], "alternatives": []}
    (place.folder(1) / "diagnosis.json").write_text(json.dumps(found))
    settled(place, [Step(0, "diagnosed"), Step(1, "diagnosed")], RUNS, Budget(3, 30.0, 40), why, sentence)
    return capsys.readouterr().out


def test_a_settled_tie_ends_with_the_paths_and_the_command_that_adopts_it(tmp_path, capsys):
    text = said(tmp_path, capsys, "explained", "verdict", "the verdict is explained")
    out = tmp_path / "out"
    assert text.startswith("settled: the verdict is explained: creep\n")
    assert f"the last verdict: {out}/step-1/verdict.txt\n" in text and f"how it ended: {out}/settled.json\n" in text
    assert f"pipeline.adopt {out}/step-1/diagnosis.json raw/a\n" in text and "nothing to record" in text


@pytest.mark.parametrize(
    ("sentence", "option"),
    [
        ("no run is allowed: as many runs as --runs allows are made (one stroke)", "--runs above 3"),
        ("it takes 4.0 min, and of --minutes 0.1 are left", "--minutes above 30"),
        ("it takes 3 strokes, and of --strokes 0 are left", "--strokes above 40"),
    ],
)
def test_a_budget_that_ended_it_says_how_to_go_on(sentence, option, tmp_path, capsys):
    text = said(tmp_path, capsys, "ambiguous", "no run", sentence)
    assert text.startswith("ended, not settled: ") and f"with the same words and {option}: it goes on from here" in text
    assert "pipeline.diagnose raw/a raw/a-s1 NEW_RUN --together --out NEW_FOLDER" in text


def test_a_tie_by_construction_is_not_told_of_a_budget(tmp_path, capsys):
    text = said(tmp_path, capsys, "ambiguous", "no run", "as far as they show it is a tie by construction")
    assert "--runs" not in text and "not settled" in text
    assert "nothing: the simulator fits" in said(tmp_path / "b", capsys, "consistent", "verdict", "it is consistent")
