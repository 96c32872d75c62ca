"""The score's tables, from a folder of sealed answers and verdicts made by hand."""

import json

import pandas as pd
import pytest

from pipeline.proof.score import baselines_beside, case_table, page, scores

DIMENSIONS = {"radius_mm": 0.5, "separator_mm": 8.0, "torsion_zone_mm": 150.0}


def answer(run, stratum, effect="", **more):
    case_request = {"seed": 1, "stratum": stratum, "protocol": "rich", "effects": [effect] if effect else []}
    case_request |= {"kappas": [1.0] if effect else [], "without": ""}
    content = {"run": run, "asked": case_request, "protocol": "rich", "location": None, "noise_floor_mm": 0.1}
    content |= {"heldout_noise_mm": 0.1, "together": {"raw_mm": 0.2, "hidden_share": 0.0}}
    content["effects"] = [{"id": effect, "kappa": 1.0, "raw_mm": 0.2}] if effect else []
    return content | {"dimensions": {name: {"true": value} for name, value in DIMENSIONS.items()}} | more


def verdict(word, *named, alternatives=()):
    size = {"value": 0.21, "low": 0.19, "high": 0.23}
    inside = {name: {"low": 0.99 * value, "high": 1.01 * value} for name, value in DIMENSIONS.items()}
    outside = {"radius_mm": {"low": 0.6, "high": 0.7}}
    heldout_errors = {"nominal_mm": 1.0, "calibrated_mm": 0.5, "explained_mm": 0.12}
    return {
        "verdict": word, "code": "c0de", "alternatives": [*alternatives], "parameters": inside | outside,
        "mechanisms": [{"id": name, "rms_mm": size} for name in named], "fit": {"heldout": heldout_errors},
    }  # fmt: skip


@pytest.fixture
def place(tmp_path):
    answers = [
        answer("case-1", "none"),
        answer("case-2", "single", "creep"),
        answer("case-3", "single", "wear"),
        answer("case-4", "single", "backlash"),
        {**answer("case-5", "single", "jam"), "skipped": "no room"},
    ]
    verdicts = {
        "case-1": verdict("consistent"),
        "case-2": verdict("explained", "creep"),
        "case-3": verdict("ambiguous", "jam", alternatives=[["wear"]]),
    }
    settled = {"case-3/proposed": verdict("explained", "wear"), "case-3/same": verdict("explained", "jam")}
    baselines = {"run": "case-2", "guess": {"named": ["wear"], "heldout_mm": 0.3, "seconds": 1.0}}
    baselines |= {"smooth": {"named": None, "heldout_mm": None, "seconds": 2.0}}
    files = {"sealed/b.json": answers, "lookalikes/b.json": {"case-3": {"jam": 0.1}}}
    files |= {"verdicts/b/asked.json": {"seconds": {f"case-{n}": 10.0 * n for n in range(1, 5)}, "status": 2}}
    files |= {f"verdicts/b/{run}/diagnosis.json": diagnosis for run, diagnosis in verdicts.items()}
    files |= {f"settled/b/{name}/diagnosis.json": diagnosis for name, diagnosis in settled.items()}
    files |= {"baselines/b/case-2/baselines.json": baselines}
    for name, content in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(content))
    return tmp_path


def test_every_case_has_a_row_and_none_is_left_out(place):
    table, sizes = case_table.gather(place, ["b"])
    table = table.set_index("run")
    words = ["quiet", "exact", "tie with the truth", "refused"]
    assert table.loc[["case-1", "case-2", "case-3", "case-4"], "outcome"].tolist() == words
    assert table.loc["case-5", "skipped"] == "no room"
    assert table["seconds"].dropna().tolist() == [10.0, 20.0, 30.0, 40.0]
    assert not table.loc["case-1", "radius_inside"] and table.loc["case-1", "zone_inside"]
    assert table.loc["case-3", "least_left_over"] == 0.1 and not table.loc["case-3", "separable"]
    assert table.loc["case-3", ["after_proposed", "after_same"]].tolist() == ["exact", "wrong"]
    assert table.loc["case-2", "heldout_ratio"] == pytest.approx(1.2)
    assert sizes["run"].tolist() == ["case-2"] and bool(sizes["inside"].iloc[0])


def test_the_scores_and_the_page_say_so(place):
    table, sizes = case_table.gather(place, ["b"])
    besides = baselines_beside.gather(table, place, ["b"])
    scored = pd.concat([scores.scores(table, sizes), baselines_beside.scores(besides)], ignore_index=True)
    score_values = scored.set_index(["metric", "stratum"])["value"]
    large = "single, rich, kappa at least 0.5"
    assert score_values[("named exactly", large)] == pytest.approx(1 / 3) and score_values[
        ("refused", large)
    ] == pytest.approx(1 / 3)
    assert score_values[("ambiguous", large)] == pytest.approx(1 / 3)
    assert score_values[("ambiguous though the data part it", large)] == 0.0
    assert score_values[("tie settled rightly by proposed", "ties")] == 1.0
    assert score_values[("tie settled wrongly by same", "ties")] == 1.0
    assert (
        score_values[("named wrongly", "guess: single")] == 1.0
        and score_values[("named exactly", "diagnosis: single")] == 1.0
    )
    assert score_values[("held-out error over the oracle's", "guess: effects")] == pytest.approx(3.0)
    assert ("named exactly", "smooth: single") not in score_values.index
    twins = pd.DataFrame({"effect": ["creep", "jam"], "share": [0.09, 0.003]})
    text = page.page(table, scored, twins)
    assert "- case-5: no room" in text and "| case-4 | single | rich | backlash | 1 | refused |  | refused |" in text
    assert "| jam | 0.3 % | 0.3 % | below 3 %: too alike |" in text and "`c0de`" in text
