"""Foreign recordings in every form that the three public rigs come in, read through their committed mappings."""

import gzip
import io
import os
import subprocess
import sys
from pathlib import Path

import downloaded
import numpy as np
import pandas as pd
import pytest
import scipy.io

from pipeline.foreign.imported import import_run
from pipeline.ground.errors import BadInput
from pipeline.run.samples import read_samples

MAPPINGS = Path(__file__).parents[2] / "pipeline" / "mappings"
TIME_S = np.arange(3000) / 200
POSITION_M = 0.1 * (1 - np.cos(TIME_S))


def made_emps(file, **others):
    """A file as the benchmark's authors write theirs: columns of vectors beside scalars."""
    columns = {"t": TIME_S, "qm": POSITION_M, "vir": np.sin(TIME_S)}
    columns = {name: value[:, None] for name, value in {**columns, **others}.items()}
    scipy.io.savemat(file, {**columns, "gtau": 35.15065188, "note": "metres and volts"})
    return file


def test_a_matlab_file_gives_its_vectors_in_our_units(tmp_path):
    import_run(made_emps(tmp_path / "a.mat"), MAPPINGS / "emps.yaml", "a", tmp_path)
    run, samples = read_samples(tmp_path / "a")
    assert samples["force_n"].to_numpy() == pytest.approx(35.15065188 * np.sin(TIME_S))
    assert samples["position_m"].to_numpy() == pytest.approx(POSITION_M)
    assert run.rig["mass_kg"] == 100 and "load_n" not in samples


def test_force_pulses_are_a_load_that_resists(tmp_path):
    pulses_n = np.where(TIME_S % 3 > 2, 25.0, 0.0)
    file = made_emps(tmp_path / "a.mat", pulses_N=pulses_n)
    import_run(file, MAPPINGS / "emps_pulses.yaml", "a", tmp_path)
    assert read_samples(tmp_path / "a")[1]["load_n"].to_numpy() == pytest.approx(-pulses_n)
    with pytest.raises(BadInput, match=r"load_n: there is no column 'pulses_N', only t, qm, vir"):
        import_run(made_emps(tmp_path / "b.mat"), MAPPINGS / "emps_pulses.yaml", "b", tmp_path)


def test_a_matlab_file_is_read_by_a_job_of_the_workflow_too(tmp_path):
    """Such a job ends with the program that started it; what reads the file is the job's child, and ends with it."""
    words = [made_emps(tmp_path / "a.mat"), "--map", MAPPINGS / "emps.yaml", "--run", "a", "--out", tmp_path / "raw"]
    command = [sys.executable, "-m", "pipeline.import_run", *map(str, words)]
    job = {**os.environ, "TWISTBENCH_PARENT": str(os.getpid())}
    done = subprocess.run(command, cwd=MAPPINGS.parents[1], env=job, capture_output=True, text=True)
    assert done.returncode == 0 and (tmp_path / "raw" / "a" / "recording.parquet").exists(), done.stderr


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (
            lambda file: file.write_bytes(b"MATLAB 7.3 MAT-file".ljust(124) + b"\x00\x02IM" + bytes(400)),
            "not a readable HDF5",
        ),
        (lambda file: file.write_bytes(b"no such thing, but long enough for a header" * 9), "not a MATLAB file"),
        (lambda file: file.write_bytes(b""), "not a MATLAB file"),
        (lambda file: file.write_bytes(made_emps(file).read_bytes()[:5000]), "not a MATLAB file"),
        (lambda file: scipy.io.savemat(file, {"gtau": 35.0, "name": "x", "m": np.ones((3, 3, 3))}), "no series"),
        (
            lambda file: scipy.io.savemat(file, {"t": TIME_S, "qm": POSITION_M[:-1], "vir": TIME_S}),
            "qm: has 2999 values, but t has 3000",
        ),
    ],
)
def test_a_matlab_file_that_cannot_be_read_says_what_to_do(tmp_path, make, says):
    make(tmp_path / "a.mat")
    with pytest.raises(BadInput, match=says):
        import_run(tmp_path / "a.mat", MAPPINGS / "emps.yaml", "a", tmp_path)
    assert not (tmp_path / "a").exists()


def davinci_rows(count=4000):
    """Rows as the surgical tool's logger writes them: an encoder that counts down, a jaw that counts up."""
    time_s = np.arange(count) / 1000
    turns = 0.16 * (1 - np.cos(2 * np.pi * time_s))
    table = np.zeros((count, 10))
    table[:, 0], table[:, 1], table[:, 4] = time_s, np.rint(-8192 * turns), np.rint(800 + 0.9 * 4000 * turns)
    table[:, 5] = 1000 * np.sin(time_s)
    return table


