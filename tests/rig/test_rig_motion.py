"""The rig does what its set-up says."""

import numpy as np
import pytest
import yaml

from pipeline.ground.errors import BadInput
from pipeline.rig.motion_commands import Motion, commands
from pipeline.rig.setup import SHIPPED, names, read_setup

MOTION = {
    "rest_s": 1,
    "strokes": [
        {"repeat": 2, "top_turns": 10, "speed_turns_per_s": 2, "hold_s": 1, "rest_s": 3, "load_n": 20},
        {"top_turns": 6, "bottom_turns": 1, "speed_turns_per_s": 1, "speed_up_s": 2, "slow_down_s": 1,
         "hold_s": 0, "rest_s": 2, "load_n": 30},
    ],
}  # fmt: skip


def test_strokes_wind_hold_unwind_and_rest_when_told():
    trajectory = commands(Motion.model_validate(MOTION), 0.01)
    np.testing.assert_allclose(trajectory.strokes_s[0], [1, 6, 7, 12])
    np.testing.assert_allclose(trajectory.strokes_s[2], [29, 36.5, 36.5, 43])
    assert trajectory.time_s[-1] == pytest.approx(45)
    at = {time_s: trajectory.motor_turns[round(time_s / 0.01)] for time_s in (0.5, 3.5, 6.5, 8, 14, 31, 36.5, 44)}
    assert at == pytest.approx({0.5: 0, 3.5: 5, 6.5: 10, 8: 8, 14: 0, 31: 1, 36.5: 6, 44: 1})
    assert {trajectory.load_n[round(time_s / 0.01)] for time_s in (0, 12, 26)} == {20}
    assert {trajectory.load_n[round(time_s / 0.01)] for time_s in (26.5, 44)} == {30}


def test_the_motor_keeps_to_its_speed_and_never_jumps():
    trajectory = commands(Motion.model_validate(MOTION), 0.01)
    speed = np.abs(np.diff(trajectory.motor_turns)) / 0.01
    assert speed.max() <= 2 + 1e-9
    assert speed[trajectory.time_s[1:] > 29].max() <= 1 + 1e-9


def test_a_motion_of_more_or_fewer_strokes_repeats_its_own_in_their_order():
    motion = Motion.model_validate(MOTION)
    assert [stroke.top_turns for stroke in motion.of_strokes(5).each()] == [10, 10, 6, 10, 10]
    assert len(motion.of_strokes(1).each()) == 1 and motion.of_strokes(3).each() == [
        stroke.model_copy(update={"repeat": 1}) for stroke in motion.each()
    ]


def test_a_way_too_short_for_its_ramps_is_still_made():
    stroke = {"top_turns": 1, "speed_turns_per_s": 2, "speed_up_s": 5, "slow_down_s": 5, "hold_s": 1, "rest_s": 1}
    trajectory = commands(Motion.model_validate({"rest_s": 0, "strokes": [stroke | {"load_n": 1}]}), 0.01)
    assert trajectory.motor_turns.max() == pytest.approx(1) and trajectory.motor_turns[-1] == pytest.approx(0)


@pytest.mark.parametrize("name", names())
def test_shipped_set_ups_are_sound(name):
    assert read_setup(name).effects


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"effects": {"magic": {}}}, "effects.magic: is not an effect"),
        ({"effects": {"creep": {"speed": 3}}}, "effects.creep: has other parameters"),
        ({"rate_hz": 0}, "rate_hz"),
        ({"colour": "red"}, "colour"),
        ({"run": {"actuator": "separator"}}, "string"),
        ({"sensors": {"displacement": {"quantum": 1}}}, "sensors.displacement"),
    ],
)
def test_a_set_up_that_cannot_be_is_refused_with_the_field(change, message, tmp_path):
    path = tmp_path / "mine.yaml"
    path.write_text(yaml.safe_dump(yaml.safe_load((SHIPPED / "small.yaml").read_text()) | change))
    with pytest.raises(BadInput, match=message):
        read_setup(str(path))


def test_a_set_up_that_is_not_there_is_refused():
    with pytest.raises(BadInput, match="small"):
        read_setup("nowhere.yaml")
