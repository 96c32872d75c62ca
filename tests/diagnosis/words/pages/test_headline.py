"""The first line of a verdict, named or not."""

import pytest
from made_content import LEFT, SYSTEMS, adopted, content, told

from pipeline.diagnosis.study.heldout import worse_than_nominal
from pipeline.diagnosis.words.explanations import unexplained_pattern
from pipeline.diagnosis.words.language.vocabulary import Vocabulary


@pytest.mark.parametrize("verdict", ["parameters", "consistent"])
def test_a_verdict_without_a_name_explains_nothing_where_more_than_noise_is_left(verdict):
    text = adopted(verdict, **LEFT)
    head = " ".join(text.partition("\n\n")[0].split())
    assert head.partition(" Sections: ")[0] == (
        "nylon-3: creep was adopted and something without a name is left: nothing further can be named, "
        "and 0.052 mm rms stays unexplained, 2.5 times the noise. run.yaml as it stands errs by 0.053 "
        "mm rms, calibrated by 0.052 mm."
    )
    assert "Something systematic is still missing" in text
    assert "explains the recording" not in text and "None is needed" not in text and "nothing is missing" not in text
    assert "None can be proposed: what is left follows no effect that could be named." in text


def test_no_effect_smaller_than_what_is_left_is_said_to_have_been_seen():
    text = adopted("parameters", **LEFT)
    more = "Of the errors in the table above, 0.054 mm rms is more than noise: effects of that size and less may hide"
    assert f"{more} in it." in text
    assert "but these only from their own size on (rms):\n  slack   0.11 mm\n" in text and "clamp_slip" not in text
    changes = LEFT | {"fit__detectable_mm": {"clamp_slip": 0.0057}}
    assert "A larger one would have been seen." in adopted("parameters", **changes)
    only_unseen = {"fit__heldout__explained_mm": 0.06, "evidence__calibrated_mm": 0.031}
    assert "0.051 mm rms is more than noise" in adopted("consistent", **only_unseen)


@pytest.mark.parametrize(("alone", "is_stated"), [(0.6, True), (0.505, False)])
def test_what_comes_nearest_is_said_where_nothing_is_named_and_it_takes_a_little_away(alone, is_stated):
    shown = [{"ids": [], "left_mm": 0.4}, {"ids": ["creep"], "left_mm": 0.55}, {"ids": ["wear"], "left_mm": 0.5}]
    diagnosis = content(evidence__explanations=shown, evidence__calibrated_mm=alone)
    lines = unexplained_pattern.nearest(diagnosis, Vocabulary.of(SYSTEMS["mm"]))
    assert len(lines) == is_stated
    if is_stated:
        assert lines[0].startswith("The best that an effect could do: with wear 0.50 mm rms (")
        assert lines[0].endswith("would be left instead of 0.60 mm. That gain is too small to name it.")
        diagnosis["evidence"]["explanations"][2]["ids"] = ["x_swelling"]
        diagnosis["simulation"] = [{"id": "backlash", "parameters": {}}]
        (line,) = unexplained_pattern.nearest(diagnosis, Vocabulary.of(SYSTEMS["mm"]))
        assert "that one more effect could do: with x_swelling (a stand-in that fits the data" in line


def test_what_is_worse_than_the_nominal_simulator_on_unseen_strokes_ends_the_first_line():
    errors_mm = {"nominal": 0.31, "calibrated": 1.1, "explained": 0.2}
    assert worse_than_nominal(errors_mm) == ["calibrated"]
    assert worse_than_nominal(errors_mm | {"explained": 0.4}) == ["calibrated", "explained"]
    assert worse_than_nominal(errors_mm | {"calibrated": 0.312}) == []
    numbers = {f"fit__heldout__{name}_mm": value for name, value in errors_mm.items()}
    first = told(content(**numbers, fit__worse_than_nominal=["calibrated"])).split("\n\n")[0].replace("\n  ", " ")
    sentence = (
        "On the unseen strokes the simulator with what is named errs by 0.20 mm. The simulator of run.yaml as it "
        "stands (nominal) errs by 0.31 mm, and calibrated alone by more: 1.1 mm."
    )
    assert "(ambiguous)" in first and sentence in " ".join(first.split())
    numbers["fit__heldout__explained_mm"] = 0.4
    both = " ".join(told(content(**numbers, fit__worse_than_nominal=["calibrated", "explained"])).split())
    assert "the simulator as diagnosed is worse than the nominal one (0.40 mm against 0.31 mm)." in both
    numbers["fit__heldout__explained_mm"] = 0.311
    same = told(content(**numbers, fit__worse_than_nominal=["calibrated", "explained"])).split("\n\n")[0]
    assert "worse than" not in same, "0.31 mm against 0.31 mm says nothing"
    assert "worse than the nominal" not in told(content()).split("\n\n")[0]
