"""A concealed case is of the size that it says, pure, and as rich or as poor as its protocol."""

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from first_few import first_few
from imported import imported
from scipy.optimize import lsq_linear

import pipeline.proof
from pipeline.ground.kinematics import Geometry
from pipeline.proof import case as drawing
from pipeline.proof.bench import draw_bench, mismeasure
from pipeline.proof.case import ALWAYS, ALWAYS_KAPPA, Case, answer, draw_case, heldout_noise_mm, performed
from pipeline.proof.copies import copies, left_over
from pipeline.proof.draws import NAMED, OPEN_SET, draw_effect
from pipeline.proof.location import location
from pipeline.proof.perform import perform
from pipeline.proof.protocol import draw_protocol
from pipeline.proof.referee import rule
from pipeline.proof.size import OutOfReach, measure
from pipeline.rig import altered_motion, effects
from pipeline.rig.concealed import Claim
from pipeline.run.strokes import label

DRAWN = {  # one number of each at a strength of 1.5, and the draw after it
    "axial_elasticity": ("late_s", 5.20139240536, 0.635410929793),
    "backlash": ("firmness", 3.91378359362, 0.205191590552),
    "clamp_slip": ("lives_s", [234.930847812, 342.686131404], 0.800089717371),
    "count_slip": ("lives_s", [87.136454616, 110.752852668, 154.466880529], 0.294764464711),
    "creep": ("yield_mm", 0.224773503608, 0.661204302466),
    "eccentricity": ("joint", 0.108701831615, 0.635410929793),
    "end_stop": ("bumper", 319.313505964, 0.205191590552),
    "friction_hysteresis": ("tail", 1.32708400572, 0.635410929793),
    "jam": ("spread_turns", 3.38658745437, 0.205191590552),
    "load_swing": ("damping", 0.0277514107759, 0.635410929793),
    "overtwist": ("memory_turns", 3.05730117495, 0.205191590552),
    "plastic_elongation": ("work_n_mm", [101.67308664, 388.690127731, 923.464730045], 0.764856240894),
    "radius_compaction": ("exponent", 1.80109959001, 0.205191590552),
    "sensor_drift": ("mm_per_hour", 1.5, 0.935251751807),
    "sensor_lag": ("lag_s", 0.09, 0.205191590552),
    "shaft_windup": ("hardening", 0.320381661319, 0.205191590552),
    "slack": ("bed_mm", 0.158442768098, 0.205191590552),
    "stick_slip": ("age_s", 0.586728027479, 0.635410929793),
    "stiffening": ("order", 2.03318412304, 0.635410929793),
    "thermal": ("string_s", 13.2620024628, 0.783855007146),
    "viscous_loss": ("settle_s", 0.0255640711352, 0.205191590552),
    "wear": ("first_m", 0.0586056594254, 0.935251751807),
    "x_ballooning": ("settle_s", 0.198729126742, 0.635410929793),
    "x_encoder_interpolation": ("phase_rad", 4.2865769316, 0.635410929793),
    "x_floor_sway": ("frequency_hz", 0.587262757242, 0.635410929793),
    "x_humidity": ("period_s", 89.8100880679, 0.635410929793),
    "x_magnetic_scale": ("pole_mm", 2.35751530328, 0.635410929793),
    "x_string_tangling": ("seed", 955764981, 0.635410929793),
}


@cache
def case_of(effect: str, protocol: str = "rich", kappa: float = 1.0) -> Case:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(drawing, "_always", always_once)
        return draw_case(1, "open" if effect in OPEN_SET else "single", protocol, [effect], [kappa])


DRAWN_ALWAYS, drawn_always = {}, drawing._always


def always_once(bench, protocol, floor_mm, but, rng):
    """What every string has besides: of one seed it is the same for nearly all effects, and takes longest to draw."""
    key = (repr((bench, protocol, floor_mm, rng.bit_generator.state)), *(name for name in ALWAYS if name in but))
    if key not in DRAWN_ALWAYS:
        DRAWN_ALWAYS[key] = drawn_always(bench, protocol, floor_mm, but, rng)
    return DRAWN_ALWAYS[key]


