"""A campaign's strings vary as it says, stay what they are when more are asked for, and can be read by the stages."""

from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest

from pipeline.ground.errors import BadInput
from pipeline.ground.kinematics import RAD_PER_TURN
from pipeline.rig.campaign.specimen import SIGMA, Bands, draw_specimen, materials
from pipeline.rig.campaign.strings_to_record import plan
from pipeline.rig.synthetic_folder import whole_recordings
from pipeline.run.dimensions import geometry
from pipeline.run.samples import read_samples
from pipeline.run.strokes import segment

ROOT = Path(__file__).parents[2]
MANY = [planned.specimen for planned in plan(3, 100, 9)]


def program(*arguments):
    return programs.run("pipeline.rig.campaign", *arguments)


@pytest.fixture(scope="module")
def campaign(tmp_path_factory):
    out = tmp_path_factory.mktemp("campaign") / "runs"
    done = program("--strings", 5, "--seed", 3, "--strokes", 3, "--out", out)
    assert done.returncode == 0, done.stderr
    return out


def test_the_same_seed_gives_the_same_strings_and_fewer_strings_the_first_of_them(campaign, tmp_path):
    assert program("--strings", 2, "--seed", 3, "--strokes", 3, "--out", tmp_path / "two").returncode == 0
    first = sorted(path.name for path in campaign.iterdir())[:2]
    assert sorted(path.name for path in (tmp_path / "two").iterdir()) == first
    for run in first:
        for file in ("run.yaml", "recording.parquet"):
            assert (tmp_path / "two" / run / file).read_bytes() == (campaign / run / file).read_bytes()
    others = [planned.specimen for planned in plan(4, 2, 3)]
    assert all(specimen.measured != other.measured for specimen, other in zip(MANY, others, strict=False))


def test_every_run_can_be_read_and_has_its_strokes(campaign):
    names = sorted(path.name for path in campaign.iterdir())
    assert len(names) == 5 and names[0].startswith("campaign-000-")
    for name, planned in zip(names, plan(3, 5, 3), strict=True):
        run, samples = read_samples(campaign / name)
        assert run.run == name == planned.run and name.endswith(run.string.material.lower())
        assert list(samples.columns[:3]) == ["time_s", "motor_turns", "displacement_mm"]
        assert np.median(np.diff(samples.time_s)) == pytest.approx(0.1)
        strokes = segment(samples, "motor_turns", campaign / name)
        assert strokes[strokes.phase == "winding"].stroke.tolist() == [1, 2, 3]
        assert samples.motor_turns.max() == pytest.approx(planned.specimen.top_turns, abs=1e-3)


def test_run_yaml_tells_the_measured_dimensions_and_how_well_they_were_measured(campaign):
    for planned in plan(3, 5, 3):
        run, _ = read_samples(campaign / planned.run)
        assert geometry(run) == planned.specimen.measured != planned.specimen.true
        assert run.tolerance == SIGMA and run.rig["load_n"] == planned.specimen.load_n
    miss = np.array(
        [
            [
                (specimen.true.radius_mm / specimen.measured.radius_mm - 1.0) / SIGMA["radius"],
                *(
                    (getattr(specimen.true, key) - getattr(specimen.measured, key)) / SIGMA[key]
                    for key in SIGMA
                    if "_mm" in key
                ),
            ]
            for specimen in MANY
        ]
    )
    assert (miss.std(axis=0) > 0.8).all() and (miss.std(axis=0) < 1.25).all() and (abs(miss.mean(axis=0)) < 0.35).all()


def test_dimensions_fill_their_bands_and_stay_in_them():
    for name, (low, high) in vars(Bands()).items():
        if name == "helix_tangent":
            drawn = [
                (specimen.measured.separator_mm + specimen.top_turns * RAD_PER_TURN * specimen.measured.radius_mm)
                / specimen.measured.torsion_zone_mm
                for specimen in MANY
            ]
        else:
            drawn = [specimen.load_n if name == "load_n" else getattr(specimen.measured, name) for specimen in MANY]
        room = 0.003 if name == "helix_tangent" else 0.0  # the twist is told in tenths of a turn
        assert low - room <= min(drawn) and max(drawn) <= high + room, name
        assert max(drawn) - min(drawn) > 0.8 * (high - low), name
    assert all(specimen.measured.length_mm > specimen.measured.torsion_zone_mm for specimen in MANY)
    assert {specimen.material for specimen in MANY[:5]} == set(materials())


def test_strings_of_one_material_differ_by_a_tenth():
    bands = Bands(*((value, value) for value in (0.4, 8.0, 150.0, 400.0, 20.0, 0.5)))
    drawn = [draw_specimen("polyester", np.random.default_rng(seed), bands).effects for seed in range(200)]
    for effect, key in (("radius_compaction", "exponent"), ("friction_hysteresis", "turns_per_n")):
        values = np.array([drawn_effects[effect][key] for drawn_effects in drawn])
        assert np.std(np.log(values)) == pytest.approx(0.1, abs=0.02)
        assert np.median(values) == pytest.approx(materials()["polyester"][effect][key], rel=0.03)


def test_materials_hide_different_amounts():
    lost_mm = [
        (planned.specimen.material, -planned.recorded(10.0).contraction_mm[-1] / planned.specimen.true.torsion_zone_mm)
        for planned in plan(3, 30, 9)
    ]
    median = pd.DataFrame(lost_mm, columns=["material", "lost"]).groupby("material").lost.median()
    assert (median > 5e-4).all() and median["nylon"] > 1.5 * median["polyester"] > 2.0 * median["aramid"]


def test_a_campaign_is_made_whole_and_never_over_another(campaign, tmp_path):
    done = program("--strings", 1, "--out", campaign)
    assert done.returncode == 2 and "is there already" in done.stderr and len(list(campaign.iterdir())) == 5
    with pytest.raises(BadInput, match="half way"), whole_recordings(tmp_path / "new") as folder:
        (folder / "run").mkdir()
        raise BadInput("run", "run", "half way", "go on")
    assert not list(tmp_path.iterdir())
