"""The door to the authors: their register, and the program that writes a run folder and its sealed answer."""

import json
from pathlib import Path

import programs
import pytest

from pipeline.rig.authors import authors, names
from pipeline.rig.authors.interface import Asked, Leg
from pipeline.run.samples import read_samples

ROOT = Path(__file__).parents[3]
PHYSICS = {  # named in docs/physics.md
    "plastic_elongation", "creep", "stiffening", "axial_elasticity", "thermal", "radius_compaction", "wear",
    "friction_hysteresis", "viscous_loss", "stick_slip", "backlash", "shaft_windup", "count_slip", "slack", "jam",
    "overtwist", "sensor_lag", "sensor_drift", "eccentricity", "clamp_slip", "end_stop", "load_swing",
}  # fmt: skip


def program(*words):
    return programs.run("pipeline.rig.authors", *words)


def asked(raw, answer, *more):
    return ("lattice", "--seed", 8, "--protocol", "usual", "--run", "case-001", "--raw", raw, "--answer", answer, *more)


def test_the_authors_know_all_effects_of_known_physics():
    assert {effect for author in authors().values() for effect in author.laws} >= PHYSICS


@pytest.mark.parametrize("name", names())
def test_every_author_knows_ten_effects_of_known_physics_and_two_of_its_own(name):
    laws = authors()[name].laws
    assert len(PHYSICS & set(laws)) >= 10
    own = set(laws) - PHYSICS
    assert len(own) >= 2 and all(effect.startswith("x_") for effect in own)
    assert all(of_one and len(set(of_one)) == len(of_one) for of_one in laws.values())


def test_the_program_writes_a_run_that_tells_nothing_and_an_answer_that_tells_all(tmp_path):
    raw, answer = tmp_path / "raw", tmp_path / "sealed" / "case-001.json"
    effects = ("--effect", "backlash", "creep", "--kappa", 3, 2)
    done = program(*asked(raw, answer, *effects))
    assert done.returncode == 0, done.stderr
    assert done.stdout == f"written: {raw / 'case-001'} (what is hidden: {answer})\n"
    _, samples = read_samples(raw / "case-001")
    assert {"time_s", "motor_turns", "displacement_mm"} <= set(samples)
    truth = json.loads(answer.read_text())
    assert [effect["id"] for effect in truth["effects"]] == ["backlash", "creep"]
    assert (truth["author"], truth["seed"], truth["protocol"], truth["run"]) == ("lattice", 8, "usual", "case-001")
    assert sorted(path.name for path in raw.rglob("*") if path.is_file()) == ["recording.parquet", "run.yaml"]
    text = (raw / "case-001" / "run.yaml").read_text()
    recording = (raw / "case-001" / "recording.parquet").read_bytes()
    for word in ("backlash", "creep", "lattice", *(effect["law"] for effect in truth["effects"])):
        assert word not in text and word.encode() not in recording
    assert program(*asked(raw, tmp_path / "again.json", *effects)).returncode == 2, "a run is never overwritten"
    assert not (tmp_path / "again.json").exists()
    other = program(*asked(tmp_path / "other", tmp_path / "other.json", *effects))
    assert other.returncode == 0
    assert (tmp_path / "other" / "case-001" / "recording.parquet").read_bytes() == recording


@pytest.mark.parametrize(
    ("more", "message"),
    [
        (("--effect", "gremlins", "--kappa", 1), "'gremlins' is not known"),
        (("--effect", "creep", "--kappa", 1, 2), "give one size for each effect"),
        (("--effect", "creep", "--kappa", -1), "is not above 0"),
        (("--effect", "creep", "--kappa", 1e9), "is out of reach"),
    ],
)
def test_what_cannot_be_made_is_said_and_nothing_is_written(tmp_path, more, message):
    done = program(*asked(tmp_path / "raw", tmp_path / "answer.json", *more))
    assert done.returncode == 2 and message in done.stderr and "Mend:" in done.stderr
    assert not [path for path in tmp_path.rglob("*") if path.is_file()]


def test_the_answer_never_lies_beside_the_runs(tmp_path):
    for answer in (tmp_path / "raw" / "answer.json", tmp_path / "sealed" / ".." / "raw" / "case-001" / "answer.json"):
        done = program(*asked(tmp_path / "raw", answer))
        assert done.returncode == 2 and "lies inside" in done.stderr
    kept = tmp_path / "kept.json"
    kept.write_text("precious")
    assert program(*asked(tmp_path / "raw", kept)).returncode == 2
    assert kept.read_text() == "precious" and not (tmp_path / "raw").exists()


@pytest.mark.parametrize(
    "wrong",
    [
        (("creep",), (), "rich"),
        (("creep", "creep"), (1.0, 1.0), "rich"),
        ((), (), "rough"),
        (("creep",), (0.0,), "poor"),
    ],
)
def test_nonsense_cannot_be_asked(wrong):
    with pytest.raises(ValueError, match=r"give|ask|use"):
        Asked(1, *wrong)


@pytest.mark.parametrize("name", names())
def test_a_string_lives_on_through_legs(name):
    """Its first part is what is recorded without them, but for what laws take from the whole session."""
    author = authors()[name]
    alone = author.make(Asked(8, ("friction_hysteresis",), (3.0,), "poor"))
    low, top = (float(alone.table["motor_turns"].quantile(share)) for share in (0.005, 0.995))
    load_n = alone.content["rig"].get("load_n") or float(alone.table["load_n"].median())
    legs = (Leg(5.0, low, load_n), Leg(12.0, top, 2.0 * load_n), Leg(6.0, top, 2.0 * load_n), Leg(12.0, low, load_n))
    longer = author.make(Asked(8, ("friction_hysteresis",), (3.0,), "poor", legs))
    begins_s, time_s = longer.truth["protocol_s"], longer.table["time_s"]
    assert time_s.iloc[-1] == pytest.approx(begins_s + 35.0, abs=1.0) and "protocol_s" not in alone.truth
    assert longer.content["string"] == alone.content["string"] and "load_n" not in longer.content["rig"]
    rows = min(len(alone.table), int((time_s <= begins_s).sum()))
    parted = (longer.table["displacement_mm"] - alone.table["displacement_mm"])[:rows]
    assert (parted - parted.median()).abs().median() < 0.1 * alone.truth["noise_floor_mm"]
    after = longer.table[time_s > begins_s + 8.0]
    assert after["motor_turns"].max() == pytest.approx(top, abs=0.3)  # the encoder has its own zero
    assert after["load_n"].max() == pytest.approx(2.0 * load_n, rel=0.05)
    laws = [[(effect["id"], effect["law"]) for effect in recording.truth["effects"]] for recording in (alone, longer)]
    assert laws[0] == laws[1]
