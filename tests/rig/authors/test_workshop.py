"""The author `workshop`: recordings that the pipeline takes, sizes that are kept, and laws that obey their physics."""

import json
from dataclasses import replace

import numpy as np
import pytest
import yaml

from pipeline.ground.kinematics import Geometry
from pipeline.rig.authors.interface import Asked, OutOfReach
from pipeline.rig.authors.workshop import LAWS, make
from pipeline.rig.authors.workshop.bench import Bench
from pipeline.rig.authors.workshop.catalogue import part_of
from pipeline.rig.authors.workshop.chain import reading
from pipeline.rig.authors.workshop.curves import drawn_curve, wander
from pipeline.rig.authors.workshop.instruments import drawn_instruments
from pipeline.rig.authors.workshop.sizing import kappa_of, left_over, sized
from pipeline.rig.authors.workshop.specimen import drawn_specimen
from pipeline.run.samples import read_samples

TICK_S = 0.05
EVERY = [(effect, law) for effect, laws in LAWS.items() for law in laws]


def course(*legs):
    """A bench over legs of (seconds, turns at the end, load): even speed, standing where the turns stay."""
    time_s = np.arange(0.0, sum(leg[0] for leg in legs), TICK_S)
    ends = np.cumsum([0.0, *(leg[0] for leg in legs)])
    turns = np.interp(time_s, ends, [0.0, *(leg[1] for leg in legs)])
    at = np.minimum(np.searchsorted(ends[1:], time_s, side="right"), len(legs) - 1)
    load_n = np.array([leg[2] for leg in legs])[at]
    winding = np.diff(turns, prepend=0.0) > 0.0
    stroke = np.maximum(1, np.cumsum(np.diff(winding.astype(int), prepend=0) > 0))
    warmth = 20.0 + 5.0 * np.sin(time_s / 30.0)
    return Bench(time_s, turns, load_n, warmth, stroke, Geometry("separator", 0.45, 320.0, 14.0, 150.0, 8.0), True)


def saw(load_n=10.0, leg_s=10.0, count=6):
    return course(*[(leg_s, 20.0 * (leg % 2 == 0), load_n) for leg in range(2 * count)], (10.0, 0.0, load_n))


def effect_mm(bench, effect, law, size=None, seed=3):
    part = part_of(bench, effect, law, np.random.default_rng(seed), share=0.0)
    return reading(bench, [(part, 0.1 * part.limit if size is None else size)]) - reading(bench, [])


def ways(bench):
    """Masks of winding and unwinding in the later strokes, amid the range."""
    late = (bench.time_s > 25.0) & (np.abs(bench.height - 0.5) < 0.2)
    return late & (bench.speed > 0.1), late & (bench.speed < -0.1)


def loop_turns(bench, effect, law):
    """Half the loop's width on the twist, from the gap between the ways, per turn of slope."""
    error = effect_mm(bench, effect, law, 0.2) / bench.geometry.slope_mm_per_turn(bench.turns, bench.load_n)
    up, down = ways(bench)
    return (error[down].mean() - error[up].mean()) / 2.0


@pytest.fixture(scope="module")
def rich():
    """A rich specimen with a thermometer, on a clock thinned to be quick."""
    seed = next(seed for seed in range(100) if drawn_specimen(seed, "rich").bench.thermometer)
    specimen = drawn_specimen(seed, "rich")
    bench = specimen.bench
    every = len(bench.time_s) // 6500
    thin = {name: getattr(bench, name)[::every] for name in ("time_s", "turns", "load_n", "temperature_c", "stroke")}
    return replace(bench, **thin), drawn_instruments(seed, specimen).floor_mm


