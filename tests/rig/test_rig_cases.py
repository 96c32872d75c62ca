"""The cases of the two rigs without a string: each shows what it hides, and its truth stays outside the run."""

import json
from pathlib import Path

import numpy as np
import programs
import pytest

from pipeline.rig.others import cable_drive, moving_mass
from pipeline.rig.others.cases import CASES, make

ROOT = Path(__file__).parents[2]


def program(*arguments):
    return programs.run("pipeline.rig.others", *arguments)


@pytest.mark.parametrize("name", CASES)
def test_a_case_hides_what_it_says_and_enough_of_it(name):
    case, other = make(name, 1), make(name, 2)
    kinds = (cable_drive if name.startswith("cable-") else moving_mass).EFFECTS
    json.dumps(case.truth)
    assert list(case.truth["effects"]) == list(CASES[name].effects)
    noise = case.truth["noise"]["jaw_deg" if name.startswith("cable-") else "force_n"]
    for effect, effect_truth in case.truth["effects"].items():
        assert effect_truth["rms"] > 2 * noise and effect_truth["mechanism"] == kinds[effect].mechanism
        assert 0.7 <= abs(effect_truth["size"] / CASES[name].effects[effect]) <= 1.4
        assert effect_truth["size"] != other.truth["effects"][effect]["size"]


def test_every_effect_of_both_rigs_has_a_case():
    for kind, rig in (("cable-", cable_drive), ("mass-", moving_mass)):
        hidden = {effect for name, case in CASES.items() if name.startswith(kind) for effect in case.effects}
        assert hidden == set(rig.EFFECTS)


def test_the_same_rig_runs_another_plan():
    first, other = make("cable-friction", 3), make("cable-friction", 3, plan="sine-0.5", take=2)
    sizes = [case.truth["effects"]["friction_hysteresis"]["size"] for case in (first, other)]
    assert sizes[0] == sizes[1] and first.truth["parameters"] == other.truth["parameters"]
    assert not np.array_equal(first.samples.motor_deg, other.samples.motor_deg)


def test_the_program_writes_a_run_and_keeps_its_answer_elsewhere(tmp_path):
    done = program("mass-coulomb", tmp_path / "run-1", "--seed", 4, "--answer", tmp_path / "answer.json")
    assert done.returncode == 0, done.stderr
    assert done.stdout == f"written: {tmp_path / 'run-1'} (what is hidden: {tmp_path / 'answer.json'})\n"
    assert sorted(path.name for path in (tmp_path / "run-1").iterdir()) == ["recording.parquet", "run.yaml"]
    assert json.loads((tmp_path / "answer.json").read_text())["effects"]["friction_hysteresis"]["unit"] == "N"
    for arguments, says in (
        (("mass-coulomb", tmp_path / "run-1"), "is there already"),
        (("mass-coulomb", tmp_path / "run-2", "--plan", "waltz"), "is no plan"),
        (("mass-coulomb", tmp_path / "run-2", "--answer", tmp_path / "run-2" / "answer.json"), "inside the run folder"),
    ):
        done = program(*arguments)
        assert done.returncode == 2 and says in done.stderr and not (tmp_path / "run-2").exists()