def written(table, remark="% 30° amplitude\x85%\n"):
    text = io.StringIO()
    np.savetxt(text, table, fmt="%.3f", delimiter=",")
    return (remark + text.getvalue()).encode("latin1")


@pytest.mark.parametrize("name", ["a.TXT", "a.TXT.gz", "a.csv.gz", "A_ZIPPED.TXT"])
def test_a_text_recording_is_read_whatever_its_name(tmp_path, name):
    content = written(davinci_rows())
    (tmp_path / name).write_bytes(gzip.compress(content) if "gz" in name or "ZIPPED" in name else content)
    import_run(tmp_path / name, MAPPINGS / "davinci_tool.yaml", "a", tmp_path)
    _, samples = read_samples(tmp_path / "a")
    assert len(samples) == 4000
    assert np.polyfit(samples["motor_deg"], samples["jaw_deg"], 1)[0] == pytest.approx(0.9, rel=1e-3)
    assert samples["motor_deg"].max() == pytest.approx(115.2, abs=0.1)
    assert samples["torque_nm"].to_numpy() == pytest.approx(-0.039811 * np.sin(np.arange(4000) / 1000), abs=1e-7)


@pytest.mark.parametrize("change", ["every_third", "repeated", "backward", "jitter", "part", "rows_lost", "leap"])
def test_odd_clocks_import_and_lose_no_sample(tmp_path, change):
    table = davinci_rows()
    random = np.random.default_rng(3)
    if change == "every_third":
        table = table[::3]
    elif change == "repeated":
        table[200:204, 0] = table[200, 0]
    elif change == "backward":
        table[700, 0] -= 0.05
    elif change == "jitter":
        table[:, 0] += random.uniform(-0.0004, 0.0004, len(table))
    elif change == "part":
        table = table[500:2700]
    elif change == "rows_lost":
        table = table[np.sort(random.choice(len(table), 3000, replace=False))]
    else:
        table[-1, 0] = 900.0
    (tmp_path / "a.TXT").write_bytes(written(table))
    import_run(tmp_path / "a.TXT", MAPPINGS / "davinci_tool.yaml", "a", tmp_path)
    run, samples = read_samples(tmp_path / "a")
    assert len(samples) == len(table)
    mended = {"repeated": {"repeated_time_stamps": 3}, "backward": {"backward_time_stamps": 1}}
    mended |= {"leap": {"leaping_time_stamps": 1}}
    if change != "jitter":  # which three decimals can turn into repeated stamps
        assert run.mended == mended.get(change, {})
    assert samples["time_s"].to_numpy()[:-1] == pytest.approx(np.sort(table[:-1, 0]), abs=0.06)
    assert samples["time_s"].iloc[-1] < 4.01


def test_the_surgical_tool_imports_through_its_committed_mapping(tmp_path):
    for number, file in enumerate(downloaded.files("davinci_tool", "*.TXT.gz")):
        import_run(file, MAPPINGS / "davinci_tool.yaml", f"run-{number}", tmp_path)
        _, samples = read_samples(tmp_path / f"run-{number}")
        raw = pd.read_csv(file, header=None, comment="%", encoding="latin1")
        assert samples["jaw_deg"].to_numpy() == pytest.approx(raw[4].to_numpy() * 0.09)
        assert np.median(np.diff(samples["time_s"])) == pytest.approx(1e-3)
        motor, ones, torque = samples["motor_deg"], np.ones(len(samples)), samples["torque_nm"]
        gear, _, compliance = np.linalg.lstsq(np.column_stack([motor, ones, torque]), samples["jaw_deg"], rcond=None)[0]
        assert 0.8 < gear < 1.0, "winding raises the motor angle, and with it the jaw"
        assert compliance < 0, "what resists holds the jaw back"


def test_the_positioning_system_imports_through_its_committed_mapping(tmp_path):
    (file,) = downloaded.files("emps", "DATA_EMPS.mat")
    import_run(file, MAPPINGS / "emps.yaml", "emps", tmp_path)
    _, samples = read_samples(tmp_path / "emps")
    raw = scipy.io.loadmat(file)
    assert len(samples) == 24841
    assert samples["force_n"].to_numpy() == pytest.approx((raw["gtau"] * raw["vir"]).ravel(), rel=1e-8)
    moving = np.gradient(samples["position_m"], samples["time_s"])
    assert np.corrcoef(moving, samples["force_n"])[0, 1] > 0.5, "a positive force moves it forwards"
