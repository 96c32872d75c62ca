"""Thousands of damaged run.yaml, mappings and recordings: each is taken or refused in words, none is a crash."""

import gzip
import hashlib
import io
import json
import random
import shutil

import numpy as np
import pytest
import scipy.io
import yaml
from forked import fork_the_reader
from made_damage import YAML, damaged, twisted
from made_recording import content, recording
from shares import shares

from pipeline.foreign.imported import import_run
from pipeline.ground.errors import BadInput
from pipeline.run.folder import read_run
from pipeline.run.samples import read_samples
from pipeline.wire import Channel, Hello, Kind, encode
from pipeline.wire.frames import END

# What overflows warns on the screen; whether it is refused is what is asked here.
pytestmark = pytest.mark.filterwarnings("ignore")
SHORT = recording(1, rate_hz=10.0, top=20.0, speed=10.0)
CSV = SHORT.to_csv(index=False).encode()
FULL = {
    **content("a-01"),
    "tolerance": {"radius": 0.05},
    "simulation": [{"id": "creep", "parameters": {"tau_s": 31.0}}],
    "file": {"delimiter": ",", "header": True, "comment": "%", "encoding": "utf-8"},
    "channels": {
        "time_s": {"column": "time_s", "unit": "s"},
        "motor_turns": {"column": 1, "unit": "turns", "scale": 1, "offset": 0},
        "displacement_mm": {"column": "displacement_mm"},
    },
    "mended": {"repeated_time_stamps": 12},
}
FULL["string"] |= {"id": "spool 3", "strokes_before": 2}
NUMBERS = [
    b"nan",
    b"inf",
    b"-1",
    b"1e999",
    b"1,5",
    b'"',
    b"\n",
    b"\r",
    b",",
    b",,",
    b"x",
    b"\0",
    b"%",
    b"9" * 400,
    b"True",
]


def outcome(action):
    """Whether an input was taken; False where it was refused with file, field, problem and mend."""
    try:
        action()
    except BadInput as error:
        assert error.file and error.field and error.problem and error.mend
        assert len(str(error)) < 2000
        return False
    return True


def of_run_yaml(chance, number):
    text = yaml.safe_dump(FULL, sort_keys=False).encode()
    if number % 2:
        return damaged(text, chance, YAML)
    return yaml.safe_dump(twisted(FULL, chance), allow_unicode=True, sort_keys=False).encode("utf-8", "replace")


@shares
@pytest.mark.parametrize("seed", range(4))
def test_no_run_yaml_is_a_crash(make_run, seed, share):
    chance, folder, taken = random.Random(f"run.yaml {seed}"), make_run("a-01", SHORT, ".csv"), 0
    for number in range(round(750 * share)):
        (folder / "run.yaml").write_bytes(of_run_yaml(chance, number))
        if outcome(lambda: read_run(folder)):
            taken += outcome(lambda: read_samples(folder))
    assert 10 * share < taken < 700 * share


@shares
def test_no_mapping_is_a_crash(tmp_path, share):
    chance, taken, raw = random.Random("mapping"), 0, tmp_path / "raw"
    (tmp_path / "log.csv").write_bytes(CSV)
    for number in range(round(1000 * share)):
        text = of_run_yaml(chance, number).replace(b"run: a-01\n", b"", 1)
        text = text[: text.rfind(b"mended")] if b"mended" in text else text
        (tmp_path / "map.yaml").write_bytes(text)
        if outcome(lambda: import_run(tmp_path / "log.csv", tmp_path / "map.yaml", "a-02", raw)):
            assert outcome(lambda: read_samples(raw / "a-02"))  # what import takes, ingest takes
            taken += 1
            shutil.rmtree(raw / "a-02")
        assert not raw.exists() or not list(raw.iterdir())
    assert 10 * share < taken < 900 * share


def csv():
    return CSV


def packed():
    return gzip.compress(CSV, mtime=0)


def parquet():
    SHORT.to_parquet(file := io.BytesIO(), index=False)
    return file.getvalue()


def matlab():
    scipy.io.savemat(file := io.BytesIO(), {name: SHORT[name].to_numpy() for name in SHORT})
    return file.getvalue()


def frames():
    channels = (Channel("motor_turns", "turns", "i32", 1e-4), Channel("displacement_mm", "mm", "i16", 1e-3))
    hello = Hello("a rig", "1.0", "00000001", 10.0, 2, channels)
    rows = np.zeros(len(SHORT), hello.sample_type)
    rows["t_us"] = np.arange(len(SHORT)) * 100_000
    rows["motor_turns"], rows["displacement_mm"] = SHORT["motor_turns"] * 1e4, SHORT["displacement_mm"] * 1e3
    sent = [encode(Kind.HELLO, 0, hello.pack())]
    sent += [encode(Kind.SAMPLE, number, row.tobytes()) for number, row in enumerate(rows, 1)]
    return b"".join([*sent, encode(Kind.END, len(sent), END.pack(len(rows), 0))])


@shares
@pytest.mark.parametrize(
    ("make", "suffix", "tries"),
    [
        (csv, ".csv", 1000),
        (packed, ".csv.gz", 400),
        (parquet, ".parquet", 700),
        (matlab, ".mat", 500),
        (frames, ".frames", 500),
    ],
)
def test_no_recording_is_a_crash(make_run, tmp_path, monkeypatch, make, suffix, tries, share):
    fork_the_reader(monkeypatch)
    chance, good, taken = random.Random(suffix), make(), 0
    folder = make_run("a-01", SHORT, ".csv")
    (folder / "recording.csv").unlink()
    path = tmp_path / "log.mat" if suffix == ".mat" else folder / f"recording{suffix}"
    (tmp_path / "map.yaml").write_text(yaml.safe_dump(content("x", run=None)))

    def read():
        if suffix == ".frames":
            info = {"sha256": hashlib.sha256(path.read_bytes()).hexdigest()}
            (folder / "capture.json").write_text(json.dumps(info))
        if suffix != ".mat":
            return read_samples(folder)
        shutil.rmtree(tmp_path / "raw" / "b-01", ignore_errors=True)
        return import_run(path, tmp_path / "map.yaml", "b-01", tmp_path / "raw")

    path.write_bytes(good)
    assert outcome(read), "the good one"
    for _ in range(round(tries * share)):
        path.write_bytes(damaged(good, chance, NUMBERS if suffix == ".csv" else []))
        taken += outcome(read)
    assert taken < tries * share


@shares
def test_no_capture_json_is_a_crash(make_run, share):
    chance, folder = random.Random("capture.json"), make_run("a-01", SHORT, ".csv")
    (folder / "recording.csv").rename(folder / "recording.frames")
    (folder / "recording.frames").write_bytes(frames())
    good = {"sha256": "0", "hello": {"device": "x"}, "started_utc": "2026", "counts": [1, {"lost": 2}]}
    for number in range(round(900 * share)):
        text = (
            json.dumps(twisted(good, chance)).encode()
            if number % 2
            else damaged(json.dumps(good).encode(), chance, YAML)
        )
        (folder / "capture.json").write_bytes(text)
        outcome(lambda: read_samples(folder))
