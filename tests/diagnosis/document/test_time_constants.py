"""One page says one time constant: the test's length follows the constants that carry the effect."""

import numpy as np
import pytest
from made_content import content, page, parameter, told

from pipeline.diagnosis.document.time_constants import half_done_s, time_constants_s
from pipeline.diagnosis.words.named.effect_sentence import half_done, time_constants

CREEP = {
    "fresh": parameter(1.0, "1"), "fastest_s": parameter(1.0, "s"), "slowest_s": parameter(240.0, "s"),
    "load_60_s_mm_per_10_n": parameter(0.016, "mm/10N"), "twist_4_s_mm_per_10_n": parameter(0.44, "mm/10N"),
    "twist_60_s_mm_per_10_n": parameter(0.21, "mm/10N"), "twist_240_s_mm_per_10_n": parameter(0.01, "mm/10N"),
}  # fmt: skip
COVERED = {"load": [20.0, 20.0], "speed_per_s": [1.9, 2.1], "longest_hold_s": 3.0, "longest_rest_s": 60.0}


def test_the_longest_constant_is_one_that_carries_the_effect_and_not_the_longest_that_could_be_shown():
    assert time_constants_s({"parameters": CREEP}) == [4.0, 60.0]
    assert time_constants_s({"parameters": {"whole_s": parameter(300.0, "s")}}) == [300.0], "a drift's own"
    assert time_constants_s({"parameters": {"slowest_s": parameter(240.0, "s")}}) == []


def test_the_test_of_a_slow_effect_lasts_twice_the_longest_constant_that_its_sentence_gives():
    diagnosis = content(verdict="explained", alternatives=[], next_run=None, evidence__covered=COVERED)
    diagnosis["mechanisms"] = [diagnosis["mechanisms"][1] | {"parameters": CREEP}]
    assert "time constants of 4 s to 60 s" in time_constants(CREEP)
    text = " ".join(page(diagnosis).split())
    assert "(2 min or longer each, twice its longest time constant" in text and "8 min" not in text


def test_the_sentence_says_when_half_of_a_creep_is_done():
    """ "Time constants of 60 s to 8 min 20 s" was all that was said of a creep of which half was done after 6 s."""
    fast = {f"load_{tau}_s_mm_per_10_n": parameter(0.2, "mm/10N") for tau in (1, 2, 4, 8)}
    slow = {f"load_{tau}_s_mm_per_10_n": parameter(0.29, "mm/10N") for tau in (60, 500)}
    creep = {"parameters": {"slowest_s": parameter(500.0, "s"), **fast, **slow}}
    time_s = np.linspace(0.0, 600.0, 60_001)
    strain = sum(0.2 * -np.expm1(-time_s / tau) for tau in (1, 2, 4, 8))
    strain = strain + sum(0.29 * -np.expm1(-time_s / tau) for tau in (60, 500))
    half_s = float(np.interp(0.69, strain, time_s))
    assert half_done_s(creep) == pytest.approx((half_s, half_s), rel=2e-3)
    assert half_done(creep) == f"half of it done after {half_s:.2g} s"
    single = {"parameters": {"load_60_s_mm_per_10_n": parameter(0.2, "mm/10N")}}
    assert half_done_s(single) == pytest.approx((41.6, 41.6), rel=1e-3)
    diagnosis = content(verdict="explained", alternatives=[], next_run=None)
    text = " ".join(told(diagnosis).split())
    assert "those that were tried, with a steady load half of it done after 17 s, and shortens" in text


def test_half_of_what_follows_load_and_twist_is_done_between_the_times_of_both_whatever_the_twist():
    early_s, late_s = half_done_s({"parameters": CREEP})
    time_s = np.linspace(0.0, 300.0, 300_001)
    branches = {"load": [(60.0, 0.016)], "twist": [(4.0, 0.44), (60.0, 0.21), (240.0, 0.01)]}
    done = {
        name: sum(a * -np.expm1(-time_s / tau) for tau, a in parts) / sum(a for _, a in parts)
        for name, parts in branches.items()
    }
    for share in (0.01, 0.5, 0.99):
        half_s = float(np.interp(0.5, share * done["load"] + (1.0 - share) * done["twist"], time_s))
        assert early_s <= half_s <= late_s
    assert half_done({"parameters": CREEP}) == "half of it done after 5 s to 42 s"
    against = CREEP | {"twist_60_s_mm_per_10_n": parameter(-0.2, "mm/10N")}
    assert half_done({"parameters": against}) == "" and half_done({"parameters": {}}) == ""
