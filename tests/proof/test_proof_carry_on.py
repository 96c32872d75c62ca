"""An experiment that is carried out goes on with the same string, from where its recording ended."""

import json
from dataclasses import replace

import numpy as np
import pytest

from pipeline.proof.carry_on import Continued, Leg, described, gone_on, proposed, same_again
from pipeline.proof.case import draw_case
from pipeline.proof.perform import perform
from pipeline.run.description import parse_run

LEGS = (Leg(10.0, 12.0, 20.0), Leg(60.0, 12.0, 20.0), Leg(10.0, 0.0, 20.0))


@pytest.fixture(scope="module")
def case():
    return draw_case(7, "single", "poor", ["creep"], [3.0])


def test_the_first_part_stays_and_the_state_is_carried_on(case):
    longer = Continued(case.protocol.kind, case.protocol.motion, case.protocol.rate_hz, LEGS)
    first, whole = perform(case.bench, case.protocol, case.effects), perform(case.bench, longer, case.effects)
    count = len(first.time_s)
    np.testing.assert_allclose(whole.displacement_mm[:count], first.displacement_mm, atol=1e-12)
    assert whole.time_s[-1] - first.time_s[-1] == pytest.approx(80.0, abs=0.1)
    in_hold = (whole.time_s > first.time_s[-1] + 11) & (whole.time_s < first.time_s[-1] + 69)
    assert np.ptp(whole.motor_turns[in_hold]) < 1e-9 and np.ptp(whole.load_n[in_hold]) < 1e-9
    assert np.ptp(whole.displacement_mm[in_hold]) > 0.1 * case.nuisance.floor_mm  # it creeps, as it did


def test_the_second_recording_is_the_legs_with_fresh_noise(case):
    resumed, two = gone_on(case, LEGS, 3), gone_on(case, LEGS, 4)
    assert resumed.table["time_s"].iloc[0] > case.protocol.told.time_s[-1]
    assert resumed.table["time_s"].diff().iloc[1:].min() > 0 and not resumed.table.isna().any().any()
    assert resumed.table["motor_turns"].max() == pytest.approx(12.0, abs=0.01)
    assert np.std(resumed.error_mm[~resumed.wild]) == pytest.approx(case.nuisance.floor_mm, rel=0.2)
    assert not np.array_equal(resumed.error_mm[:1000], two.error_mm[:1000])


def test_it_is_of_the_same_string_and_counts_its_strokes_on(case, tmp_path):
    content = described(case, LEGS, "case-7")
    assert content["run"] == "case-7-more" and content["string"]["id"] == "case-7"
    assert content["string"]["strokes_before"] == len(case.protocol.motion.each())
    (tmp_path / "case-7-more").mkdir()
    parse_run(content, tmp_path / "case-7-more" / "run.yaml")


def test_who_changes_the_weight_says_which_one_hangs(case):
    bare, load_n = replace(case, load_cell=False), case.bench.loads_n[0]
    same, other = (Leg(10.0, 5.0, load_n),), (Leg(10.0, 5.0, 2.0 * load_n),)
    assert "load_n" not in gone_on(bare, same, 3).table and described(bare, same, "case-7")["rig"]["load_n"] == load_n
    table = gone_on(bare, other, 3).table
    assert table["load_n"].median() == pytest.approx(2.0 * load_n, rel=0.01)
    assert "load_n" not in described(bare, other, "case-7")["rig"]


def test_more_of_the_same_lasts_as_long(case):
    legs = same_again(case.protocol, 80.0)
    stroke_s = 2 * case.bench.top_turns / case.protocol.motion.each()[-1].speed_turns_per_s
    assert sum(leg.seconds for leg in legs) == pytest.approx(80.0, abs=0.5 * stroke_s + 1e-9)
    assert legs[0].motor_turns == case.bench.top_turns and legs[-1].motor_turns == 0.0


def test_only_a_tie_asks_for_more(tmp_path):
    path, legs = tmp_path / "diagnosis.json", [{"seconds": 5.0, "motor_turns": 3.0, "load_n": 20.0}]
    assert proposed(path) == ()
    path.write_text(json.dumps({"verdict": "explained", "next_run": {"legs": legs}}))
    assert proposed(path) == ()
    path.write_text(json.dumps({"verdict": "ambiguous", "next_run": {"legs": legs}}))
    assert proposed(path) == (Leg(5.0, 3.0, 20.0),)
