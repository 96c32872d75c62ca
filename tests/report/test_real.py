"""The public rigs' pages say what the files say, and where a verdict is no firm, expected one."""

import csv
import json
import re

import pandas as pd
import programs
import pytest
from made_verdict import made_verdict

from pipeline.real.rigs import Answer, Expected, read_rigs
from pipeline.report.real import index, page
from pipeline.report.real.results import read_results
from pipeline.report.real.verdict_doubts import doubt, found_answer

HYSTERESIS = Expected(names=[["friction_hysteresis", "backlash"]], never=["axial_elasticity"], said="a loop is missing")
OPEN = Expected(said="nobody knows")
MASS = Answer(what="mass", value=95.0, unit="kg", parameter="mass_kg")
OFFSET = Answer(what="offset", value=3.0, unit="N", mechanism="sensor_offset", parameter="offset_n", scale=-1.0)


def diagnosis(verdict, *sets, unit="mm", **changes):
    """A diagnosis.json that names the first of `sets` and ties with the others."""
    named = [{"id": id_, f"rms_{unit}": {"value": 0.31}, "parameters": {}} for id_ in (sets[0] if sets else [])]
    box = {"motor_turns": [2.0, 11.0], "strokes": [1, 4], "phase": "winding", "share": 0.81}
    errors = {f"nominal_{unit}": 1.92, f"calibrated_{unit}": 0.81, f"explained_{unit}": 0.12}
    return {
        "run": "a", "verdict": verdict, "mechanisms": named, "alternatives": [list(ids) for ids in sets[1:]],
        "mismatch": {f"rms_{unit}": 0.44, "location": box, "driver": "direction"}, "parameters": {},
        "next_experiment": "one stroke at a quarter of the speed",
        "fit": {f"noise_floor_{unit}": 0.03, f"detectable_{unit}": {"backlash": 0.02}, "heldout": errors}, **changes,
    }  # fmt: skip


@pytest.mark.parametrize(
    ("content", "expected", "kind", "says"),
    [
        (diagnosis("explained", ["backlash"]), HYSTERESIS, None, ""),
        (diagnosis("explained", ["creep"]), None, None, ""),
        (diagnosis("explained", ["axial_elasticity", "backlash"]), HYSTERESIS, "disagrees", "names axial_elasticity"),
        (diagnosis("explained", ["creep", "backlash"]), HYSTERESIS, "disagrees", "it names creep (0.31 mm rms)"),
        (diagnosis("explained", ["creep"]), OPEN, "disagrees", "firmly, although nobody knows"),
        (diagnosis("consistent"), HYSTERESIS, "disagrees", "not name friction_hysteresis or backlash, which the lit"),
        (diagnosis("consistent"), HYSTERESIS, "disagrees", "would have shown backlash from 0.02 mm on"),
        (diagnosis("parameters"), OPEN, None, ""),
        (diagnosis("unknown"), HYSTERESIS, "unknown", "0.44 mm rms remain"),
        (diagnosis("unknown"), HYSTERESIS, "unknown", "they follow direction"),
        (diagnosis("ambiguous", ["creep"], ["backlash", "wear"]), HYSTERESIS, "ambiguous", "backlash + wear fit"),
        (diagnosis("ambiguous", ["creep"], ["backlash"]), HYSTERESIS, "ambiguous", "answer is held by one of them"),
        (diagnosis("ambiguous", ["creep"], ["wear"]), HYSTERESIS, "ambiguous", "answer is not held by one of them"),
        (diagnosis("ambiguous", ["creep", "jam"], ["jam"]), OPEN, "ambiguous", "All of them hold jam"),
        (diagnosis("ambiguous", *([name] for name in "abcdefg")), OPEN, "ambiguous", "b; c; d; e and 2 more fit"),
        (diagnosis("ambiguous", ["a"], ["b"]), OPEN, "ambiguous", "would tell: one stroke at a quarter of the speed"),
        (None, HYSTERESIS, "not decided", "too short"),
    ],
)  # fmt: skip
def test_what_is_doubtful_and_why(content, expected, kind, says):
    doubtful = doubt(content, "raw/a: not decided: too short", expected, [])
    assert (doubtful is None) == (kind is None)
    if doubtful is not None:
        assert doubtful[0] == kind and says in doubtful[1]