def left_mm(case: Case) -> np.ndarray:
    """What a fit of its own leaves of the noise-free recording: straight lines solved again and again, no prior.

    Dimensions that take each other's place let a step land elsewhere, by how a machine rounds: the best one counts.
    """
    trace, measured = perform(case.bench, case.protocol, case.effects), case.bench.measured

    def residual(moves):
        radius_mm = measured.radius_mm * (1 + 0.03 * moves[0])
        separator_mm, zone_mm = measured.separator_mm + 0.5 * moves[1], measured.torsion_zone_mm + moves[2]
        length_mm = measured.length_mm + 2 * moves[3]
        geometry = Geometry("separator", radius_mm, length_mm, measured.stiffness_n_per_mm, zone_mm, separator_mm)
        model = geometry.contraction_mm(trace.motor_turns, trace.load_n) * (1 + 0.01 * moves[4]) + moves[5]
        return trace.displacement_mm - model

    moves, limits, residuals = np.zeros(6), np.append(np.full(5, 3.0), 1e3), []
    for _ in range(6):
        slopes = np.stack(
            [(residual(moves + 1e-4 * unit_move) - residual(moves)) / 1e-4 for unit_move in np.eye(6)], axis=1
        )
        bounds = (-limits - moves, limits - moves)
        moves = moves + lsq_linear(slopes[::4], -residual(moves)[::4], bounds, method="bvls").x
        residuals.append(residual(moves))
    return min(residuals, key=lambda each: float(np.square(each).sum()))


def test_every_effect_of_the_rig_can_be_concealed_and_has_a_claim():
    assert {*NAMED, *OPEN_SET} == set(effects.names())
    for name in effects.names():
        claim = effects.concealed(name).claim
        names = [way.name for way in (claim.frozen, *claim.indifferent)]
        assert all(names) and len(set(names)) == len(names) and claim.driver, name


def test_what_a_seed_draws_of_an_effect_is_what_it_always_drew():
    """Published cases came of it: an effect's file that is added changes none of these numbers, nor does its order."""
    rng = np.random.default_rng(3)
    bench = mismeasure(draw_bench(rng), rng, (0.0, 1.8))
    protocol = draw_protocol("rich", bench, rng)
    for name, (key, wanted, after) in DRAWN.items():
        rng = np.random.default_rng([3, 7])
        parameters = draw_effect(name, bench, protocol, rng)(1.5)
        assert parameters[key] == pytest.approx(wanted, rel=1e-9), name
        assert rng.random() == pytest.approx(after, rel=1e-9), name  # where the next draw begins


@pytest.mark.long
@pytest.mark.parametrize("effect", effects.names())
def test_at_kappa_one_calibration_leaves_one_noise_floor(effect):
    case = case_of(effect)
    assert case.sizes[effect].kappa == pytest.approx(1.0, abs=0.05)
    misfit_floors = np.sqrt(np.square(left_mm(case)).mean()) / case.nuisance.floor_mm
    assert misfit_floors == pytest.approx(case.sizes[effect].kappa, rel=0.06)


@pytest.mark.parametrize("effect", first_few(effects.names(), 7))
def test_the_declared_driver_carries_the_effect(effect):
    case = case_of(effect)
    ruling = rule(effect, case.effects[effect], case.bench, case.protocol)
    assert ruling.carried >= 0.9 and max(ruling.changed.values(), default=0.0) <= 0.1, ruling


