"""Files of other programs with a made recording in them, and what an import of them must come to."""

import h5py
import numpy as np
import openpyxl
import programs
import pytest
import yaml
from made_recording import content, recording

from pipeline.run.samples import read_samples

GOOD = recording()
SERIES = {"time_cont": GOOD["time_s"], "theta": GOOD["motor_turns"] * 360, "weg": GOOD["displacement_mm"] / 10}
SERIES = {name: values.to_numpy() for name, values in SERIES.items()}
CHANNELS = {
    "time_s": {"column": "time_cont"},
    "motor_turns": {"column": "theta", "unit": "deg"},
    "displacement_mm": {"column": "weg", "unit": "cm"},
}
ROWS = [
    dict(zip(SERIES, row, strict=True)) for row in zip(*(values.tolist() for values in SERIES.values()), strict=True)
]


def imported(file, channels=CHANNELS, layout=None, **changes):
    """Import a file with the program; the finished process and the run's folder."""
    mapping = file.parent / "map.yaml"
    mapping.write_text(yaml.safe_dump(content("x", run=None, channels=channels, file=layout, **changes)))
    words = [file, "--map", mapping, "--run", "a-01", "--out", file.parent / "raw"]
    done = programs.run("pipeline.import_run", *words)
    return done, file.parent / "raw" / "a-01"


def read_back(done, folder):
    """Assert that the run has the samples that were written."""
    assert done.returncode == 0, done.stderr
    samples = read_samples(folder)[1]
    for name in ("time_s", "motor_turns", "displacement_mm"):
        assert samples[name].to_numpy() == pytest.approx(GOOD[name].to_numpy()), name


def refused(done, folder, says):
    """Assert that the program says what is wrong, ends with 2 and writes nothing."""
    assert done.returncode == 2 and says in done.stderr and "Mend: " in done.stderr, done.stderr
    assert not folder.parent.exists()


def struct_of(file, value):
    """A MATLAB 7.3 file as MATLAB writes it: a struct is a group, a list of structs one of references."""
    with h5py.File(file, "w", userblock_size=512) as hdf5_file:
        references = hdf5_file.create_group("#refs#")

        def put(group, name, entry):
            if isinstance(entry, dict):
                inside = group.create_group(name)
                inside.attrs["MATLAB_class"] = np.bytes_("struct")
                for key, part in entry.items():
                    put(inside, key, part)
            elif isinstance(entry, list):
                inside = group.create_group(name)
                for key in entry[0]:
                    made_of = []
                    for index, struct in enumerate(entry):
                        put(references, f"{name}{key}{index}", struct[key])
                        made_of.append(references[f"{name}{key}{index}"].ref)
                    inside.create_dataset(key, data=np.array([made_of], dtype=h5py.ref_dtype))
            elif isinstance(entry, str):
                codes = np.frombuffer(entry.encode("utf-16-le"), np.uint16)
                group.create_dataset(name, data=codes[:, None]).attrs["MATLAB_class"] = np.bytes_("char")
            else:
                group.create_dataset(name, data=np.atleast_2d(entry))

        for name, field in value.items():
            put(hdf5_file, name, field)
    with open(file, "r+b") as opened:
        opened.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(124) + b"\x00\x02IM")


def workbook(file, **sheets):
    """An Excel file with a sheet of each name."""
    book = openpyxl.Workbook()
    book.remove(book.active)
    for title, rows in sheets.items():
        sheet = book.create_sheet(title)
        for row in rows:
            sheet.append(row)
    book.save(file)
    return file