def test_a_parameter_that_misses_the_literature_is_a_doubt():
    good = {"mass_kg": {"value": 94.8, "low": 94.0, "high": 95.5}}
    bad = {"mass_kg": {"value": 91.0, "low": 90.0, "high": 92.0}}
    assert doubt(diagnosis("consistent", parameters=good), "", None, [MASS]) is None
    kind, why = doubt(diagnosis("consistent", parameters=bad), "", None, [MASS])
    assert kind == "disagrees" and "Its mass is 91 (90 to 92) kg, the literature's 95 kg." in why
    content = diagnosis("explained", ["sensor_offset"])
    assert found_answer(content, OFFSET) is None
    content["mechanisms"][0]["parameters"] = {"offset_n": {"value": -3.1, "low": -3.4, "high": -2.9}}
    assert found_answer(content, OFFSET) == (3.1, 2.9, 3.4)


@pytest.fixture
def report_inputs(tmp_path):
    """What the rules before the page make: verdicts, black boxes and transfer of one rig."""
    rig = tmp_path / "reports" / "real" / "tsa_haptic"

    def verdict(name, content, words):
        return made_verdict(rig / name, words, content)

    tied = diagnosis("ambiguous", ["backlash"], ["sensor_lag"])
    tied["fit"]["relative_residual"] = {"nominal": 0.74, "calibrated": 0.7, "explained": 0.034, "filter": "10 Hz"}
    verdicts = [
        verdict("a", tied, "a: ambiguous: <several> fit alike."),
        verdict("b", diagnosis("explained", ["friction_hysteresis"]), "b: explained."),
        verdict("c", None, "c: not decided: 1 stroke decides nothing"),
    ]
    together = verdict("together/module-1", diagnosis("unknown"), "module-1: unknown")
    boxes = []
    for name, errors in (("a", {"gradient_boosting": 0.09, "gaussian_process": 0.5, "mlp": 0.6}), ("c", None)):
        boxes.append(tmp_path / f"{name}.json")
        boxes[-1].write_text(json.dumps({"run": name, "heldout": errors}))
    pairs = [("b", "a", "explained", 0.2), ("c", "a", "explained", 0.4), ("b", "a", "mlp", 0.1), ("a", "b", "mlp", 0.7)]
    pairs += [("all others", "a", "explained", 0.05), ("all others", "a", "mlp", 0.08)]
    columns = ["group", "learnt_from", "asked_about", "method", "rms", "centred_rms", "unit"]
    rows = [("module-1", *pair, pair[-1] / 2, "mm") for pair in pairs]
    pd.DataFrame(rows, columns=columns).to_csv(tmp_path / "transfer.csv", index=False)
    return verdicts, together, boxes, tmp_path / "transfer.csv"


def run(tmp_path, verdicts, together, boxes, transfer):
    out = tmp_path / "reports" / "real"
    words = ["tsa_haptic", "--verdicts", *verdicts, "--together", *together, "--black-boxes", *boxes]
    words += ["--transfer", *transfer, "--out", out / "tsa_haptic.html", "--figure", out / "tsa_haptic.png"]
    words += ["--table", tmp_path / "rows.csv"]
    done = programs.run("pipeline.report.real.page", *words)
    assert done.returncode == 0, done.stderr
    words = [tmp_path / "rows.csv", "--out", out / "index.html", "--table", out / "table.csv"]
    done = programs.run("pipeline.report.real.index", *words, "--passed-over", "./data/<b>.txt")
    assert done.returncode == 0, done.stderr
    return out


