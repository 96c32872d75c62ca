"""Damaged files of every foreign format: read, or refused in words; never a traceback, never half a run."""

import json
import os
import signal

import h5py
import numpy as np
import pytest
import ready
import scipy.io
import yaml
from formats.foreign_files import CHANNELS, SERIES, struct_of, workbook
from made_recording import content
from shares import shares

from pipeline.foreign.imported import import_run
from pipeline.formats.matlab import read_matlab
from pipeline.ground.errors import BadInput

TRIES = 60
SHORT = {name: values[:: len(values) // 200] for name, values in SERIES.items()}


def hdf5(file):
    with h5py.File(file, "w") as hdf5_file:
        for name, values in SHORT.items():
            hdf5_file.create_dataset(f"data/{name}", data=values)


MAKERS = {
    "a.mat": lambda f: scipy.io.savemat(f, {"data": SHORT, "note": "x"}),
    "b.mat": lambda f: struct_of(f, {"data": [SHORT, SHORT]}),
    "a.h5": hdf5,
    "a.json": lambda f: f.write_text(json.dumps({name: values.tolist() for name, values in SHORT.items()})),
    "a.xlsx": lambda f: workbook(f, a=[[*SHORT], *np.column_stack(list(SHORT.values())).tolist()]),
}


@shares
@pytest.mark.parametrize("name", MAKERS)
def test_a_damaged_file_is_read_or_refused_in_words(tmp_path, monkeypatch, name, share):
    MAKERS[name](tmp_path / name)
    good, random = (tmp_path / name).read_bytes(), np.random.default_rng(len(name))
    mapping, raw = tmp_path / "map.yaml", tmp_path / "raw"
    mapping.write_text(yaml.safe_dump(content("x", run=None, channels=CHANNELS)))
    refused = 0
    for number in range(round(TRIES * share)):
        broken = bytearray(good)
        for place in random.integers(0, len(good), 1 + number % 8):
            broken[place] = random.integers(0, 256)
        broken = broken[: random.integers(len(good) // 8, len(good))] if number % 5 == 0 else broken
        (tmp_path / name).write_bytes(broken)
        try:
            import_run(tmp_path / name, mapping, f"a-{number}", raw)
        except BadInput:
            refused += 1
            assert not (raw / f"a-{number}").exists()
    assert refused and not [path for path in raw.rglob("*") if path.name.startswith(".")]


def test_a_fork_that_crashes_ends_as_a_process_does(tmp_path, monkeypatch):
    monkeypatch.setattr(scipy.io, "loadmat", lambda *_, **__: os.kill(os.getpid(), signal.SIGSEGV))
    MAKERS["a.mat"](tmp_path / "a.mat")
    with pytest.raises(BadInput, match="what reads such files fails on it"):
        read_matlab(tmp_path / "a.mat")


def test_a_byte_that_crashes_the_reader_of_matlab_files_is_refused_in_words(tmp_path):
    file, mapping = tmp_path / "a.mat", tmp_path / "map.yaml"
    MAKERS["a.mat"](file)
    content_of = bytearray(file.read_bytes())
    content_of[272] ^= 0x40  # the type of a field's numbers, with which scipy 1.17 ends in a segmentation fault
    file.write_bytes(content_of)
    mapping.write_text(yaml.safe_dump(content("x", run=None, channels=CHANNELS)))
    words = ["pipeline.import_run", str(file), "--map", str(mapping), "--run", "a-01", "--out", str(tmp_path / "raw")]
    done = ready.run(*words)
    assert done.returncode == 2 and "a.mat: file: is not a MATLAB file" in done.stderr and "Mend: " in done.stderr
    assert not (tmp_path / "raw").exists()
