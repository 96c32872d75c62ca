"""A joint diagnosis in memory simulates each of its recordings as the same runs in folders are simulated."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from made_recording import content, recording

import pipeline as tb
from pipeline.notebook import diagnosis as in_a_notebook

CREEP = {
    "id": "creep",
    "parameters": {"fresh": 1.0, "fastest_s": 1.0, "slowest_s": 700.0, "loaded": 1.0, "load_120_s_mm_per_10_n": 0.3},
}  # fmt: skip
RADIUS = {"value": 0.41, "nominal": 0.4}
FITTED = {"angle_turns": 0.1, "angle_turns_2": 0.3, "zero_1_mm": -4.9, "zero_2_mm": -4.2}
VERDICT = {
    "verdict": "explained", "mismatch": None, "mechanisms": [], "alternatives": [], "fit": {"noise_floor_mm": 0.02},
    "parameters": {name: {"value": value} for name, value in FITTED.items()} | {"radius_mm": RADIUS},
    "simulation": [CREEP],
}  # fmt: skip
PLAN = pd.DataFrame({"time_s": [0.0, 2.0, 4.0], "motor_turns": [0.0, 8.0, 0.0], "load_n": 20.0})


def of(name: str, seed: int = 0, **string: object) -> tb.Recording:
    """A short recording in memory."""
    description = content(name)
    table = recording(2, rate_hz=10.0, top=8.0, speed=4.0, seed=seed)
    return tb.Recording.of(table, {**description, "string": {**description["string"], **string}})


@pytest.fixture
def joint(monkeypatch: pytest.MonkeyPatch) -> tuple[tb.Recording, tb.Recording, tb.Diagnosis]:
    """Two recordings of one string, and their diagnosis, whose search is left out."""
    monkeypatch.setattr(in_a_notebook, "diagnosed", lambda *_: (dict(VERDICT), None))
    first, later = of("a-1"), of("a-2", seed=1)
    return first, later, tb.Diagnosis.of(later, first)


@pytest.mark.parametrize("how", [{}, {"motion": PLAN}, {"motion": PLAN, "after_recording": True}], ids=len)
def test_each_recording_is_simulated_as_its_folder_is(joint, how, tmp_path: Path) -> None:
    """The later one began anew, with the zero of its first second: 0.40 mm off a recording that fitted to 0.02 mm."""
    first, later, diagnosis = joint
    (tmp_path / "diagnosis.json").write_text(diagnosis.to_json())
    read = tb.Diagnosis.read(tmp_path / "diagnosis.json", "separator")
    folders = [each.save(tmp_path / "raw") for each in (first, later)]
    for each, folder in zip((first, later), folders, strict=True):
        pd.testing.assert_frame_equal(each.simulate(diagnosis, **how), tb.Recording.read(folder).simulate(read, **how))


@pytest.mark.parametrize("how", [{}, {"motion": PLAN}], ids=len)
def test_a_later_recording_whose_past_is_not_at_hand_says_so(joint, how, tmp_path: Path) -> None:
    _, later, diagnosis = joint
    (tmp_path / "diagnosis.json").write_text(diagnosis.to_json())
    read = tb.Diagnosis.read(tmp_path / "diagnosis.json", "separator")
    for each in (later, tb.Recording.read(later.save(tmp_path / "raw"))):
        words = r"made of a-1 and a-2 together, and here a-1 does not go before.*far off. Mend: .*Diagnosis\.of gave"
        with pytest.warns(UserWarning, match=words) as warned:
            alone = each.simulate(read, **how)
        assert Path(warned[0].filename) == Path(__file__), "it is said of the line that asked"
        gap = alone["displacement_mm"] - later.simulate(diagnosis, **how)["displacement_mm"]
        assert float(np.abs(gap).max()) > 0.05, "the past matters here"


def test_a_recording_that_the_diagnosis_was_not_made_of_does_not_take_the_place_of_its_namesake(joint) -> None:
    first, _, diagnosis = joint
    first.simulate(diagnosis)
    of("a-2", seed=1).simulate(diagnosis)  # the same samples, once more
    with pytest.raises(tb.BadInput, match=r"was made of another recording that is called a-2 too\. Mend: .*own"):
        of("a-2", seed=2).simulate(diagnosis)
    with pytest.warns(UserWarning, match=r"b-1 is of another string than a-1 and a-2.*radius 0\.6 .*0\.4 there"):
        of("b-1", radius_mm=0.6).simulate(diagnosis)
    with pytest.raises(tb.BadInput, match=r"2 have one name, a-1\. Mend: give each a name of its own"):
        tb.Diagnosis.of(first, of("a-1", seed=1))


def test_a_recording_of_a_string_of_another_name_is_said_to_be_that(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(in_a_notebook, "diagnosed", lambda *_: ({**VERDICT, "run": "a-1"}, None))
    diagnosis = tb.Diagnosis.of(of("a-1", id="s-1"))
    of("a-3", seed=2, id="s-1").simulate(diagnosis)
    with pytest.warns(UserWarning, match=r"a-3 is of another string than a-1.*names the string s-2, and a-1 s-1"):
        of("a-3", seed=2, id="s-2").simulate(diagnosis)
