"""Each equation of docs/physics.md does what its mechanism does: a string and a code that part are seen.

`equation_cases.py` has how they are compared, `equations_of_*.py` each equation as a function.
"""

import subprocess
from dataclasses import replace
from pathlib import Path

import equations_of_length
import equations_of_reading
import equations_of_resistance
import equations_of_twist
import numpy as np
import pytest
from equation_cases import CASES, Case
from equation_motion import drivers, motion, under_one_load

from pipeline.diagnosis.mechanisms import interface
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.ground.outside_library import is_outside

FOLDER = Path(interface.__file__).parent
# modules whose cases are in `CASES` by being read
WRITTEN = (equations_of_length, equations_of_reading, equations_of_resistance, equations_of_twist)


def ids_of_the_project() -> list[str]:
    """Mechanisms that git has; where there is no git, those of the library. A person's own need no case."""
    listed = subprocess.run(["git", "ls-files", "."], cwd=FOLDER, capture_output=True, text=True)
    kept = {Path(line).stem for line in listed.stdout.splitlines()} if listed.returncode == 0 else set()
    return [id_ for id_ in mechanisms() if id_ in kept or not is_outside(id_)]


def equations(id_: str) -> set[str]:
    """Each equation that a page or a person may be shown of a mechanism."""
    mechanism = mechanisms()[id_]
    return {mechanism.equation, *mechanism.variants.values(), mechanism.plain_equation} - {""}


def named(case: Case) -> str:
    return f"{case.id}: {case.evaluated.__name__}"


@pytest.mark.parametrize("id_", ids_of_the_project())
def test_each_equation_is_written_down_as_a_function_word_for_word(id_: str) -> None:
    written = {case.equation for case in CASES if case.id == id_}
    assert written == equations(id_), "write the function of tests/diagnosis/mechanisms/equations_of_*.py anew, too"


@pytest.mark.parametrize("case", CASES, ids=named)
def test_an_equation_gives_what_its_mechanism_adds(case: Case) -> None:
    terms, apart = case.terms(), np.ones(len(motion(case.rig).t), bool)
    assert terms
    for term in terms:
        coded, expected = case.coded(term), case.by_equation(term)
        if case.jumps:  # a sample that holds a jump is a mean of before and after
            jumps = np.flatnonzero(np.abs(np.diff(expected)) > 0.1 * np.ptp(expected))
            apart[[place + side for place in jumps for side in (-1, 0, 1, 2)]] = False
        largest = float(np.abs(coded).max())
        assert largest > 0.0, f"{term.name}: this motion does not show it"
        off = np.abs(coded - expected)[apart].max() / largest
        assert off <= case.within, f"{term.name} is off by {off:.2g} of its largest value"


@pytest.mark.parametrize("id_", ids_of_the_project())
def test_each_coefficient_has_its_part_in_an_equation(id_: str) -> None:
    checked = {term.name for case in CASES if case.id == id_ for term in case.terms()}
    string, drive, mass = drivers("string", False), drivers("drive", False), drivers("drive", True)
    rigs = (string, drive, mass, under_one_load(string), under_one_load(drive), replace(drive, turn=None))
    named = {
        term.name
        for rig in rigs
        for nonlinear in mechanisms()[id_].candidates(rig)[:400:3]
        for term in mechanisms()[id_].terms(rig, nonlinear)
    }
    assert named <= checked


def test_half_a_play_is_as_its_equation_says() -> None:
    half_play = mechanisms()["backlash"].derived["half_play_turns"]
    a, b, w = (0.6, 0.3), (1.0, 0.5), 0.2
    values = {"half_width_turns": w, "share": a[0], "inner_share": a[1]}
    assert half_play(values) == pytest.approx(w * sum(x * y for x, y in zip(a, b, strict=True)))


def test_a_tenth_more_would_be_seen() -> None:
    assert all(case.within < 0.07 for case in CASES)