def test_an_effect_may_bring_the_motion_in_which_its_driver_stands_still(monkeypatch):
    """A ripple stands still wherever the angle within a turn does, a quarter of a turn on too: no other file knows."""
    case = case_of("eccentricity")
    quarter = altered_motion.turns("by turns and a quarter", lambda motor_turns: np.rint(motor_turns) + 0.25)
    other = altered_motion.turns("a tenth of a turn on", lambda motor_turns: motor_turns + 0.1)
    hidden = type(effects.concealed("eccentricity"))
    monkeypatch.setattr(hidden, "claim", Claim("the angle within a turn", quarter, (other,)))
    ruling = rule("eccentricity", case.effects["eccentricity"], case.bench, case.protocol)
    assert ruling.carried >= 0.9 and ruling.told()["bystanders_change"]["a tenth of a turn on"] > 0.1


def test_what_the_first_winding_does_is_no_growth(monkeypatch):
    case, hidden = case_of("plastic_elongation"), effects.concealed("plastic_elongation")
    ruled = rule("plastic_elongation", case.effects["plastic_elongation"], case.bench, case.protocol)
    from_the_start = replace(hidden.claim.frozen, after_one_winding=False)
    monkeypatch.setattr(type(hidden), "claim", replace(hidden.claim, frozen=from_the_start))
    counted = rule("plastic_elongation", case.effects["plastic_elongation"], case.bench, case.protocol)
    assert ruled.carried > 0.9 > counted.carried


def test_an_effect_under_a_false_name_is_found_out(monkeypatch):
    """Play whose contact takes time is a lag: that is what the referee is for."""
    case = case_of("sensor_lag")
    monkeypatch.setattr(type(effects.concealed("sensor_lag")), "claim", effects.concealed("backlash").claim)
    assert not rule("sensor_lag", case.effects["sensor_lag"], case.bench, case.protocol).pure


def test_load_alone_shows_nothing_under_one_load():
    with pytest.raises(OutOfReach, match="axial_elasticity"):
        case_of("axial_elasticity", "poor")


def test_a_bench_is_measured_within_its_tolerance():
    for seed in range(40):
        rng = np.random.default_rng(seed)
        bench = draw_bench(rng)
        assert 8 <= bench.top_turns <= 80 and bench.stroke_mm > 5
        errors = mismeasure(bench, rng, (1.0, 3.0)).errors()
        assert all(0.6 <= abs(error) <= 3.5 for error in errors.values()), errors  # sigma of the other's radius


@pytest.mark.parametrize("seed", range(4))
def test_the_rich_protocol_is_rich_and_the_poor_one_poor(seed):
    rng = np.random.default_rng(seed)
    bench = draw_bench(rng)
    for kind in ("rich", "poor"):
        protocol = draw_protocol(kind, bench, rng)
        strokes = protocol.motion.each()
        assert 10 <= len(strokes) <= 15 and 25 <= protocol.rate_hz <= 50
        motion = protocol.told
        assert 6_000 <= motion.time_s[-1] * protocol.rate_hz <= 16_000
        assert len({stroke.load_n for stroke in strokes}) == (3 if kind == "rich" else 1)
        assert len({round(stroke.speed_turns_per_s, 6) for stroke in strokes}) == (3 if kind == "rich" else 1)
        assert max(stroke.hold_s for stroke in strokes) == (15 if kind == "rich" else 0)
        stroke, phase = protocol.phases
        number, name = label(motion.time_s[::8], motion.motor_turns[::8])
        assert number.max() == len(strokes) == stroke.max()
        assert (number == stroke).mean() > 0.97 and (name == phase).mean() > 0.93


def test_the_floor_is_the_floor():
    case = draw_case(5, "none", "rich")
    table = performed(case).table
    extras = perform(case.bench, case.protocol, case.always)
    clean = np.interp(table["time_s"], extras.time_s, extras.displacement_mm)
    noise = table["displacement_mm"] - clean
    assert 1.4826 * np.median(np.abs(noise)) == pytest.approx(case.nuisance.floor_mm, rel=0.1)
    assert (np.abs(noise) > 7 * case.nuisance.floor_mm).mean() == pytest.approx(0.001, abs=0.0008)
    assert not table.isna().any().any() and (np.diff(table["time_s"]) > 0).all()


