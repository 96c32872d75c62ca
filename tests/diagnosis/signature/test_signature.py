"""Each number of a signature answers to what it is of, and to nothing as simple beside it."""

import numpy as np
import pytest

from pipeline.diagnosis.signature.mismatch import seen
from pipeline.diagnosis.signature.signature import MOST, signature

STEP_S, STROKES = 0.05, 8
NOISE_MM = 0.01


def rig() -> dict[str, np.ndarray]:
    """Eight strokes of 20 turns with rests at both ends, half of them under a load of 5 N and half under 15 N."""
    up, down = np.linspace(0.0, 20.0, 200), np.linspace(20.0, 0.0, 200)
    stroke = np.concatenate([np.zeros(60), up, np.full(60, 20.0), down])
    motion = np.tile(stroke, STROKES)
    time_s = STEP_S * np.arange(len(motion))
    number = np.repeat(np.arange(1, STROKES + 1), len(stroke))
    load_n = np.where(number % 4 < 2, 5.0, 15.0)
    return {"motion": motion, "time_s": time_s, "stroke": number, "load": load_n, "rate": np.gradient(motion, time_s)}


def signed(effect_mm: np.ndarray, **changes) -> dict[str, float]:
    """The signature of an effect with a little noise."""
    parts = rig() | changes
    noise = np.random.default_rng(0).normal(0.0, NOISE_MM, len(effect_mm))
    return signature(seen(effect_mm + noise, **parts))


RIG = rig()
WAY = np.sign(RIG["rate"]) * (np.abs(RIG["rate"]) > 1.0)
PLACE = RIG["motion"] / 20.0
COURSE = RIG["time_s"] / RIG["time_s"][-1]
RESTED_S = np.concatenate(
    [np.minimum(STEP_S * np.arange(260), 3.0), np.minimum(STEP_S * np.arange(260), 3.0)] * STROKES
)


def test_what_differs_between_both_ways_is_a_loop_that_a_reversal_begins() -> None:
    loop = signed(0.5 * WAY * (PLACE > 0.0))
    assert loop["loop"] > 1.5 and abs(loop["loop_grows"]) < 0.2
    assert loop["after_top_0.03"] < -1.0 and abs(loop["time_all"]) < 0.1
    assert signed(0.5 * WAY * PLACE)["loop_grows"] > 0.5


def test_what_follows_the_place_is_in_the_profile_and_is_no_loop() -> None:
    bent = signed(np.maximum(PLACE - 0.8, 0.0))
    assert bent["middle_9"] > 1.5 > bent["middle_5"] and bent["loop_size"] < 0.3 and bent["remainder_size"] < 0.5


def test_what_comes_with_time_at_once_or_steadily() -> None:
    steady, late = signed(COURSE), signed(np.where(RIG["stroke"] > 4, 1.0, 0.0))
    assert steady["time_low"] > 0.9 and steady["trend_bottom"] > 2.0 and steady["sudden_bottom"] < 0.3
    assert late["step_bottom"] > 1.5 and late["sudden_bottom"] > 0.8


def test_what_goes_on_while_the_rig_rests() -> None:
    resting = signed(np.where(WAY == 0, RESTED_S, 0.0) * (PLACE > 0.5))
    assert resting["rest_top"] > 0.8 and abs(resting["rest_bottom"]) < 0.2


def test_what_follows_the_load() -> None:
    loaded = signed(0.1 * RIG["load"])
    assert min(loaded["load_low"], loaded["load_middle"], loaded["load_top"]) > 0.8
    assert abs(signed(PLACE)["load_middle"]) < 0.1
    heavy = signed(WAY * RIG["load"] / 15.0)
    assert heavy["loop_heavy"] > 0.3 and heavy["loop_light"] < -0.3


def test_what_comes_once_a_turn_and_what_is_rough() -> None:
    ripple = signed(np.sin(2 * np.pi * RIG["motion"]))
    assert ripple["ripple_1"] > 0.8 > 0.3 > ripple["ripple_2"]
    rough = signed(np.random.default_rng(1).choice([-1.0, 1.0], len(WAY)) * (WAY > 0))
    assert rough["rough_winding"] > 0.3 and rough["rough_resting"] < -0.3


def test_only_the_form_of_a_mismatch_counts_and_not_its_size_or_its_zero() -> None:
    effect, noise = WAY * PLACE, np.random.default_rng(0).normal(0.0, NOISE_MM, len(WAY))
    small, large = (signature(seen(size * (effect + noise) + zero, **RIG)) for size, zero in ((1.0, 0.0), (40.0, 7.0)))
    assert large == pytest.approx(small, abs=1e-9)


@pytest.mark.parametrize(
    "changes",
    [
        {"load": np.zeros(len(WAY))},
        {"stroke": np.zeros(len(WAY), int)},
        {"motion": np.zeros(len(WAY)), "rate": np.zeros(len(WAY))},
        {"rate": np.full(len(WAY), 1.0)},
    ],
    ids=["no load", "no stroke", "no motion", "no rest"],
)
def test_a_poor_recording_has_a_signature_of_finite_numbers(changes) -> None:
    for effect in (np.zeros(len(WAY)), WAY * PLACE):
        values = signed(effect, **changes)
        assert set(values) == set(signed(WAY * PLACE)) and all(abs(value) <= MOST for value in values.values())
