"""What the numbers of an adopted effect multiply, in words."""

import re
from dataclasses import replace

import numpy as np
import pytest

from pipeline.adoption.number_sizes import sizes
from pipeline.diagnosis.choice.outcome import rms
from pipeline.diagnosis.facts.mechanism_entries import effect_of, unit_of_nonlinear
from pipeline.diagnosis.fit.problem import Act
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.recording.system_units import Units
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.named import coefficients
from pipeline.diagnosis.words.named.coefficients import factors
from pipeline.diagnosis.words.named.shape_numbers import CHOSEN, shape_number
from pipeline.ground.units import unit_of
from pipeline.systems import systems

NAMES = {"twist": "a", "steep_twist": "b", "load": "c", "dry_*_twist": "d"}


def test_of_two_words_at_one_place_the_longer_one_is_meant() -> None:
    assert factors(NAMES, "steep_twist_60_s_mm_per_10_n") == {"steep_twist": "b"}
    assert factors(NAMES, "twist_60_s_mm") == {"twist": "a"} and factors(NAMES, "load_4_s_mm") == {"load": "c"}


def test_a_share_within_a_name_is_any_number() -> None:
    assert factors(NAMES, "dry_0.02_twist_mm_per_10_n") == {"dry_*_twist": "d"}


def test_each_number_has_a_sentence_with_its_unit_and_what_it_does_at_full_twist(problem) -> None:
    words = Vocabulary.of(problem.system)
    shape = {"critical_turns": 0.5 * float(problem.record.motion.max()), "softness_turns": 0.1}
    state = replace(problem.nominal(), acts=(Act("jam", (shape,), (0.4, 0.0)),))
    ((whole, share),) = own = sizes(problem, state)
    assert whole == share, "the other coefficient is 0, and has no line"
    effect = problem.simulate(state) - problem.simulate(problem.nominal())
    assert whole.rms == pytest.approx(rms(effect_of(problem, state, state.acts[0]))), "the size that a verdict gives"
    assert whole.rms == pytest.approx(rms(effect)) and whole.at_top < 0.0
    top = problem.record.motion >= 0.999 * problem.record.motion.max()
    assert whole.at_top == pytest.approx(np.mean(effect[top]), rel=0.1), "beyond the critical twist it contracts less"
    _, first, head, number, does, critical, softness, formula = coefficients.lines(
        state.acts, problem.drivers, words, own
    )
    assert first.startswith("  jam: ") and "In all it moves the reading by " in first and " rms, and by -" in first
    assert head.startswith("    number ") and "reading moved, rms   at " in head and " against " in head
    assert number.startswith("    share = 0.4 (a share)   ") and does == "      acts on the twist"
    assert number.split()[5:] == first.split("by ")[1].split()[:2] + first.split("by ")[2].split()[:2]
    assert critical.endswith(" turns: the twist from which on it acts.") and softness.startswith("    softness_turns")
    assert formula == f"    Its formula: {mechanisms()['jam'].equation}"


def test_a_factor_with_a_share_in_the_names_is_said_once_above_the_table(problem) -> None:
    """Eight rows said "the state of a stop, from -1 to 1, as wide as that share of the range", and not which share."""
    names = ["stop_0.08_load_mm_per_10_n", "stop_0.2_load_mm_per_10_n", "dry_0.1_twist_mm_per_10_n"]
    stop, dry = coefficients._shares(mechanisms()["friction_hysteresis"], names)
    assert stop.startswith(
        "    stop: the state of a stop, from -1 to 1, as wide as a share of the range. In stop_0.08_"
    )
    assert stop.endswith(" the share is 0.08.") and dry.endswith(" In dry_0.1_twist_mm_per_10_n the share is 0.1.")
    what = coefficients._what(mechanisms()["friction_hysteresis"], names[0], "is lost")
    assert what == "is lost; it multiplies stop; it multiplies the load"


def candidates(mechanism, problem) -> list[dict[str, float]]:
    """What a mechanism tries on a string, and on a drive that twists nothing."""
    return [*mechanism.candidates(problem.drivers), *mechanism.candidates(replace(problem.drivers, levered=False))]


def test_every_number_in_a_formula_has_its_meaning(problem) -> None:
    words = Vocabulary.of(problem.system)
    keys = {key for one in mechanisms().values() for shape in candidates(one, problem) for key in shape}
    for key in keys | {key for one in mechanisms().values() for key in one.units}:
        assert CHOSEN not in shape_number(key, key, words) and "{" not in shape_number(key, key, words), key
    assert CHOSEN in shape_number("of_your_own", "of_your_own", words)


def test_a_number_in_a_formula_has_the_unit_of_its_names_whole_ending(problem) -> None:
    words, rigs = Vocabulary.of(problem.system), systems()
    keys = {key for one in mechanisms().values() for shape in one.candidates(problem.drivers) for key in shape}
    per_s = sorted(key for key in keys if key.endswith("_per_s"))
    assert "fastest_turns_per_s" in per_s
    for key in per_s:
        assert shape_number(key, key, words).startswith(" turns/s: "), key
    assert shape_number("fastest_s", "fastest_s", words).startswith(" s: the shortest time constant")
    drive = rigs["cable_drive"]
    own = Units.of(drive).name("slow_turns_per_s")
    assert shape_number("slow_turns_per_s", own, Vocabulary.of(drive)).startswith(" deg/s: "), own
    for key in keys:
        assert unit_of_nonlinear(key) in ("1", unit_of(key)), key


@pytest.mark.parametrize("id_", [id_ for id_, one in mechanisms().items() if one.names])
def test_every_word_that_is_explained_stands_in_a_name_of_its_mechanism(problem, id_: str) -> None:
    one, drivers = mechanisms()[id_], problem.drivers
    options = [nonlinear | ({"loaded": 1.0} if "loaded" in nonlinear else {}) for nonlinear in candidates(one, problem)]
    named = [f"_{term.name}_" for nonlinear in options for term in one.terms(drivers, nonlinear)]
    for word in one.names:
        there = re.compile(f"_{re.escape(word)}_".replace(r"\*", "[0-9.]+"))
        assert any(there.search(name) for name in named), word