@pytest.mark.long
@pytest.mark.parametrize("effect", LAWS)
def test_every_law_reaches_its_size_and_differs_from_the_others_of_its_effect(rich, effect):
    bench, floor_mm = rich
    shapes = []
    for law in LAWS[effect]:
        part = part_of(bench, effect, law, np.random.default_rng(4))
        size = sized(bench, part, 3.0, floor_mm)
        assert 0.0 < size <= part.limit
        assert kappa_of(bench, part, size, floor_mm) == pytest.approx(3.0, rel=0.1), law
        if effect == "sensor_lag":  # a lag of a tick or two looks like every other
            size = 0.4
        shown = reading(bench, [(part, size)])
        again = part_of(bench, effect, law, np.random.default_rng(4))
        assert np.isfinite(shown).all() and np.array_equal(shown, reading(bench, [(again, size)]))
        rest = left_over(bench.turns, bench.load_n, bench.geometry, shown)
        shapes.append(rest / np.linalg.norm(rest))
    for number, shape in enumerate(shapes):
        for other in shapes[:number]:
            assert abs(shape @ other) < 0.99999


@pytest.mark.parametrize(
    ("seed", "protocol", "effects"),
    [
        (11, "rich", ("creep", "backlash")),
        (12, "usual", ("friction_hysteresis",)),
        (13, "poor", ("count_slip", "sensor_lag")),
        (14, "usual", ("x_leaning_operator",)),
    ],
)
def test_a_recording_is_taken_in_is_reproducible_and_tells_nothing(tmp_path, seed, protocol, effects):
    request = Asked(seed, effects, (4.0,) * len(effects), protocol)
    recording = make(request)
    folder = tmp_path / "case-7"
    folder.mkdir()
    text = yaml.safe_dump({"run": "case-7", **recording.content}, sort_keys=False)
    (folder / "run.yaml").write_text(text)
    recording.table.to_parquet(folder / "recording.parquet", index=False)
    _, samples = read_samples(folder)
    assert len(samples) <= 25000 and 180.0 <= np.ptp(samples["time_s"]) <= 600.0
    hidden = recording.truth["effects"]
    assert [effect["id"] for effect in hidden] == list(effects)
    assert all(
        effect["kappa"] == pytest.approx(4.0, rel=0.1) and effect["law"] in LAWS[effect["id"]] for effect in hidden
    )
    assert all(isinstance(value, float) for effect in hidden for value in effect["parameters"].values())
    json.dumps(recording.truth, allow_nan=False)
    assert make(request).table.equals(recording.table)
    control = make(Asked(seed, (), (), protocol))
    assert control.content == recording.content and list(control.table) == list(recording.table)


@pytest.mark.parametrize("protocol", ["rich", "usual", "poor"])
def test_without_effects_calibration_leaves_the_noise(protocol):
    recording = make(Asked(21, (), (), protocol))
    specimen = drawn_specimen(21, protocol)
    table, string, rig = recording.table, recording.content["string"], recording.content["rig"]
    load_n = table["load_n"].to_numpy() if "load_n" in table else np.full(len(table), rig["load_n"])
    nominal = Geometry(
        recording.content["actuator"],
        string["radius_mm"],
        string["length_mm"],
        specimen.bench.geometry.stiffness_n_per_mm,
        rig.get("torsion_zone_mm", np.nan),
        rig.get("separator_mm", np.nan),
    )
    rest = left_over(table["motor_turns"].to_numpy(), load_n, nominal, table["displacement_mm"].to_numpy())
    middle = np.median(np.abs(rest - np.median(rest))) / 0.6745  # outliers do not count
    assert middle == pytest.approx(recording.truth["noise_floor_mm"], rel=0.15)
    assert recording.truth["effects"] == [] and recording.truth["heldout_noise_mm"] > 0.0


@pytest.mark.parametrize(("protocol", "loads"), [("rich", 3), ("usual", 2), ("poor", 1)])
def test_a_protocol_is_what_it_says(protocol, loads):
    for seed in range(12):
        bench = drawn_specimen(seed, protocol).bench
        still = float(np.mean(np.abs(bench.speed) < 1e-6))
        assert 180.0 <= bench.time_s[-1] <= 600.0 and len(bench.time_s) <= 25000
        assert 24.0 <= 1.0 / bench.tick_s <= 100.0 + 1e-6 and np.abs(bench.speed).max() < 9.0
        assert (
            {"rich": 9, "usual": 9, "poor": 6}[protocol]
            <= bench.stroke.max()
            <= {"poor": 10, "usual": 12}.get(protocol, 16)
        )
        assert still < 0.01 if protocol == "poor" else still > 0.05
        if protocol != "usual" and np.ptp(bench.load_n[bench.stroke == 1]) < 1e-9:
            resting = bench.load_n[(bench.height < 1e-9)]
            assert len(np.unique(np.round(resting, 4))) >= loads


