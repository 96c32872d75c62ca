"""The score's words and numbers, on verdicts and tables made by hand."""

import numpy as np
import pandas as pd
import programs
import pytest
from made_recording import BASE

from pipeline.proof.score import share_intervals
from pipeline.proof.score.against_truth import outcome
from pipeline.proof.score.overlap import overlap
from pipeline.proof.score.scores import scores


def verdict(word, named=(), *alternatives):
    return {"verdict": word, "mechanisms": [{"id": name} for name in named], "alternatives": [*alternatives]}


@pytest.mark.parametrize(
    ("diagnosis", "truth", "nameless", "wanted"),
    [
        (verdict("consistent"), "", False, "quiet"),
        (verdict("parameters"), "", False, "quiet"),
        (verdict("unknown"), "", False, "false alarm"),
        (verdict("explained", ["creep"]), "", False, "false alarm"),
        (verdict("explained", ["creep"]), "creep", False, "exact"),
        (verdict("explained", ["creep", "wear"]), "creep", False, "extra"),
        (verdict("explained", ["creep"]), "creep wear", False, "part"),
        (verdict("explained", ["wear"]), "creep", False, "wrong"),
        (verdict("explained", ["creep", "jam"]), "creep wear", False, "wrong"),
        (verdict("ambiguous", ["wear"], ["creep"]), "creep", False, "tie with the truth"),
        (verdict("ambiguous", ["wear"], ["creep", "jam"]), "creep", False, "tie without the truth"),
        (verdict("consistent"), "creep", False, "missed"),
        (verdict("unknown"), "creep", False, "unknown"),
        (verdict("explained", ["x_sway"]), "creep", False, "unknown"),
        (verdict("explained", ["x_sway"]), "x_floor_sway", True, "unknown as it should"),
        (verdict("unknown"), "x_floor_sway", True, "unknown as it should"),
        (verdict("explained", ["creep"]), "x_floor_sway", True, "wrong"),
        (verdict("ambiguous", ["creep"], ["wear"]), "eccentricity", True, "tie without the truth"),
        (verdict("parameters"), "x_floor_sway", True, "missed"),
        (None, "creep", False, "refused"),
    ],
)
def test_one_word_for_each_case(diagnosis, truth, nameless, wanted):
    assert outcome(diagnosis, frozenset(truth.split()), nameless) == wanted


def test_the_table_of_twins_is_looked_for_before_anything_is_read_or_written(tmp_path):
    words = ("--place", tmp_path / "none", "--twins", tmp_path / "twins.csv", "--out", tmp_path / "out")
    done = programs.run("pipeline.proof.score", "batch-0", *words)
    assert done.returncode == 2 and "twins.csv: --twins: is not there" in done.stderr and not any(tmp_path.iterdir())


def test_intervals_are_exact():
    assert share_intervals.share(0, 300)[1] == pytest.approx(0.01222, abs=1e-4)  # 1 - 0.025 ** (1 / 300)
    assert share_intervals.share(8, 10) == pytest.approx((0.4439, 0.9748), abs=1e-4)
    assert share_intervals.share(5, 5)[1] == 1.0
    assert share_intervals.median([3.0, 1.0, 2.0]) == (1.0, 3.0)
    assert share_intervals.median(range(1, 101)) == (40, 61)


def test_the_overlap_counts_samples_in_both_over_samples_in_either(make_run):
    turns = [*range(0, 20), *range(20, 0, -1)] * 3
    table = pd.DataFrame({"time_s": [0.1 * at for at in range(len(turns))], "motor_turns": [float(t) for t in turns]})
    folder = make_run("case", table.assign(displacement_mm=BASE.contraction_mm(np.array(turns), 20.0), load_n=20.0))
    box = {"motor_turns": [0.0, 20.0], "strokes": [1, 3], "phase": "all"}
    assert overlap(folder, box, box) == 1.0
    assert overlap(folder, box, {**box, "strokes": [1, 1]}) == pytest.approx(1 / 3, abs=0.02)
    assert overlap(folder, {**box, "strokes": [0, 2]}, {**box, "strokes": [3, 3]}) == 0.0


def row(outcome, stratum="none", **more):
    defaults = {"run": "case", "stratum": stratum, "protocol": "rich", "kappa": None, "effects": "", "skipped": ""}
    right = outcome in ("quiet", "exact", "tie with the truth")
    return (
        defaults
        | {"outcome": outcome, "right": right, "verdict": "", "separable": None, "sets": 0, "seconds": 5.0}
        | more
    )


def test_scores_count_what_they_say():
    rows = [row("quiet")] * 9 + [row("false alarm")]
    effect = {"stratum": "single", "effects": "creep", "kappa": 1.0}
    rows += [row("exact", sets=1, heldout_ratio=1.1, calibrated_ratio=5.0, **effect)] * 3
    rows += [row("wrong", sets=1, heldout_ratio=1.3, calibrated_ratio=5.0, **effect)]
    rows += [row("tie with the truth", **{**effect, "verdict": "ambiguous", "separable": True, "sets": 3})]
    rows += [{**row("", **effect), "skipped": "no room"}]
    sizes = pd.DataFrame({"stratum": ["single"] * 3, "inside": [True, True, False]})
    scored = scores(pd.DataFrame(rows), sizes).set_index(["metric", "stratum"])
    large = "single, rich, kappa at least 0.5"
    assert scored.loc[("false alarm", "controls"), ["count", "of"]].tolist() == [1, 10]
    assert scored.loc[("named exactly", large), ["count", "of"]].tolist() == [3, 5]
    assert scored.loc[("named wrongly", large), "count"] == 1
    assert scored.loc[("ambiguous though the data part it", large), "count"] == 1
    assert scored.loc[("case could not be made", "all"), "count"] == 1
    assert scored.loc[("90 % interval holds the effect's size", "all"), ["count", "of"]].tolist() == [2, 3]
    ratio = scored.loc[("held-out error over the oracle's", "single")]
    assert ratio["value"] == pytest.approx(1.1) and ratio["of"] == 4
    shares = scored[[name[0] == "false alarm" for name in scored.index]]
    assert ((shares["low"] <= shares["value"]) & (shares["value"] <= shares["high"])).all()
