"""Files that hold values inside values: structs of MATLAB, HDF5 and JSON, imported by the real program."""

import gzip
import json

import numpy as np
import pytest
import scipy.io
from formats.foreign_files import CHANNELS, ROWS, SERIES, imported, read_back, refused, struct_of

NOTES = {"operator": "somebody", "gain": 3.0, "limits": np.arange(5.0)}


@pytest.mark.parametrize("version", ["5", "7.3"])
@pytest.mark.parametrize("kind", ["vectors", "struct", "struct in a struct", "second of two structs"])
def test_structs_of_both_versions_of_matlab_are_read_by_the_names_of_their_fields(tmp_path, version, kind):
    short = {name: values[:40] for name, values in SERIES.items()}
    variables = {
        "vectors": SERIES,
        "struct": {"data": {**SERIES, **NOTES}},
        "struct in a struct": {"rig": {"log": SERIES, "note": NOTES}},
        "second of two structs": {"data": [short, SERIES]},
    }[kind]
    save = (
        (lambda file: scipy.io.savemat(file, variables))
        if version == "5"
        else (lambda file: struct_of(file, variables))
    )
    save(tmp_path / "log.mat")
    channels = CHANNELS
    if kind == "second of two structs":
        channels = {name: {**channel, "column": f"data[1].{channel['column']}"} for name, channel in CHANNELS.items()}
    read_back(*imported(tmp_path / "log.mat", channels))


def test_a_matrix_gives_its_columns_by_index(tmp_path):
    matrix = np.column_stack(list(SERIES.values()))
    scipy.io.savemat(tmp_path / "log.mat", {"data": matrix})
    channels = {name: {**channel, "column": f"data[{i}]"} for i, (name, channel) in enumerate(CHANNELS.items())}
    read_back(*imported(tmp_path / "log.mat", channels))


def test_plain_hdf5_is_read_with_its_groups(tmp_path):
    import h5py

    with h5py.File(tmp_path / "log.h5", "w") as hdf5_file:
        for name, values in SERIES.items():
            hdf5_file.create_dataset(f"run/1/{name}", data=values, compression="gzip")
        hdf5_file["elsewhere"] = h5py.ExternalLink("secret.h5", "/x")
        hdf5_file["again"] = h5py.SoftLink("/run")
    read_back(*imported(tmp_path / "log.h5"))


JSON = {
    "records": lambda: json.dumps(ROWS),
    "object of lists": lambda: json.dumps({name: values.tolist() for name, values in SERIES.items()}),
    "inside an object": lambda: json.dumps({"rig": {"operator": "x", "load": 3}, "log": {"samples": ROWS}}, indent=1),
    "split": lambda: json.dumps({"columns": [*SERIES], "data": [list(row.values()) for row in ROWS]}),
    "lines": lambda: "\n".join(map(json.dumps, ROWS)) + "\n",
    "lines after a remark": lambda: "\n".join(map(json.dumps, [{"version": 2, "rig": "A"}, *ROWS])),
    "lines, the last cut": lambda: "\n".join(map(json.dumps, ROWS)) + '\n{"time_cont": 9',
    "nested lines": lambda: "\n".join(json.dumps({"m": row, "imu": [1, 2, 3]}) for row in ROWS),
}


@pytest.mark.parametrize("kind", JSON)
def test_json_is_read_in_every_form_that_loggers_write(tmp_path, kind):
    file = tmp_path / ("log.jsonl" if "lines" in kind else "log.json")
    file.write_text(JSON[kind]())
    done, folder = imported(file)
    read_back(done, folder)
    assert ("is cut off and was left out" in done.stderr) == ("cut" in kind)
    assert ("1 of its records hold none of these channels" in done.stderr) == ("remark" in kind)


