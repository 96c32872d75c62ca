"""What a regression without physics foretells of unseen strokes."""

import re

import pytest
from made_content import SYSTEMS, content, explanation, told

from pipeline.diagnosis.words.held_out import level
from pipeline.diagnosis.words.language.vocabulary import Vocabulary


def test_a_verdict_without_a_name_says_what_it_is_worth_and_what_comes_closest():
    text = told(content(verdict="consistent", mismatch=None, mechanisms=[], alternatives=[], next_run=None))
    assert (
        "from this size on (rms):\n  backlash   0.0040 mm   creep   0.020 mm" in text and "What is missing" not in text
    )
    shown = [explanation([], "nothing", 0.45), explanation(["x_wave"], "not enough", 0.06)]
    text = told(content(verdict="unknown", mechanisms=[], alternatives=[], evidence__explanations=shown))
    rows = [re.split(" {2,}", line.strip()) for line in text.splitlines()]
    assert ["x_wave", "99 %", "0.060 mm (2.0)", "no physics of the library"] in rows
    assert ["calibration alone", "0 %", "0.45 mm (15)"] in rows, "what remains without any"
    assert "library: x_wave (a steady oscillation in time, whatever the rig does)." in " ".join(text.split()), (
        "in words"
    )
    assert "Do not report an effect: none is named" in text and "Now in force" not in text
    assert "At most three effects at once are tried" in text


@pytest.mark.parametrize(
    ("verdict", "without", "expected", "never"),
    [
        (
            "ambiguous",
            0.02,
            "foretells the unseen strokes better than the explanation: 0.020 mm rms against",
            "level",
        ),
        ("ambiguous", 0.6, "", "regression"),
        (
            "unknown",
            0.02,
            "errs by 0.020 mm rms on the unseen strokes, calibration by 0.80 mm rms. That is the level",
            "better",
        ),
        ("unknown", 0.79, "calibration by 0.80 mm rms: it does no better, so nothing that was recorded", "level"),
        ("unknown", None, "", "regression"),
    ],
)
def test_what_a_regression_without_physics_foretells_is_said_where_it_tells_something(
    verdict, without, expected, never
):
    heldout = content()["fit"]["heldout"] | {"calibrated_mm": 0.8, "explained_mm": 0.8}
    heldout |= {} if without is None else {"without_physics_mm": without}
    place = {"motor_turns": [20.0, 26.0], "strokes": [8, 9], "phase": "winding", "share": 0.8}
    changes = {"fit__heldout": heldout, "evidence__left_of_unseen": {"location": place, "driver": "direction"}}
    changes |= {"mechanisms": [], "alternatives": [], "next_run": None} if verdict == "unknown" else {}
    diagnosis = content(verdict=verdict, **changes)
    words = Vocabulary.of(SYSTEMS["mm"])
    lines = " ".join(
        [*level.beaten(diagnosis, words), *(level.to_reach(diagnosis, words) if verdict == "unknown" else [])]
    )
    assert expected in lines and never not in lines
    diagnosis["evidence"]["chosen_without_them"] = ["wear"]
    other = " ".join(
        [*level.beaten(diagnosis, words), *(level.to_reach(diagnosis, words) if verdict == "unknown" else [])]
    )
    assert not other or ("wear" in other and "calibration" not in other)
    del diagnosis["evidence"]["chosen_without_them"]
    whole = " ".join(told(diagnosis).split())
    assert expected in whole and (level.METHOD in whole) == bool(expected)
    if without == 0.02:
        assert "at 20 to 26 turns, in strokes 8 to 9, while winding, and it follows the direction of motion" in lines
