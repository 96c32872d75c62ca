"""The author `mechanics`: recordings that the pipeline takes, sizes that are kept, and MuJoCo only when needed."""

import subprocess
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import yaml
from scipy.optimize import least_squares

from pipeline.ground.kinematics import TOLERANCE, Geometry, usual_stiffness
from pipeline.rig.authors import authors
from pipeline.rig.authors.interface import Asked, OutOfReach
from pipeline.rig.authors.mechanics import LAWS, engine, make
from pipeline.rig.authors.mechanics.catalogue import WRITERS
from pipeline.run.samples import read_samples

ROOT = Path(__file__).parents[3]
ONE_EACH = [(effect, place % len(writers)) for place, (effect, writers) in enumerate(WRITERS.items())]
NEEDS_LOADS = ("axial_elasticity", "shaft_windup")


def shown_mm(recording, sigmas):
    """What the geometry shows of a recording's motion with run.yaml's dimensions moved by so many sigmas, in mm."""
    string, rig = recording.content["string"], recording.content["rig"]
    radius, length, zone, separator, scale, angle = sigmas
    geometry = Geometry(
        recording.content["actuator"],
        string["radius_mm"] * (1 + TOLERANCE["radius"] * radius),
        string["length_mm"] + TOLERANCE["length_mm"] * length,
        string.get("stiffness_n_per_mm", usual_stiffness(string["radius_mm"], string["length_mm"])),
        rig.get("torsion_zone_mm", np.nan) + TOLERANCE["torsion_zone_mm"] * zone,
        rig.get("separator_mm", np.nan) + TOLERANCE["separator_mm"] * separator,
    )
    load_n = recording.table["load_n"].to_numpy() if "load_n" in recording.table else rig["load_n"]
    return geometry.contraction_mm(recording.table["motor_turns"].to_numpy() + 0.05 * angle, load_n) * (
        1 + 0.005 * scale
    )


def calibrated(recording, displacement_mm, around):
    """The sigmas, at most three from `around`, and the zero with which the geometry is nearest; and what it leaves."""

    def error(moves):
        residual = (displacement_mm - shown_mm(recording, moves[:6]) - moves[6])[::8] / recording.truth[
            "noise_floor_mm"
        ]
        return np.append(residual, moves[:6] - around)  # so that dimensions that act alike share a move

    zero = float(np.median(displacement_mm - shown_mm(recording, around)))
    low, high = np.append(np.add(around, -3.0), -np.inf), np.append(np.add(around, 3.0), np.inf)
    solution = least_squares(error, [*around, zero], bounds=(low, high), loss="soft_l1", f_scale=10.0, max_nfev=60)
    return solution.x[:6], displacement_mm - shown_mm(recording, solution.x[:6]) - solution.x[6]


@cache
def control_and_moves(protocol):
    """The recording that hides nothing, and the sigmas by which its dimensions were measured wrongly."""
    control = make(Asked(41, (), (), protocol))
    return control, calibrated(control, control.table["displacement_mm"].to_numpy(), np.zeros(6))[0]


def accepted(recording, folder):
    """The samples that the pipeline reads of a recording written as a run folder."""
    folder.mkdir()
    text = yaml.safe_dump({"run": folder.name, **recording.content}, sort_keys=False)
    (folder / "run.yaml").write_text(text, encoding="utf-8")
    recording.table.to_parquet(folder / "recording.parquet", index=False)
    return read_samples(folder)[1]


def test_it_has_ten_and_more_effects_of_known_physics_with_two_laws_each():
    known_effects = [effect for effect in LAWS if not effect.startswith("x_")]
    assert len(known_effects) >= 10 and all(len(LAWS[effect]) >= 2 for effect in known_effects)
    assert len(LAWS) - len(known_effects) >= 2
    assert authors()["mechanics"].laws == LAWS