def test_packed_json_and_json_of_another_name_are_known_by_their_content(tmp_path):
    (tmp_path / "log.dat").write_bytes(gzip.compress(JSON["records"]().encode()))
    done, folder = imported(tmp_path / "log.dat")
    assert done.returncode == 2 and not folder.exists()  # a packed text tells nothing before it is unpacked
    (tmp_path / "log.json.gz").write_bytes((tmp_path / "log.dat").read_bytes())
    read_back(*imported(tmp_path / "log.json.gz"))
    (tmp_path / "raw").rename(tmp_path / "before")
    (tmp_path / "log.dat").write_text(JSON["records"]())
    read_back(*imported(tmp_path / "log.dat"))


def bomb(file):
    """An HDF5 file that says that it holds much and holds nothing."""
    import h5py

    with h5py.File(file, "w") as hdf5_file:
        hdf5_file.create_dataset("time_cont", shape=(10**10,), dtype="f8", chunks=(10**6,))


def broken_reference(file):
    import h5py

    with h5py.File(file, "w") as hdf5_file:
        references = hdf5_file.create_dataset("data", shape=(3,), dtype=h5py.ref_dtype)
        hdf5_file.create_dataset("time_cont", data=np.arange(9.0))
        assert not references[0]


def cut(file):
    struct_of(file, SERIES)
    file.write_bytes(file.read_bytes()[:3000])


def table_object(file):
    """A table as MATLAB stores it in a 7.3 file: a few numbers that stand for it."""
    import h5py

    struct_of(file, {"unused": {"a": "b"}})
    with h5py.File(file, "a") as hdf5_file:
        hdf5_file.create_group("#subsystem#")
        hdf5_file.create_dataset("T", data=np.arange(6, dtype=np.uint32)).attrs["MATLAB_object_decode"] = 3


def huge(file):
    with open(file, "wb") as json_file:
        json_file.truncate(200_000_001)
        json_file.write(b'[{"a": 1}')


@pytest.mark.parametrize(
    ("name", "make", "says"),
    [
        ("a.mat", lambda f: scipy.io.savemat(f, {"data": {**SERIES, "theta": 1}}), "theta"),
        ("a.mat", lambda f: scipy.io.savemat(f, {**SERIES, "weg": SERIES["weg"][1:]}), "weg: has"),
        ("a.mat", lambda f: scipy.io.savemat(f, {"note": "nothing"}), "holds no series of numbers"),
        ("a.mat", lambda f: scipy.io.savemat(f, {"a": SERIES, "b": SERIES}), "a.time_cont"),
        ("a.mat", cut, "is not a readable HDF5 file"),
        ("a.mat", table_object, "holds a table, a timeseries or another object of MATLAB's own"),
        ("a.json", huge, "has more than 200 MB. Mend: save it as CSV or Parquet, or cut it into runs"),
        ("a.h5", bomb, "is packed more than 200-fold"),
        ("a.h5", broken_reference, "there are no columns 'theta' and 'weg'"),
        ("a.json", lambda f: f.write_text('{"time_cont": [1, 2'), "is not JSON"),
        ("a.json", lambda f: f.write_text('{"a": 1, "a": 2}'), "says 'a' twice"),
        ("a.json", lambda f: f.write_text("[" * 100_000), "is nested too deep"),
        ("a.json", lambda f: f.write_text(""), "is empty"),
        ("a.json", lambda f: f.write_text("[1" + "0" * 5000 + "]"), "is not JSON"),
        ("a.json", lambda f: f.write_text('{"time_cont": [1, 2], "theta": [1], "weg": [1, "x"]}'), "time_cont"),
        ("a.json", lambda f: f.write_text(JSON["records"]().replace('"theta": 1', '"theta": "off", "b": 1')), "'off'"),
        ("a.jsonl", lambda f: f.write_text("hello\n" + JSON["lines"]()), "line 1: is no JSON"),
        ("a.jsonl.gz", lambda f: f.write_bytes(gzip.compress(b" " * 60_000_000)), "is packed more than 200-fold"),
    ],
)
def test_what_cannot_be_read_is_refused_in_words_and_writes_nothing(tmp_path, name, make, says):
    make(tmp_path / name)
    refused(*imported(tmp_path / name), says)