def test_what_the_protocol_cannot_show_is_out_of_reach():
    alone = next(seed for seed in range(50) if np.ptp(drawn_specimen(seed, "poor").bench.load_n) == 0.0)
    for effect, kappa in (("axial_elasticity", 3.0), ("creep", 1e9)):
        with pytest.raises(OutOfReach):
            make(Asked(alone, (effect,), (kappa,), "poor"))


@pytest.mark.parametrize("law", LAWS["backlash"])
def test_play_is_as_wide_under_every_load_and_at_every_speed(law):
    width = loop_turns(saw(), "backlash", law)
    assert width == pytest.approx(0.2, rel=0.1)
    assert loop_turns(saw(load_n=30.0), "backlash", law) == pytest.approx(width, rel=0.01)
    assert loop_turns(saw(leg_s=5.0), "backlash", law) == pytest.approx(width, rel=0.05)


@pytest.mark.parametrize("law", LAWS["friction_hysteresis"])
def test_frictions_loop_lags_grows_with_the_load_and_hardly_knows_the_speed(law):
    legs = [(10.0, 20.0 * (leg % 2 == 0), 10.0 if leg < 6 else 20.0) for leg in range(12)]
    error, bench = effect_mm(course(*legs), "friction_hysteresis", law, 0.1), course(*legs)
    up, down = ways(bench)
    light, heavy = bench.time_s < 60.0, bench.time_s >= 60.0
    gaps = [error[down & half].mean() - error[up & half].mean() for half in (light, heavy)]
    assert gaps[0] > 0.0 and 1.2 < gaps[1] / gaps[0] < 2.6
    slow, quick = (loop_turns(saw(leg_s=leg_s), "friction_hysteresis", law) for leg_s in (10.0, 5.0))
    assert quick == pytest.approx(slow, rel=0.15)
    hold_mm = effect_mm(course((10.0, 15.0, 10.0), (20.0, 15.0, 10.0)), "friction_hysteresis", law, 0.1)
    assert np.ptp(hold_mm[-300:]) < 0.01


@pytest.mark.parametrize(("effect", "law"), [pair for pair in EVERY if pair[0] in ("sensor_lag", "viscous_loss")])
def test_what_follows_the_rate_vanishes_at_standstill(effect, law):
    bench = course((8.0, 15.0, 10.0), (40.0, 15.0, 10.0), (8.0, 0.0, 10.0), (20.0, 0.0, 10.0))
    error = effect_mm(bench, effect, law)
    up, down = (bench.time_s > 5) & (bench.time_s < 7.9), (bench.time_s > 50) & (bench.time_s < 55.9)
    assert error[up].mean() < -0.05 and error[down].mean() > 0.05
    assert np.abs(error[(bench.time_s > 25.0) & (bench.time_s < 47.0)]).max() < 1e-3


@pytest.mark.parametrize("law", LAWS["creep"])
def test_creep_goes_on_under_load_and_comes_back_when_unloaded(law):
    bench = course((1.0, 0.0, 2.0), (200.0, 0.0, 30.0), (600.0, 0.0, 2.0))
    error = effect_mm(bench, "creep", law, 1.0)
    loaded, end = error[bench.time_s < 200.9], error[-1]
    assert loaded[-1] < loaded[200] < 0.0
    assert abs(end) < 0.75 * abs(loaded[-1])


