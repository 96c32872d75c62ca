"""docs/import.md: its example is imported as it stands, and its tables name every key that a mapping may hold."""

import hashlib
import json
import re
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
import scipy.io
from formats.foreign_files import workbook
from made_recording import recording

from pipeline.ground.input.text_file import TextFile
from pipeline.run.description import Channel, Run, String
from pipeline.run.next_command import quick
from pipeline.run.samples import read_samples
from pipeline.systems import systems

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "import.md").read_text(encoding="utf-8")


def part(name):
    """The block of the page that a name stands above."""
    return re.search(rf"`{re.escape(name)}`\n\n```\w*\n(.*?)```", PAGE, re.DOTALL)[1]


def program(command, folder):
    """A command of the page, done in a folder without an error."""
    _, option, module, *words = command.split()
    assert option == "-m"
    done = programs.run(module, *words, cwd=folder)
    assert done.returncode == 0, done.stderr
    return done


def test_the_pages_example_is_imported_and_says_what_comes_next(tmp_path):
    original = recording()
    numbers = np.column_stack(
        [original["time_s"] * 1e3, original["motor_turns"] * 360, 12 - original["displacement_mm"]]
    )
    rows = [";".join(f"{value:.6f}" for value in row).replace(".", ",") for row in numbers]
    opening = part("log.csv").splitlines()[:3]
    (tmp_path / "log.csv").write_text("\n".join([*opening, *rows]) + "\n", encoding="cp1252")
    (tmp_path / "map.yaml").write_text(part("map.yaml"), encoding="utf-8")
    program(re.search(r"```sh\n(.* --guess .*)\n```", PAGE)[1], tmp_path)
    draft = (tmp_path / "draft.yaml").read_text(encoding="utf-8")
    assert "delimiter: ;, skip: 2, decimal: ','" in draft and "motor_turns: {column: Drehwinkel, unit: deg}" in draft
    command, following = re.search(r"```sh\n(.*)\n(.*)\n```", PAGE).groups()
    done = program(command, tmp_path)
    diagnose = "python -m pipeline.diagnose raw/nylon-20261126-01 --out reports/mine"
    alone = f"  or ask only what the simulator leaves out: {diagnose}"
    assert done.stdout.splitlines()[-3:] == [f"Next: make its reports: {following}", quick("nylon"), alone]
    folder = tmp_path / "raw" / "nylon-20261126-01"
    _, samples = read_samples(folder)
    for name in ("time_s", "motor_turns", "displacement_mm"):
        assert samples[name].to_numpy() == pytest.approx(original[name].to_numpy(), abs=1e-5), name
    first, second, *_ = (folder / "run.yaml").read_text().splitlines()
    digest = hashlib.sha256((tmp_path / "log.csv").read_bytes()).hexdigest()
    assert first == f"# imported from 'log.csv', sha256 {digest}"
    assert second.startswith("# through the mapping 'map.yaml', sha256 ")


SIZES = "actuator: twisted_pair\nstring: {material: nylon, radius_mm: 0.4, length_mm: 400}\n"
MADE = recording()
T, TURNS, MM = (MADE[name].to_numpy() for name in ("time_s", "motor_turns", "displacement_mm"))


def sheet(file):
    rows = [["Zeit", "Winkel", "Weg"], ["s", "°", "mm"], *np.column_stack([T, TURNS * 360, MM]).tolist()]
    workbook(file, Tabelle1=[["Notes"]], Tabelle2=rows)


def struct(file):
    scipy.io.savemat(
        file, {"data": {"time_cont": T, "theta": TURNS * 2 * np.pi, "x": MM / 1e3, "operator": "somebody"}}
    )


def log(file):
    rows = zip(T.tolist(), TURNS.tolist(), MM.tolist(), strict=True)
    entries = [{"t_ms": 1e3 * t, "motor": {"pos": 4096 * turns}, "x": [mm, 0]} for t, turns, mm in rows]
    file.write_text("\n".join(map(json.dumps, entries)))


def two_axes(file):
    columns = {"t": T, "m1": TURNS, "x1": MM, "m2": TURNS, "x2": MM}
    pd.DataFrame(columns).to_csv(file, sep="\t", index=False)


@pytest.mark.parametrize(
    ("name", "make", "says", "runs"),
    [
        ("a.xlsx", sheet, "sheet: Tabelle2", ["a"]),
        ("a.mat", struct, "data.time_cont", ["a"]),
        ("a.jsonl", log, "t_ms", ["a"]),
        ("a.csv", two_axes, "axes:", ["a-left", "a-right"]),
    ],
)
def test_the_example_of_every_format_imports_its_file(tmp_path, name, make, says, runs):
    make(tmp_path / name)
    example = next(text for text in re.findall(r"```yaml\n(.*?)```", PAGE, re.DOTALL) if says in text)
    (tmp_path / "map.yaml").write_text(SIZES + example, encoding="utf-8")
    program(f"python -m pipeline.import_run {name} --map map.yaml --run a", tmp_path)
    assert sorted(path.name for path in (tmp_path / "raw").iterdir()) == runs
    for run in runs:
        read, samples = read_samples(tmp_path / "raw" / run)
        assert read.string.radius_mm == (0.5 if run == "a-right" else 0.4)
        for column, values in (("time_s", T), ("motor_turns", TURNS), ("displacement_mm", MM)):
            assert samples[column].to_numpy() == pytest.approx(values, abs=1e-6), column


@pytest.mark.parametrize("section", [Run, String, TextFile, Channel])
def test_the_page_names_every_key(section):
    for key in set(section.model_fields) - {"run", "mended"}:
        assert f"`{key}`" in PAGE, key


def test_the_page_lists_every_tolerance_with_its_default():
    listed = {}
    for keys, defaults in re.findall(
        r"^\| (`.*) \| the .* \| ([0-9][^|]*) \|$", PAGE.partition("| in `tolerance` |")[2], re.M
    ):
        values = [float(number) for number in re.findall(r"[0-9.]+", defaults)]
        names = [name for name in re.findall(r"`(\w+)`", keys) if name not in systems()]
        listed |= dict(zip(names, values * len(names) if len(values) == 1 else values, strict=True))
    shipped = ("separator", "twisted_pair", "cable_drive", "moving_mass")
    assert listed == {key: value for name in shipped for key, value in systems()[name].tolerance.items()}