@pytest.mark.long
@pytest.mark.parametrize(("effect", "number"), ONE_EACH)
def test_a_law_of_every_effect_is_recorded_at_the_size_that_was_asked(tmp_path, monkeypatch, effect, number):
    """The recordings with and without the effect have the same noise, so that their difference is the effect."""
    monkeypatch.setitem(WRITERS, effect, (WRITERS[effect][number],))
    protocol = "rich" if effect in NEEDS_LOADS else "poor"
    recording = make(Asked(41, (effect,), (4.0,), protocol))
    control, true = control_and_moves(protocol)
    assert accepted(recording, tmp_path / "case-1").notna().all().all() and len(recording.table) <= 25_000
    (hidden_effect,) = recording.truth["effects"]
    assert (hidden_effect["id"], hidden_effect["law"]) == (effect, LAWS[effect][number])
    assert abs(hidden_effect["kappa"] / 4.0 - 1.0) < 0.1
    assert recording.content == control.content and list(recording.table) == list(control.table)
    unchanged = [name for name in recording.table if name != "displacement_mm"]
    assert recording.table[unchanged].equals(control.table[unchanged])
    effect_mm = (recording.table["displacement_mm"] - control.table["displacement_mm"]).to_numpy()
    assert np.sqrt(np.mean(np.square(effect_mm - effect_mm[0]))) == pytest.approx(
        hidden_effect["rms_mm"], rel=0.05, abs=0.02
    )
    _, residual = calibrated(control, shown_mm(control, true) + effect_mm, true)
    assert np.std(residual) / recording.truth["noise_floor_mm"] == pytest.approx(4.0, rel=0.1)


@pytest.mark.parametrize("protocol", ["rich", "usual", "poor"])
@pytest.mark.parametrize("seed", [3, 4])
def test_a_recording_that_hides_nothing_is_its_calibrated_geometry_and_noise(tmp_path, protocol, seed):
    recording = make(Asked(seed, (), (), protocol))
    samples = accepted(recording, tmp_path / "case-1")
    assert recording.truth["effects"] == [] and 180 < np.ptp(samples["time_s"]) < 600
    sigmas, error = calibrated(recording, recording.table["displacement_mm"].to_numpy(), np.zeros(6))
    usual = error[np.abs(error - np.median(error)) < 6 * recording.truth["noise_floor_mm"]]
    assert len(error) - len(usual) < 10, "outliers are a few"
    assert np.std(usual) == pytest.approx(recording.truth["noise_floor_mm"], rel=0.1)
    assert np.abs(sigmas).max() < 2.8, "the dimensions were measured within their tolerances"


def test_protocols_are_what_they_are_called():
    rich, poor = (make(Asked(6, (), (), protocol)).table for protocol in ("rich", "poor"))
    levels = {round(float(load)) for load in np.percentile(rich["load_n"], [2, 25, 50, 75, 98])}
    assert len(levels) >= 3 and len({"load_n"} & set(poor)) <= 1
    if "load_n" in poor:
        assert np.ptp(poor["load_n"]) < 0.05 * poor["load_n"].mean()


def test_a_seed_makes_one_recording_and_two_effects_are_sized_alone():
    request = Asked(9, ("creep", "sensor_lag"), (3.0, 2.0), "usual")
    recording, again, alone = make(request), make(request), make(Asked(9, ("sensor_lag",), (2.0,), "usual"))
    assert recording.table.equals(again.table) and recording.truth == again.truth and recording.content == again.content
    assert [effect["id"] for effect in recording.truth["effects"]] == ["creep", "sensor_lag"]
    assert recording.truth["effects"][1] == alone.truth["effects"][0]
    assert not recording.table["displacement_mm"].equals(alone.table["displacement_mm"])


@pytest.mark.parametrize(("effect", "kappa"), [("axial_elasticity", 2.0), ("backlash", 1e9)])
def test_what_the_protocol_cannot_show_is_out_of_reach(effect, kappa):
    with pytest.raises(OutOfReach, match="noise floors"):
        make(Asked(2, (effect,), (kappa,), "poor"))


def test_a_simulation_that_fails_is_out_of_reach_and_leaves_no_log(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = engine.model_text(engine.slider("part"), engine.push("part"))
    with pytest.raises(OutOfReach, match="not stable"):
        engine.simulated(text, np.full((50, 1), 1e14), 0.01)
    assert not list(tmp_path.iterdir())


def test_without_mujoco_the_author_is_known_and_says_what_to_do(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "mujoco", None)
    with pytest.raises(ImportError, match=r"mujoco is not installed|mujoco: is not installed\. Mend: .*env/run\.py"):
        make(Asked(2, ("creep",), (2.0,), "usual"))
    blocked = "import sys; sys.modules['mujoco'] = None; from pipeline.rig.authors import __main__ as door; door.main()"
    words = ["mechanics", "--seed", "1", "--effect", "creep", "--kappa", "2", "--protocol", "usual", "--run", "case-1"]
    words += ["--raw", str(tmp_path / "raw"), "--answer", str(tmp_path / "answer.json")]
    done = subprocess.run(
        [sys.executable, "-c", blocked, *words], cwd=ROOT, capture_output=True, text=True, timeout=600
    )
    assert done.returncode == 2 and "mujoco: is not installed" in done.stderr and "env/run.py" in done.stderr
    assert not list(tmp_path.rglob("*.*"))