@pytest.mark.parametrize("law", LAWS["plastic_elongation"])
def test_plastic_elongation_never_comes_back_nor_grows_at_rest(law):
    legs = [(5.0, 20.0 * (leg % 2 == 0), 10.0) for leg in range(10)]
    bench = course(*legs, (60.0, 0.0, 10.0))
    error = effect_mm(bench, "plastic_elongation", law, 1.0)
    assert (np.diff(error) < 1e-9).all() and error[-1] < -0.2
    assert np.ptp(error[bench.time_s > 51.0]) < 1e-6


@pytest.mark.parametrize("law", LAWS["wear"])
def test_wear_needs_travel_and_spares_the_untwisted_string(law):
    bench = course(*[(5.0, 20.0 * (leg % 2 == 0), 10.0) for leg in range(10)], (30.0, 0.0, 10.0), (5.0, 20.0, 10.0))
    error = effect_mm(bench, "wear", law, 0.05)
    assert np.abs(error[bench.height < 1e-9]).max() < 0.02 * np.abs(error).max()
    tops = np.abs(error[(bench.height > 0.99)])
    assert tops[-1] > tops[0]


@pytest.mark.parametrize("law", LAWS["axial_elasticity"])
def test_stretch_follows_the_load_and_nothing_else(law):
    bench = course((5.0, 15.0, 10.0), (5.0, 0.0, 10.0), (5.0, 15.0, 30.0), (5.0, 0.0, 30.0), (5.0, 15.0, 10.0))
    error = effect_mm(bench, "axial_elasticity", law, 1.0)
    assert np.ptp(error[bench.load_n == 10.0]) < 1e-9 and np.ptp(error[bench.load_n == 30.0]) < 1e-9
    assert error[bench.load_n == 30.0].mean() < -0.1


@pytest.mark.parametrize("law", LAWS["shaft_windup"])
def test_windup_follows_the_torque_without_a_loop(law):
    bench = course((10.0, 20.0, 10.0), (10.0, 0.0, 10.0), (10.0, 20.0, 20.0), (10.0, 0.0, 20.0))
    error = effect_mm(bench, "shaft_windup", law, 0.5)
    up, down = error[100:150], error[250:300][::-1]
    assert up.mean() == pytest.approx(down.mean(), rel=0.03)
    assert error[500:550].mean() < 1.1 * up.mean() < 0.0


@pytest.mark.parametrize("law", [*LAWS["jam"], *LAWS["overtwist"]])
def test_past_a_critical_twist_jam_falls_behind_and_overtwist_runs_ahead_with_a_loop(law):
    effect, bench = ("jam" if law in LAWS["jam"] else "overtwist"), saw()
    error = effect_mm(bench, effect, law)
    assert np.abs(error[bench.height < 0.35]).max() < 1e-6
    top = error[bench.height > 0.97].mean()
    assert top < -0.01 if effect == "jam" else top > 0.01
    high = (bench.height > 0.6) & (bench.time_s < 110.0)
    loop = error[high & (bench.speed < -0.1)].mean() - error[high & (bench.speed > 0.1)].mean()
    assert abs(loop) < 0.03 * abs(top) if effect == "jam" else loop > 0.03 * top


@pytest.mark.parametrize(("effect", "law"), [pair for pair in EVERY if pair[0] in ("count_slip", "clamp_slip")])
def test_what_slips_stays_slipped(effect, law):
    bench = saw()
    error = effect_mm(bench, effect, law, 0.5)
    assert error[0] == 0.0 and error[-1] < -0.05
    if effect == "clamp_slip":
        assert (np.diff(error) < 1e-9).all() and error[-1] == pytest.approx(-0.5)


def test_a_curve_rises_between_its_ends_and_wandering_stays_small():
    rng = np.random.default_rng(1)
    curve = drawn_curve(rng, 3.0)
    values = curve(np.linspace(-0.5, 1.5, 200))
    assert values[0] == 0.0 and values[-1] == pytest.approx(1.0) and (np.diff(values) >= 0.0).all()
    assert curve(0.5) > 0.5
    assert np.std(wander(rng, np.arange(0.0, 400.0, 0.1), 0.02)) < 0.06
