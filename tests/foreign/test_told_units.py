"""A unit that a file tells, in a column's name or in a row of units, is read or refused, and never passed over."""

import re
import shlex

import pytest
import ready
import yaml
from made_recording import recording

from pipeline.run.samples import read_samples

SIZES = [
    "--material",
    "nylon",
    "--radius-mm",
    "0.4",
    "--length-mm",
    "400",
    "--torsion-zone-mm",
    "150",
    "--separator-mm",
    "8",
]
FORCES = {"kgf": 9.80665, "kg": 9.80665, "gf": 9.80665e-3, "lbf": 4.4482216, "lb": 4.4482216, "ozf": 0.2780139}


def log(path, column: str, unit: str, row: bool) -> None:
    """A log of 20 N in a unit, with a row of units below the names or none."""
    table = recording(2).drop(columns="load_n", errors="ignore").assign(load=20.0 / FORCES[unit])
    lines = table.rename(columns={"load": f'"{column}"'}).to_csv(index=False, quotechar="'").splitlines(keepends=True)
    units = ",".join({"time_s": "s", "motor_turns": "turns", "displacement_mm": "mm"}.get(name, "") for name in table)
    path.write_text("".join([lines[0], *([f"{units}{unit}\n"] if row else []), *lines[1:]]))


def new_run(folder, *options: str):
    return ready.run(
        "pipeline.new_run", "u-1", *SIZES, "--out", folder / "raw", "--recording", folder / "log.csv", *options
    )


def option(words: str) -> list[str]:
    """The option that a refusal ends with, as a shell parts it."""
    return shlex.split(re.search(r"here by (--channels .*)\.\n", words)[1])


def load_n(folder) -> float:
    return float(read_samples(folder / "raw" / "u-1")[1]["load_n"].median())


@pytest.mark.parametrize("unit", FORCES)
def test_a_force_in_the_unit_of_a_row_below_the_names_is_no_newton_without_a_word(tmp_path, unit):
    """2.04 kgf were 2.04 N: the row of units was skipped, and nothing said so."""
    log(tmp_path / "log.csv", "force", unit, row=True)
    file, channels = ["--file", "{skip_below: 1}"], ["--channels", "{load_n: force}"]
    done = new_run(tmp_path, *file, *channels)
    named_unit = {"lb": "lbf", "oz": "ozf"}.get(unit, unit)
    assert done.returncode == 2 and not (tmp_path / "raw").exists()
    assert f"channels.load_n.unit: is missing: the row of units below force says {named_unit}, and" in done.stderr
    done = new_run(tmp_path, *file, *option(done.stderr))
    assert done.returncode == 0 and load_n(tmp_path) == pytest.approx(20.0, rel=1e-3), done.stderr


@pytest.mark.parametrize(
    ("column", "unit"),
    [
        ("load_lbf", "lbf"),
        ("load (lb)", "lb"),
        ("load in kgf", "kgf"),
        ("load / kgf", "kgf"),
        ("Kraft kgf", "kgf"),
        ("F gf", "gf"),
    ],
)
def test_a_force_in_the_unit_of_its_name_is_read_in_it_where_the_name_alone_is_given(tmp_path, column, unit):
    log(tmp_path / "log.csv", column, unit, row=False)
    done = new_run(tmp_path, "--channels", yaml.safe_dump({"load_n": column}))
    assert done.returncode == 0 and load_n(tmp_path) == pytest.approx(20.0, rel=1e-3), done.stderr


@pytest.mark.parametrize(
    ("column", "unit"),
    [("load_kgf", "kgf"), ("load [kg]", "kg"), ("load (lbf)", "lbf"), ("load_ozf", "ozf"), ("load kgf", "kgf")],
)
def test_a_column_with_other_keys_and_no_unit_is_asked_about_the_one_of_its_name(tmp_path, column, unit):
    """`{column: load_kgf, scale: -1}` was read in newtons; it is refused before a recording is there too."""
    log(tmp_path / "log.csv", column, unit, row=False)
    channels = ["--channels", yaml.safe_dump({"load_n": {"column": column, "scale": 1}})]
    done = new_run(tmp_path, *channels)
    assert done.returncode == 2 and f"the column {column} says" in done.stderr.replace("'", ""), done.stderr
    right = option(done.stderr)
    without = ready.run("pipeline.new_run", "u-2", *SIZES, "--out", tmp_path / "raw", *channels)
    assert without.returncode == 2 and "channels.load_n.unit: is missing" in without.stderr
    done = new_run(tmp_path, *right)
    assert done.returncode == 0 and load_n(tmp_path) == pytest.approx(20.0, rel=1e-3), done.stderr


def test_a_unit_that_run_yaml_says_or_a_scale_that_converts_is_believed(tmp_path):
    log(tmp_path / "log.csv", "load_kgf", "kgf", row=False)
    for number, keys in enumerate(({"scale": 9.80665}, {"unit": "N"})):
        channels = yaml.safe_dump({"load_n": {"column": "load_kgf", **keys}})
        assert new_run(tmp_path, "--channels", channels, "--sure").returncode == 0
        (tmp_path / "raw" / "u-1").rename(tmp_path / f"{number}")


def test_an_import_by_a_mapping_asks_for_the_unit_of_the_row_too(tmp_path):
    log(tmp_path / "log.csv", "force", "kgf", row=True)
    string = {"material": "nylon", "radius_mm": 0.4, "length_mm": 400}
    mapping = {"string": string, "rig": {"torsion_zone_mm": 150, "separator_mm": 8}, "file": {"skip_below": 1}}
    (tmp_path / "map.yaml").write_text(yaml.safe_dump({**mapping, "channels": {"load_n": "force"}}))
    options = [tmp_path / "log.csv", "--map", tmp_path / "map.yaml", "--run", "u-1", "--out", tmp_path / "raw"]
    done = ready.run("pipeline.import_run", *options)
    assert done.returncode == 2 and "set channels.load_n.unit to 'kgf'" in done.stderr and "map.yaml" in done.stderr