@pytest.mark.parametrize("stratum", ["none", "parameters", "noise"])
def test_controls_hide_nothing_that_a_calibration_does_not_take_up(stratum):
    for seed in (1, 2):
        sealed = answer(draw_case(seed, stratum, "rich"), "case")
        assert sealed["effects"] == [] and sealed["location"] is None
        assert sealed["together"]["kappa"] < 0.05 and sealed["always"]["kappa"] < ALWAYS_KAPPA


@pytest.mark.parametrize(
    ("seed", "stratum", "protocol", "effect"),
    first_few(
        [
            (1028, "single", "rich", "wear"),
            (1029, "single", "rich", "friction_hysteresis"),
            (1032, "single", "rich", "backlash"),
            (4, "single", "poor", "creep"),
            (5, "pair", "rich", "creep"),
            (6, "pair", "poor", "creep"),
        ],
        2,
    ),
)
def test_what_every_string_has_stays_small_however_wrongly_the_bench_is_measured(seed, stratum, protocol, effect):
    sealed = answer(draw_case(seed, stratum, protocol, [effect], [3.0]), "case")
    assert 0.0 < sealed["always"]["kappa"] < ALWAYS_KAPPA


def test_a_pair_is_two_effects_of_their_own_sizes():
    case = draw_case(3, "pair", "rich", ["creep", "backlash"], [1.0, 0.5])
    assert [round(case.sizes[name].kappa, 1) for name in ("creep", "backlash")] == [1.0, 0.5]
    assert measure(case.bench, case.protocol, case.effects, case.nuisance.floor_mm)[0].kappa > 0.8


def test_what_the_truth_leaves_of_the_held_out_strokes_is_the_noise():
    case = draw_case(5, "none", "rich")
    assert heldout_noise_mm(performed(case)) == pytest.approx(case.nuisance.floor_mm, rel=0.1)


def test_the_box_is_the_smallest_that_holds_the_energy():
    case = case_of("end_stop")
    trace = perform(case.bench, case.protocol, {})
    has_energy = (trace.stroke >= 3) & (trace.stroke <= 4) & (trace.phase == "winding") & (trace.motor_turns > 0.5 * 24)
    box = location(trace, np.where(has_energy, 1.0, 0.0))
    assert box["phase"] == "winding" and box["strokes"] == [3, 4]
    inside = (trace.phase == "winding") & (trace.stroke >= 3) & (trace.stroke <= 4)
    inside &= (trace.motor_turns >= box["motor_turns"][0]) & (trace.motor_turns <= box["motor_turns"][1])
    assert (inside & has_energy).sum() / has_energy.sum() >= 0.8


def test_the_same_seed_makes_the_same_case():
    first_table, two = (performed(draw_case(7, "single", "poor", ["creep"], [3.0])).table for _ in range(2))
    assert first_table.equals(two)


def test_the_generator_and_the_score_know_nothing_of_what_must_explain_it():
    allowed = ("pipeline.proof", "pipeline.rig", "pipeline.ground", "pipeline.run")
    compare = ("pipeline.proof.baselines", "pipeline.proof.twins", "pipeline.proof.teach")  # it is their purpose
    folder = Path(pipeline.proof.__file__).parent
    for path in folder.rglob("*.py"):
        if path.relative_to(folder).parts[0] in ("baselines", "twins.py", "teach"):
            continue
        for name in imported(path) - {"pipeline.ground"}:
            assert not name.startswith("pipeline") or name.startswith(allowed), (path, name)
            assert not name.startswith(compare), (path, name)


@pytest.mark.long
def test_friction_and_backlash_look_alike_under_one_load_and_not_under_three():
    for protocol, low, high in (("poor", 0.0, 0.15), ("rich", 0.2, 1.0)):
        case = case_of("backlash", protocol)
        leftover = left_over(case, copies(case, ["backlash", "friction_hysteresis", "creep"], shapes=3))
        assert leftover["backlash"] < 0.1 and leftover["creep"] > 0.8
        assert low <= leftover["friction_hysteresis"] <= high, (protocol, leftover)
