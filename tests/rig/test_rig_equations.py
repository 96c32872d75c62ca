"""The table of state equations of docs/concealment.md, which is typed by hand, says what the rig's effects do."""

import re
from pathlib import Path
from types import SimpleNamespace

import effects_of_the_drive
import effects_on_the_string
import numpy as np
import pytest
from effect_motion import EQUATIONS, STEP_S, lived

from pipeline.rig import effects

PAGE = (Path(__file__).parents[2] / "docs" / "concealment.md").read_text(encoding="utf-8")
TABLE = PAGE.partition("| effect | state equation on the rig |")[2].partition("\n\n")[0]
WRITTEN = (effects_on_the_string, effects_of_the_drive)  # their functions are in `EQUATIONS` by being read
# of the largest value, where steps of 2 ms do not follow the effect as nearly as the usual share
WITHIN = {"radius_compaction": 0.03, "load_swing": 0.02, "wear": 0.01}
USUAL = 5e-3
# whose jumps may come a step early or late
JUMPS = {"stick_slip", "count_slip", "clamp_slip"}


def cells() -> dict[str, str]:
    """The table's equation of each effect."""
    rows = re.findall(r"^\| ([a-z_, ]+) \| (.*?) \|", TABLE, flags=re.M)
    return {name: cell for names, cell in rows for name in names.split(", ")}


def test_each_effect_of_the_library_has_a_row_and_each_row_its_function_word_for_word() -> None:
    table_cells = cells()
    assert sorted(table_cells) == [name for name in effects.names() if not name.startswith("x_")]
    assert {name: cell for name, (cell, _, _) in EQUATIONS.items()} == table_cells


@pytest.mark.parametrize("name", EQUATIONS)
def test_an_effect_obeys_the_equation_of_its_row(name: str) -> None:
    _, parameters, function = EQUATIONS[name]
    bare = lived()
    does = effects.make(name, parameters).run(lived())
    answer = function(bare, parameters, does)
    left_side, right = answer if isinstance(answer, tuple) else (does, answer)
    assert np.ptp(left_side) > 0.0
    off = np.abs(left_side - right) / np.ptp(left_side)
    assert np.mean(off > WITHIN.get(name, USUAL)) <= (1e-3 if name in JUMPS else 0.0), off.max()


def test_a_tenth_of_the_stretch_comes_after_4_to_8_s() -> None:
    hidden = effects.concealed("axial_elasticity")
    match = re.search(r"a (tenth) of it after (\d) to (\d) s", cells()["axial_elasticity"])
    drawn = [hidden.draw(SimpleNamespace(load_n=20.0), np.random.default_rng(seed)) for seed in range(200)]
    late_s = [parameters["late_s"] for parameters in drawn]
    assert match is not None and np.mean([parameters["late"] for parameters in drawn]) == pytest.approx(0.1, abs=0.005)
    assert min(late_s) == pytest.approx(float(match[2]), abs=0.1) and max(late_s) == pytest.approx(
        float(match[3]), abs=0.1
    )
    at = lived()
    at.load_n = np.where(np.arange(len(at.load_n)) * STEP_S < 5.0, 10.0, 20.0)
    does = effects.make("axial_elasticity", {"late": 0.1, "late_s": 5.0}).run(at)
    stepped, end = round(5.0 / STEP_S), does[-1]
    assert (end - does[stepped]) / (end - does[0]) == pytest.approx(0.1, abs=5e-3)
