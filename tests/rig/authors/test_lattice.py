"""The author `lattice`: its recordings are whole, hide what was asked at the size asked, and nothing else."""

import json
from functools import cache
from itertools import combinations

import numpy as np
import pytest
import yaml
from scipy.optimize import least_squares

from pipeline.ground.kinematics import Geometry
from pipeline.rig.authors.interface import Asked, OutOfReach
from pipeline.rig.authors.lattice import LAWS, make
from pipeline.rig.authors.lattice.catalogue import ALL, BY_EFFECT
from pipeline.rig.authors.lattice.chain import reading_mm
from pipeline.rig.authors.lattice.instruments import sampling
from pipeline.rig.authors.lattice.recording import made_with
from pipeline.rig.authors.lattice.session import session
from pipeline.rig.authors.lattice.size import Ruler, strength_for
from pipeline.run.samples import read_samples

SEED = 3  # a short session without outliers
KAPPA = 4.0
TOLERANCE = np.array([0.03, 1.0, 0.5, 2.0, 0.005, 0.05])  # radius, torsion zone, separator, length, scale, angle zero


@cache
def bench():
    """The bench of that session."""
    return session(np.random.default_rng([SEED, 1]), "rich")


def left_mm(recording):
    """What a calibration within three sigmas leaves of a recording, written apart from the author's own."""
    string, rig, table = recording.content["string"], recording.content["rig"], recording.table
    load_n = table.get("load_n", rig.get("load_n"))
    turns, shown = table["motor_turns"].to_numpy(), table["displacement_mm"].to_numpy()

    def misfit(sigmas):
        radius, zone, separator, length, scale, zero = sigmas * TOLERANCE
        moved = Geometry(
            "separator", string["radius_mm"] * (1 + radius), string["length_mm"] + length, string["stiffness_n_per_mm"],
            rig["torsion_zone_mm"] + zone, rig["separator_mm"] + separator,
        )  # fmt: skip
        residual = shown - (1 + scale) * moved.contraction_mm(turns + zero, load_n)
        return np.asarray(residual - residual.mean())

    return misfit(least_squares(misfit, np.zeros(6), bounds=(-3, 3)).x)


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


# one law of each effect, and those that take long
EVERY = [
    pytest.param(law, id=f"{law.effect}-{law.name}", marks=() if law is BY_EFFECT[law.effect][0] else pytest.mark.long)
    for law in ALL
]


@pytest.mark.long
@pytest.mark.parametrize("law", EVERY)
def test_every_law_makes_a_recording_of_the_size_asked(law, tmp_path):
    request = Asked(SEED, (law.effect,), (KAPPA,), "rich")
    recording = made_with(request, [law.name])
    folder = tmp_path / "run"
    folder.mkdir()
    (folder / "run.yaml").write_text(yaml.safe_dump({"run": "run", **recording.content}, sort_keys=False))
    recording.table.to_parquet(folder / "recording.parquet", index=False)
    _, samples = read_samples(folder)
    assert np.isfinite(samples.to_numpy()).all() and len(samples) <= 25_000
    (effect,) = recording.truth["effects"]
    assert (effect["id"], effect["law"]) == (law.effect, law.name) and 0 < effect["rms_mm"] < 10
    floor_mm = recording.truth["noise_floor_mm"]
    assert np.sqrt(rms(left_mm(recording)) ** 2 - floor_mm**2) / floor_mm == pytest.approx(KAPPA, rel=0.1)
    assert effect["kappa"] == pytest.approx(KAPPA, rel=0.1)
    json.dumps(recording.truth, allow_nan=False)
    again = [reading_mm(bench().world, [(law, effect["parameters"])]) for _ in range(2)]
    assert np.array_equal(*again)


