"""A verdict on several runs says what the one on fewer of them said, which it replaces."""

import json
from pathlib import Path

import pytest
from made_content import SYSTEMS, confident, spoken

from pipeline.diagnosis.words.pages import earlier
from pipeline.diagnosis.written import write_words

FOLDERS = [Path("raw/nylon-3"), Path("raw/nylon-4")]
SAID = (
    "Before, the verdict on nylon-3 alone ({}) named friction_hysteresis (93 %) and creep (46 %). This one rests on "
    "more data and replaces it."
)


def written(out: Path, runs: str | list[str], **changes: object) -> str:
    """The page of a verdict on some runs, written into a folder."""
    diagnosis = spoken(confident(0.93, 0.46) | {"run": runs, "simulation": [], **changes}, SYSTEMS["mm"])
    return " ".join(
        write_words(diagnosis, SYSTEMS["mm"], FOLDERS[: 1 if isinstance(runs, str) else 2], out, []).split()
    )


@pytest.mark.parametrize(
    "place", ["reports/mine/nylon-3", "reports/mine/both", "reports/mine/both/nylon-3", "reports/diagnosis/nylon-3"]
)
def test_a_verdict_on_two_runs_says_what_the_one_on_one_of_them_said(tmp_path, monkeypatch, place):
    monkeypatch.chdir(tmp_path)
    assert "Before, the verdict" not in written(Path(place), "nylon-3"), "there was none before"
    text = written(Path("reports/mine/both"), ["nylon-3", "nylon-4"])
    assert SAID.format(place) in text.partition("What acts")[0]
    assert len(Path("reports/mine/both/verdict.txt").read_text().splitlines()) <= 66
    if place != "reports/mine/both":
        again = written(Path("reports/mine/both"), ["nylon-3", "nylon-4"])
        assert again == text, "the same verdict once more replaces none but that of fewer runs"


def test_a_verdict_on_other_runs_or_one_that_cannot_be_read_is_not_spoken_of(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    written(Path("reports/mine/nylon-3"), ["nylon-3", "nylon-9"])
    Path("reports/mine/nylon-4").mkdir()
    Path("reports/mine/nylon-4/diagnosis.json").write_text(json.dumps({"run": "nylon-4"}))
    assert "Before, the verdict" not in written(Path("reports/mine/both"), ["nylon-3", "nylon-4"])
    written(
        Path("reports/mine/nylon-4"), "nylon-4", verdict="parameters", mechanisms=[], alternatives=[], next_run=None
    )
    both = written(Path("reports/mine/both"), ["nylon-3", "nylon-4"])
    assert "Before, the verdict on nylon-4 alone (reports/mine/nylon-4) was parameters." in both
    assert "Before, the verdict" not in written(Path("reports/mine/nylon-3"), "nylon-3"), "one run is not more"


def test_runs_that_are_explained_alone_and_not_together_are_asked_whether_they_are_of_one_string(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    written(Path("reports/mine/nylon-3"), "nylon-3", verdict="explained", alternatives=[])
    nothing = {"verdict": "unknown", "mechanisms": [], "alternatives": [], "next_run": None}
    text = written(Path("reports/mine/both"), ["nylon-3", "nylon-4"], **nothing)
    assert "Alone it was explained, together the runs are not: are they of one string" in text
    assert "replaces it" not in text


def test_what_the_verdict_on_more_runs_does_not_keep_is_said(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    radius = {"nominal": 0.55, "value": 0.531, "low": 0.529, "high": 0.533}
    written(Path("reports/mine/nylon-3"), "nylon-3", parameters={"radius_mm": radius})
    folder, runs = Path("reports/mine/both"), ["nylon-3", "nylon-4"]
    kept = written(folder, runs, parameters={"radius_mm": radius})
    assert "replaces it. What acts" in kept or "replaces it. Calibration" in kept, "nothing is lost"
    now = spoken(confident(0.93, 0.46), SYSTEMS["mm"])
    alone = [entry for entry in now["mechanisms"] if entry["id"] == "creep"]
    moved = {"nominal": 0.55, "value": 0.561, "low": 0.56, "high": 0.563}
    evidence = now["evidence"] | {"tolerance": {"radius_mm": 0.0165}}
    changed = {"mechanisms": alone, "alternatives": [], "evidence": evidence, "verdict": "explained"}
    text = written(folder, runs, **changed, parameters={"radius_mm": moved})
    sentence = "replaces it. This one does not name friction_hysteresis and has a radius of 0.561 mm, not 0.531 mm."
    assert sentence in text, text[:900]
    changed["alternatives"] = [["friction_hysteresis", "thermal"]]
    text = written(folder, runs, **changed | {"verdict": "ambiguous"}, parameters={"radius_mm": radius})
    assert "This one has friction_hysteresis only in another likely explanation." in text
    nearly = {**moved, "value": 0.535, "low": 0.5345, "high": 0.5355}
    assert "not 0.53" not in written(folder, runs, **changed, parameters={"radius_mm": nearly})


def verdict(runs, name, ids):
    """As much of a diagnosis.json as is read."""
    listed = [{"id": id_, "confidence": 0.9} for id_ in ids]
    return {"run": runs, "verdict": name, "mechanisms": listed, "alternatives": [], "evidence": {}, "parameters": {}}


@pytest.mark.parametrize(
    ("before", "now", "is_asked"),
    [
        (("explained", ["friction_hysteresis"]), ("unknown", []), True),
        (("explained", ["friction_hysteresis"]), ("ambiguous", ["friction_hysteresis", "x_clock"]), True),
        (("explained", ["friction_hysteresis", "x_clock"]), ("explained", ["friction_hysteresis", "x_clock"]), False),
        (("explained", ["friction_hysteresis"]), ("explained", ["friction_hysteresis", "creep"]), False),
        (("unknown", []), ("unknown", []), False),
    ],
)
def test_runs_that_only_a_stand_in_joins_are_asked_whether_they_are_of_one_string(
    tmp_path, monkeypatch, before, now, is_asked
):
    alone = verdict("a-1", *before)
    monkeypatch.setattr(earlier, "read_diagnosis", lambda path: alone)
    (tmp_path / "a-1").mkdir()
    (tmp_path / "a-1" / "diagnosis.json").write_text(json.dumps(alone))
    (line,) = earlier.sentences(verdict(["a-1", "a-2"], *now), [tmp_path / "a-1"], tmp_path)
    assert ("are they of one string, mounted and measured alike?" in line, "replaces it" in line) == (
        is_asked,
        not is_asked,
    )
