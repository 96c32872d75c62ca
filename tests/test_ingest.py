import subprocess
import sys

import numpy as np
import pytest
from made_recording import recording

from pipeline import schemas
from pipeline.errors import BadInput
from pipeline.ingest import read_samples

GOOD = recording()


def spoiled(column, change):
    samples = GOOD.copy()
    samples[column] = change(samples[column].to_numpy(copy=True))
    return samples


def with_nan(values):
    values[40] = np.nan
    return values


def backwards(values):
    values[100] = values[98]
    return values


def repeated(values):
    values[100] = values[99]
    return values


@pytest.mark.parametrize(
    ("samples", "field", "says"),
    [
        (spoiled("displacement_mm", with_nan), "displacement_mm", "not a number in 1 rows, first in row 41"),
        (spoiled("load_n", lambda v: v * np.inf), "load_n", "not a number"),
        (spoiled("time_s", backwards), "time_s", "runs backwards at row 101.*import_run"),
        (spoiled("time_s", repeated), "time_s", "stands still at row 101.*import_run"),
        (spoiled("time_s", lambda v: v * 1000), "time_s", "no rate of a rig.*unit"),
        (spoiled("motor_turns", lambda v: v * 2 * np.pi), "motor_turns", "looks like rad: set channels"),
        (spoiled("motor_turns", lambda v: v * 360), "motor_turns", "looks like deg"),
        (spoiled("displacement_mm", lambda v: v / 1000), "displacement_mm", "looks like m:"),
        (spoiled("motor_turns", lambda v: -v), "motor_turns", "negative throughout.*scale to -1"),
        (spoiled("displacement_mm", lambda v: -v), "displacement_mm", "falls while the motor winds"),
        (spoiled("displacement_mm", lambda v: v * 0 + 3), "displacement_mm", "never changes"),
        (spoiled("motor_turns", lambda v: v * 0), "motor_turns", "no stroke in it"),
        (GOOD.iloc[:0], "file", "holds 0 samples"),
        (GOOD.iloc[:5], "file", "holds 5 samples"),
        (GOOD.drop(columns="displacement_mm"), "displacement_mm", "no column 'displacement_mm'"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused_and_nothing_written(make_run, tmp_path, samples, field, says):
    folder = make_run("a-01", samples)
    with pytest.raises(BadInput, match=says) as error:
        read_samples(folder)
    assert error.value.field == field
    assert str(folder) in str(error.value)
    out = tmp_path / "processed" / "samples.parquet"
    command = [sys.executable, "-m", "pipeline.ingest", str(folder), "--out", str(out)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 2
    assert done.stderr.startswith("error: ") and "Mend: " in done.stderr and "Traceback" not in done.stderr
    assert not out.parent.exists()


def test_a_real_pair_beyond_its_length_is_no_crash(make_run):
    samples = spoiled("motor_turns", lambda v: v * 2 * np.pi)
    folder = make_run("a-01", samples, actuator="twisted_pair", rig=None)
    with pytest.raises(BadInput, match="motor_turns"):
        read_samples(folder)


def test_missing_rows_outliers_and_jitter_are_data(make_run):
    rng = np.random.default_rng(0)
    samples = GOOD[rng.random(len(GOOD)) > 0.2].copy()
    samples["time_s"] += rng.uniform(0, 0.01, len(samples))
    samples.iloc[50, 2] += 30.0
    _, read = read_samples(make_run("a-01", samples))
    assert len(read) == len(samples)
    assert read["displacement_mm"].to_numpy() == pytest.approx(samples["displacement_mm"].to_numpy())


@pytest.mark.parametrize("suffix", [".parquet", ".csv", ".csv.gz"])
def test_every_form_of_recording_gives_the_same_samples(make_run, suffix):
    _, read = read_samples(make_run("a-01", GOOD, suffix))
    assert read.to_numpy() == pytest.approx(GOOD.to_numpy(), abs=0, rel=0)


def test_an_index_of_a_data_frame_is_a_channel(make_run):
    folder = make_run("a-01")
    GOOD.set_index("time_s").to_parquet(folder / "recording.parquet")
    assert read_samples(folder)[1].to_numpy() == pytest.approx(GOOD.to_numpy())


def test_an_empty_cell_of_a_tab_file_shifts_nothing(make_run):
    folder = make_run("a-01", suffix=".csv", file={"delimiter": "\t"})
    lines = GOOD.to_csv(index=False, sep="\t").splitlines()
    cells = lines[60].split("\t")
    lines[60] = "\t".join([cells[0], "", *cells[2:]])
    (folder / "recording.csv").write_text("\n".join(lines))
    with pytest.raises(BadInput, match="motor_turns: is not a number in 1 rows, first in row 60"):
        read_samples(folder)


def test_a_row_with_a_field_too_many_is_not_cut(make_run):
    folder = make_run("a-01", suffix=".csv")
    lines = GOOD.to_csv(index=False).splitlines()
    (folder / "recording.csv").write_text("\n".join([lines[0], *(f"{line},7" for line in lines[1:])]))
    with pytest.raises(BadInput, match="is not a table"):
        read_samples(folder)


def test_a_rig_without_string_may_describe_one(make_run):
    samples = GOOD.rename(columns={"motor_turns": "motor_deg", "displacement_mm": "jaw_deg"}).drop(columns="load_n")
    _, read = read_samples(make_run("a-01", samples, actuator="cable_drive", rig={"gear_ratio": 0.9}))
    assert list(read.columns) == ["time_s", "motor_deg", "jaw_deg"]


def test_channels_units_and_the_load_of_the_rig(make_run):
    samples = GOOD.rename(columns={"motor_turns": "theta", "displacement_mm": "x"}).drop(columns="load_n")
    samples["theta"] = samples["theta"] * 2 * np.pi
    samples["x"] = (samples["x"] - 3.0) / -10.0
    channels = {
        "motor_turns": {"column": "theta", "unit": "rad"},
        "displacement_mm": {"column": 2, "unit": "cm", "scale": -1, "offset": 0.3},
    }
    rig = {"torsion_zone_mm": 150, "separator_mm": 8, "load_n": 12}
    _, read = read_samples(make_run("a-01", samples, channels=channels, rig=rig))
    assert read["motor_turns"].to_numpy() == pytest.approx(GOOD["motor_turns"].to_numpy())
    assert read["displacement_mm"].to_numpy() == pytest.approx(GOOD["displacement_mm"].to_numpy())
    assert (read["load_n"] == 12).all()


def test_the_load_channel_wins_over_the_rigs_load(make_run):
    rig = {"torsion_zone_mm": 150, "separator_mm": 8, "load_n": 12}
    _, read = read_samples(make_run("a-01", rig=rig))
    assert (read["load_n"] == 20).all()


def test_samples_carry_units(make_run, tmp_path):
    folder, out = make_run("a-01"), tmp_path / "out" / "samples.parquet"
    subprocess.run([sys.executable, "-m", "pipeline.ingest", str(folder), "--out", str(out)], check=True)
    assert list(schemas.read(out).columns) == list(GOOD.columns)
    import pyarrow.parquet as pq

    units = {field.name: field.metadata[b"unit"].decode() for field in pq.read_schema(out)}
    assert units == {"time_s": "s", "motor_turns": "turns", "displacement_mm": "mm", "load_n": "N"}


@pytest.mark.parametrize(
    ("text", "field", "says"),
    [
        ("", "file", "holds no samples"),
        ("time_s,motor_turns,displacement_mm\n", "file", "holds no samples"),
        ("time_s,motor_turns,displacement_mm\n1,2,x\n", "displacement_mm", "row 1 holds 'x', not a number"),
        ("time_s;motor_turns;displacement_mm\n1;2;3\n", "time_s", "no column 'time_s'"),
        ('time_s,motor_turns,displacement_mm\n1,2,"3,5"\n', "displacement_mm", "with a decimal point"),
        ('time_s,motor_turns\n1,2\n1,2,3,4\n"', "file", "is not a table"),
    ],
)
def test_a_bad_text_file_is_named(make_run, text, field, says):
    folder = make_run("a-01", suffix=".csv")
    (folder / "recording.csv").write_text(text)
    with pytest.raises(BadInput, match=says) as error:
        read_samples(folder)
    assert error.value.field == field


@pytest.mark.parametrize(("suffix", "says"), [(".parquet", "not a readable Parquet"), (".csv.gz", "cannot be read")])
def test_a_truncated_file_is_named(make_run, suffix, says):
    folder = make_run("a-01", suffix=suffix)
    path = folder / f"recording{suffix}"
    path.write_bytes(path.read_bytes()[:-200])
    with pytest.raises(BadInput, match=says):
        read_samples(folder)


@pytest.mark.parametrize(
    ("channels", "says"),
    [
        ({"motor_turns": {"unit": "furlong"}}, "channels.motor_turns.unit: furlong is not a known unit"),
        ({"motor_turns": {"unit": "mm"}}, "mm does not measure what the channel is"),
        ({"motor_turns": {"unit": "count"}}, "counts need counts_per_turn"),
        ({"motor_truns": {"unit": "rad"}}, "channels.motor_truns: is not a known channel"),
        ({"motor_turns": {"column": 9}}, "column 9: is not among its 4 columns"),
    ],
)
def test_a_bad_channel_is_named(make_run, channels, says):
    with pytest.raises(BadInput, match=says):
        read_samples(make_run("a-01", channels=channels))
