"""What a person reads at the end of the loop: where the verdict lies, and what comes next."""

import json
from pathlib import Path

import pytest

from pipeline.settle.choose import Budget
from pipeline.settle.ending import settled
from pipeline.settle.step import Place, Step

RUNS = [Path("raw/a"), Path("raw/a-s1")]


ASKS = """a, a-s1: explained: physics is missing, and named.

What to do, in this order
  1. Optional, to be surer of a name: before adopting, record 7 strokes as before, 0 to 20 turns under 20 N, at
     3.95 turns/s, then as many at 1.98 turns/s.
     Its tests, the numbers to expect of it and the commands: details.txt.
  2. You may adopt this to predict motions like the recorded ones.

More: details.txt
"""


def said(tmp_path, capsys, verdict: str, why: str, sentence: str, page: str = "", more: dict | None = None) -> str:
    place, ids = Place(tmp_path / "out"), ["creep"] if verdict == "explained" else []
    place.folder(1).mkdir(parents=True)
    diagnosis = {"verdict": verdict, "mechanisms": [{"id": id_} for id_ in ids], "alternatives": []} | (more or {})
    (place.folder(1) / "diagnosis.json").write_text(json.dumps(diagnosis))
    if page:
        (place.folder(1) / "verdict.txt").write_text(page)
    settled(place, [Step(0, "diagnosed"), Step(1, "diagnosed")], RUNS, Budget(3, 30.0, 40), why, sentence)
    return capsys.readouterr().out


def test_a_settled_tie_ends_with_the_paths_and_the_command_that_adopts_it(tmp_path, capsys):
    text = said(tmp_path, capsys, "explained", "verdict", "the verdict is explained")
    out = tmp_path / "out"
    assert text.startswith("settled: the verdict is explained: creep\n")
    assert f"the last verdict: {out}/step-1/verdict.txt\n" in text and f"how it ended: {out}/settled.json\n" in text
    assert f"pipeline.adopt {out}/step-1/diagnosis.json raw/a\n" in text and "nothing to record" in text


def test_the_end_says_how_sure_a_name_is_and_how_large_its_effect(tmp_path, capsys):
    explanations = [{"ids": ["wear", "creep"], "probability": 0.94}, {"ids": ["creep"], "probability": 0.06}]
    more = {"mechanisms": [{"id": "creep", "rms_mm": {"value": 0.1412}}], "evidence": {"explanations": explanations}}
    text = said(tmp_path / "a", capsys, "explained", "verdict", "the verdict is explained", more=more)
    assert text.startswith("settled: the verdict is explained: creep (6 %), 0.14 mm rms\n")
    more["mechanisms"] = [{"id": "wear", "rms_mm": {"value": 0.052}}, *more["mechanisms"]]
    text = said(tmp_path / "b", capsys, "explained", "verdict", "the verdict is explained", more=more)
    both = "wear + creep (94 %), wear 0.052 mm rms, creep 0.14 mm rms"
    assert text.startswith(f"settled: the verdict is explained: {both}\n")


def test_it_says_nothing_to_record_only_where_its_verdict_asks_for_no_recording(tmp_path, capsys):
    """`next: nothing to record` stood above a verdict whose first step was to record strokes at two speeds."""
    text = said(tmp_path / "a", capsys, "explained", "verdict", "the verdict is explained", ASKS)
    assert "nothing to record" not in text and "pipeline.adopt" in text
    record = "record 7 strokes as before, 0 to 20 turns under 20 N, at 3.95 turns/s, then as many at 1.98 turns/s"
    ordered = text.partition("  next, in this order:\n")[2].splitlines()
    surer = "1. optional, to be surer of a name"
    assert ordered[0] == f"    {surer}: {record} (how: details.txt beside the last verdict)", "no `before adopting`"
    assert ordered[1] == "    2. adopt what the last verdict names, for each run:"
    source = tmp_path / "a" / "out" / "step-1" / "diagnosis.json"
    assert ordered[2:] == [f"      python -m pipeline.adopt {source} raw/{run}" for run in ("a", "a-s1")]
    assert "that verdict" not in text, "which verdict was that?"
    needed = ASKS.replace("Optional, to be surer of a name: before adopting, record", "Record")
    text = said(tmp_path / "c", capsys, "explained", "verdict", "the verdict is explained", needed)
    assert "1. record once more, as the last verdict asks: Record 7 strokes as before, 0 to 20 turns" in text
    against = needed.replace("You may adopt this to predict motions like the recorded ones", "Adopting gains nothing")
    text = said(tmp_path / "d", capsys, "explained", "verdict", "the verdict is explained", against)
    assert "pipeline.adopt" not in text and "; the last verdict does not advise to adopt it" in text
    none = ASKS.replace("record 7 strokes", "wind 7 strokes")
    assert "nothing to record" in said(tmp_path / "b", capsys, "explained", "verdict", "the verdict is explained", none)


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
    fits = said(tmp_path / "b", capsys, "consistent", "verdict", "it is consistent")
    assert "nothing to record: the simulator fits" in fits
