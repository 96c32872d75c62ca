"""Authors in the proof: what is planned, what is asked of them, and how their cases are scored, by hand and by law."""

import json

import pandas as pd
import pytest

from pipeline.ground.errors import BadInput
from pipeline.proof import authored
from pipeline.proof.conceal_batch import concealed
from pipeline.proof.plan import Planned, batches, plan, read, written
from pipeline.proof.score.authors import by_author, by_law
from pipeline.proof.score.case_table import gather
from pipeline.proof.score.hands import section
from pipeline.rig.authors import names

TWO = {"effects": ["creep", "wear"], "each": 1, "authors": ["a", "b"]}
MIXES = [
    {"stratum": "single", "protocol": "usual", "kappas": [1], **TWO},
    {"stratum": "open", "protocol": "rich", "kappas": [3], "count": 2, "authors": ["b"]},
    {"stratum": "none", "protocol": "rich", "count": 3},
]
HANDS = ("a", "b")
KNOWN = ["creep", "wear", "jam", "x_tilt", "x_fan"]


@pytest.fixture(autouse=True)
def hands(tmp_path, monkeypatch):
    """Two authors by name, beside those that are there."""
    for name in (*HANDS, *names()):
        (tmp_path / "authors" / name).mkdir(parents=True)
        (tmp_path / "authors" / name / "__init__.py").touch()
    monkeypatch.setattr("pipeline.proof.plan.AUTHORS", tmp_path / "authors")


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"authors": ["nobody"]}, "proof.mixes.authors"),
        ({"protocol": "usual"}, "proof.mixes.protocol"),
        ({"authors": ["a"], "stratum": "noise"}, "proof.mixes.stratum"),
    ],
)
def test_a_mix_that_nobody_can_make_is_refused(change, field):
    with pytest.raises(BadInput, match=field):
        plan({"seed": 1, "batch": 1, "mixes": [{"stratum": "none", "protocol": "rich", "count": 1, **change}]})


def test_each_author_gets_its_cases_in_batches_of_its_own():
    settings = {"seed": 5, "batch": 2, "mixes": MIXES}
    cases, batched = plan(settings), batches(settings)
    assert sorted(case.author for case in cases) == ["", "", "", "a", "a", "b", "b", "b", "b"]
    assert sorted(batched) == ["batch-000", "batch-001", "by_a-000", "by_b-000", "by_b-001"]
    assert all(len({case.author for case in batch}) == 1 for batch in batched.values())
    assert read(written(cases)) == cases


def test_an_author_who_knows_no_law_of_an_effect_makes_no_case_of_it():
    planned = Planned("case-1", 1, "single", "rich", ("thermal",), (1.0,), author="mechanics")
    with pytest.raises(authored.OutOfReach, match="mechanics knows no law of thermal"):
        authored.made(planned)


def test_what_the_plan_leaves_open_is_drawn_from_what_the_author_knows():
    requests = [authored.asked_of(case, KNOWN) for case in plan({"seed": 5, "batch": 2, "mixes": MIXES}) if case.author]
    outside = [request for request in requests if request.kappas == (3.0,)]
    assert len(outside) == 2 and all(request.effects[0].startswith("x_") for request in outside)
    named = [request for request in requests if request.kappas == (1.0,)]
    assert sorted(request.effects[0] for request in named) == ["creep", "creep", "wear", "wear"]
    pair = {"stratum": "pair", "protocol": "rich", "kappas": [2], "count": 1, "authors": ["a"]}
    (two,) = (authored.asked_of(case, KNOWN) for case in plan({"seed": 5, "batch": 2, "mixes": [pair]}))
    assert len(set(two.effects)) == 2 and two.kappas == (2.0, 2.0) and not any(x.startswith("x_") for x in two.effects)