@pytest.mark.parametrize("protocol", ["rich", "usual", "poor"])
@pytest.mark.parametrize("seed", [SEED, *(pytest.param(seed, marks=pytest.mark.long) for seed in (7, 12))])
def test_without_effects_a_calibration_leaves_the_noise(seed, protocol):
    recording = make(Asked(seed, (), (), protocol))
    residual_mm, floor_mm = left_mm(recording), recording.truth["noise_floor_mm"]
    inside = np.abs(residual_mm) < 6 * floor_mm  # outliers are no part of the floor
    assert inside.mean() > 0.998
    assert rms(residual_mm[inside]) == pytest.approx(floor_mm, rel=0.03)
    assert recording.truth["heldout_noise_mm"] == pytest.approx(floor_mm, rel=0.15)
    loads = recording.table["load_n"].round(-1).nunique() if "load_n" in recording.table else 1
    assert loads >= 2 if protocol == "rich" else "load_n" in recording.table or recording.content["rig"]["load_n"] > 0
    seconds = recording.table["time_s"].iloc[-1]
    assert 170 < seconds < 620 and 24 < len(recording.table) / seconds < 101


@pytest.mark.long
@pytest.mark.parametrize("effect", [effect for effect in LAWS if len(LAWS[effect]) > 1])
def test_the_laws_of_one_effect_differ(effect):
    drawn_bench, ruler = bench(), Ruler(bench(), sampling(np.random.default_rng([SEED, 2]), bench()))
    seen = {}
    for law in BY_EFFECT[effect]:
        shape = law.draw(np.random.default_rng(4), drawn_bench.world)

        def leftover_mm(strength, law=law, shape=shape):
            return ruler.left_mm(reading_mm(drawn_bench.world, [(law, {**shape, law.strength: strength})]))

        strength = strength_for(
            0.06 if effect == "load_swing" else 0.3,
            lambda strength, leftover_mm=leftover_mm: rms(leftover_mm(strength)),
            law.limit,
        )
        seen[law.name] = leftover_mm(strength)
    for one_law, other in combinations(seen, 2):
        alike = float(np.dot(seen[one_law], seen[other]) / np.linalg.norm(seen[one_law]) / np.linalg.norm(seen[other]))
        assert np.sqrt(1 - alike**2) > 0.01, f"{one_law} and {other} are one law"


def test_every_law_is_drawn_sooner_or_later():
    drawn, laws = set(), set(LAWS["sensor_drift"])
    for seed in range(40):
        drawn.add(make(Asked(seed, ("sensor_drift",), (2.0,), "poor")).truth["effects"][0]["law"])
        if drawn == laws:
            break
    assert drawn == laws


@pytest.mark.parametrize("effects", [("plastic_elongation", "sensor_drift"), ("stick_slip", "x_draught")])
def test_the_same_seed_makes_the_same_recording_and_another_seed_another(effects):
    request = Asked(SEED, effects, (2.0, 2.0), "usual")
    assert make(request).table.equals(make(request).table)
    assert not make(Asked(SEED + 1, effects, (2.0, 2.0), "usual")).table.equals(make(request).table)


def test_two_effects_have_their_sizes_each_alone():
    recording = make(Asked(SEED, ("backlash", "creep"), (3.0, 1.0), "rich"))
    sizes = [effect["kappa"] for effect in recording.truth["effects"]]
    assert sizes == pytest.approx([3.0, 1.0], rel=0.1)


def test_what_the_protocol_cannot_show_is_out_of_reach():
    with pytest.raises(OutOfReach):
        make(Asked(SEED, ("axial_elasticity",), (2.0,), "poor"))


def test_neither_run_yaml_nor_the_columns_differ_with_what_is_hidden():
    plain = make(Asked(SEED, (), (), "usual"))
    for effect in ("creep", "sensor_lag", "x_leaning"):
        hiding = make(Asked(SEED, (effect,), (3.0,), "usual"))
        assert yaml.safe_dump(hiding.content, sort_keys=False) == yaml.safe_dump(plain.content, sort_keys=False)
        assert list(hiding.table) == list(plain.table)
        assert not hiding.table["displacement_mm"].equals(plain.table["displacement_mm"])
        assert hiding.table.drop(columns="displacement_mm").equals(plain.table.drop(columns="displacement_mm"))