def test_the_pages_say_what_the_files_say(report_inputs, tmp_path):
    verdicts, together, boxes, transfer = report_inputs
    out = run(tmp_path, verdicts, [together], boxes, [transfer])
    page, index = (out / "tsa_haptic.html").read_text(), (out / "index.html").read_text()
    assert "&lt;several&gt; fit alike" in page and "2 to 11 turns" in page and "1–4" in page
    assert "<span class=best>0.09</span>" in page  # of the six methods on a: boosted trees
    assert "74.0 %" in page and "3.4 %" in page and "Filter: 10 Hz" in page
    assert "<td class=text>all others</td><td>1</td><td></td><td><span class=best>0.05</span></td>" in page
    assert "0.18 to 0.37 mm" in page and "https://github.com/FaragSeif/tsa_haptic" in page
    for link in re.findall(r'(?:src|href)="([^"#:]+)"', page):
        assert link == "index.html" or (out / link).is_file(), link
    assert "1 stroke decides nothing" in index and "The tool can be wrong in public" in index
    assert "3 of 4 verdicts are ambiguous" in index
    assert "<li>./data/&lt;b&gt;.txt</li>" in index
    assert (
        "better on 1 of 1 recordings. On another recording the best of the three black boxes is better on 1 of 1"
        in index
    )
    for link in re.findall(r'href="?([^" >#:]+)', index):
        assert (out / link).is_file(), link


def test_the_table_holds_every_verdict_and_every_method(report_inputs, tmp_path):
    verdicts, together, boxes, transfer = report_inputs
    out = run(tmp_path, verdicts, [together], boxes, [transfer])
    with open(out / "table.csv", newline="") as file:
        rows = {row["recording"]: row for row in csv.DictReader(file)}
    assert list(rows) == ["a", "b", "c", "module-1 together"]
    assert rows["a"]["explained"] == "0.12" and rows["a"]["gradient_boosting"] == "0.09" and rows["a"]["ties"] == "1"
    assert float(rows["a"]["elsewhere_explained"]) == pytest.approx(0.3)  # the median over both sources
    assert rows["a"]["others_explained"] == "0.05" and rows["b"]["others_mlp"] == ""
    assert rows["b"]["elsewhere_mlp"] == "0.7" and rows["b"]["doubt"] == "" and rows["b"]["gradient_boosting"] == ""
    assert rows["c"]["doubt"] == "not decided" and rows["c"]["verdict"] == "not decided"
    assert rows["module-1 together"]["explained"] == "0.12" and rows["module-1 together"]["mlp"] == ""
    assert rows["module-1 together"]["doubt"] == "unknown"


def test_a_rig_with_one_recording_and_no_verdict_has_its_page_all_the_same(report_inputs, tmp_path):
    verdicts, *_ = report_inputs
    out = run(tmp_path, verdicts[2:], [], [], [])
    assert "nothing to carry over" in (out / "tsa_haptic.html").read_text()
    assert (out / "tsa_haptic.png").stat().st_size > 1000
    assert "1 of 1 verdicts" in (out / "index.html").read_text()


def test_the_smallest_error_is_the_bold_one(report_inputs):
    verdicts, _, boxes, transfer = report_inputs
    assert page.sizes({"nominal": 2.0, "mlp": 0.5}, ["nominal", "explained", "mlp"]) == [
        "2", "", "<span class=best>0.5</span>",
    ]  # fmt: skip
    a, b, c = read_results(verdicts, [], boxes, pd.read_csv(transfer))
    assert a.heldout == {"nominal": 1.92, "calibrated": 0.81, "explained": 0.12, "gradient_boosting": 0.09,
                         "gaussian_process": 0.5, "mlp": 0.6}  # fmt: skip
    assert c.heldout == {} and b.group == "module-1"
    rows = pd.DataFrame([{"rig": "tsa_haptic", **entry.row(read_rigs()["tsa_haptic"])} for entry in (a, b, c)])
    beaten_text = index.beaten(rows)
    assert (
        beaten_text.count("better on 1 of 1") == 2
        and "learnt from all others the best of the three black boxes is better on 0" in beaten_text
    )