@pytest.mark.parametrize("author", names())
def test_an_authors_case_is_written_and_answered_like_the_rigs_own(tmp_path, author):
    mix = {"stratum": "single", "protocol": "rich", "kappas": [3], "effects": ["creep"], "each": 1, "authors": [author]}
    (planned,) = plan({"seed": 11, "batch": 1, "mixes": [mix]})
    answer = concealed(planned, tmp_path / "recordings" / "b")
    assert (tmp_path / "recordings" / "b" / planned.run / "recording.parquet").is_file()
    diagnosis = {"verdict": "explained", "code": "c0de", "alternatives": [], "parameters": {}, "fit": {"heldout": None}}
    diagnosis["mechanisms"] = [{"id": "creep", "rms_mm": {"value": 1.0, "low": 0.0, "high": 1e9}}]
    files = {"sealed/b.json": [answer], "verdicts/b/asked.json": {"seconds": {planned.run: 1.0}, "status": 0}}
    files[f"verdicts/b/{planned.run}/diagnosis.json"] = diagnosis
    for name, content in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(content))
    cases, sizes = gather(tmp_path, ["b"])
    assert cases.loc[0, ["author", "outcome"]].tolist() == [author, "exact"] and cases.loc[0, "laws"] != "rig"
    assert sizes["inside"].tolist() == [True]


def case(author, stratum, effects, outcome, law="", protocol="rich", kappa=1.0, ratio=1.0):
    right = outcome in ("exact", "tie with the truth", "quiet", "unknown as it should")
    row = {"author": author, "stratum": stratum, "effects": effects, "laws": law, "outcome": outcome, "right": right}
    row |= {"protocol": protocol, "kappa": kappa, "skipped": "", "heldout_ratio": ratio}
    return row | {"verdict": "explained", "named": "backlash", "alternatives": ""}


def test_scores_by_author_and_by_law_count_what_they_say():
    cases = pd.DataFrame([
        case("rig", "single", "creep", "exact", "rig"),
        case("rig", "single", "creep", "wrong", "rig", kappa=0.25),  # too small to count
        case("b", "single", "creep", "exact", "power"),
        case("b", "single", "creep", "extra", "logarithmic", ratio=3.0),
        case("b", "single", "creep", "tie with the truth", "power", protocol="poor"),
        case("b", "pair", "creep+wear", "tie with the truth"),
        case("b", "none", "", "false alarm", kappa=None),
        case("b", "open", "x_fan", "unknown as it should"),
        case("b", "open", "x_fan", "wrong"),
    ])  # fmt: skip
    scored = by_author(cases).set_index(["author", "quantity"])
    counts = scored["count"].astype(str) + "/" + scored["of"].astype(str)
    assert counts["all", "one effect: exactly"] == "2/3" and counts["rig", "one effect: exactly"] == "1/1"
    assert counts["b", "one effect: exactly"] == "1/2" and counts["b", "one effect: firm wrong name"] == "1/2"
    assert counts["b", "one effect, poor protocol: exactly, or in the set"] == "1/1"
    assert counts["b", "two effects: exactly both"] == "0/1"
    assert counts["b", "two effects: exactly both, or in the set"] == "1/1"
    assert counts["b", "controls with a name, or unknown"] == "1/1"
    assert counts["b", "outside the library: unknown"] == "1/2"
    assert counts["b", "outside the library: firm name"] == "1/2"
    assert scored.loc[("b", "one effect: exactly"), "low"] == pytest.approx(0.0126, abs=1e-3)
    laws = by_law(cases)
    assert laws[["author", "law", "exact", "of"]].to_numpy().tolist() == [
        ["b", "logarithmic", 0, 1], ["b", "power", 1, 1], ["rig", "rig", 1, 1],
    ]  # fmt: skip
    text = section(by_author(cases), laws)
    assert "| one effect: exactly | ≥ 90 % | 2 of 3 = 67 %" in text
    assert "| creep | b | logarithmic | 0 of 1 | explained backlash |" in text
