"""A verdict without a name that leaves more than noise: one size of it, what to measure, what to record."""

import copy

from made_content import SYSTEMS, content, full, page

from pipeline.diagnosis.drawing.figures import warning
from pipeline.diagnosis.words.held_out.unseen import exact
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.next_run.recorded_so_far import not_yet

MM = Vocabulary.of(SYSTEMS["mm"])
LEFT = {"verdict": "parameters", "mechanisms": [], "alternatives": [], "next_run": None, "evidence__explanations": [],
        "evidence__nominal_mm": 0.09, "evidence__calibrated_mm": 0.06}  # fmt: skip


def joined(text):
    return " ".join(text.split())


def test_what_moved_far_is_in_the_table_and_is_measured_first():
    text = page(content(**LEFT))
    table = text.partition("Dimensions\n")[2].partition("\n\n")[0]
    assert table.splitlines()[3].split()[:3] == ["radius", "0.55", "mm"]
    assert "1. Measure the radius again, write what you measured into run.yaml, and diagnose again." in joined(text)
    assert "2. Record the rig in other ways, " in text
    assert "Until it is measured again (below), this verdict is provisional." in joined(text)
    assert "measure it again first (verdict.txt)" in warning(content(**LEFT), MM)
    in_vain = content(**LEFT | {"evidence__nominal_mm": 0.061})
    assert "Measure the radius again, write" not in page(copy.deepcopy(in_vain))
    assert warning(in_vain, MM).endswith("measure it again first")


def test_what_is_left_has_one_size():
    diagnosis = content(**LEFT)
    assert "0.052 mm rms is more than noise" in page(copy.deepcopy(diagnosis))
    assert "- 0.052 mm rms is missing after calibration, noise taken off" in joined(full(diagnosis))


def test_a_ratio_below_the_limit_is_rounded_as_the_others():
    assert [exact(ratio) for ratio in (1.28, 1.3, 1.34, 1.36, 12.0)] == ["1.3", "1.3", "1.34", "1.4", "12"]


def test_other_ways_are_those_that_the_recording_does_not_have():
    covered = {"load": [10.0, 10.0], "speed_per_s": [2.0, 2.1], "longest_hold_s": 0.0, "longest_rest_s": 0.2}
    diagnosis = {"evidence": {"covered": covered, "loaded": False}}
    assert not_yet(diagnosis, MM) == "at another speed, under another load and with pauses"
    diagnosis["evidence"]["loaded"] = True
    covered |= {"load": [7.0, 15.0], "longest_hold_s": 11.0}
    assert not_yet(diagnosis, MM) == "at another speed"
    covered["speed_per_s"] = [1.4, 5.1]
    beyond = "beyond what it has, as far as it bears that (speeds of 1.4 to 5.1 turns/s, loads of 7 to 15 N and pauses"
    assert not_yet(diagnosis, MM) == f"{beyond} of up to 11 s)"
    assert not_yet({"evidence": {}}, MM) == "at another speed, under another load and with pauses"
