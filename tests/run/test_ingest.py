import gzip
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
from made_recording import recording

from pipeline.ground.errors import BadInput
from pipeline.ground.stored import schemas
from pipeline.run.checked_clock import SLOWEST_S, check_clock
from pipeline.run.samples import questions, read_samples

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


EXCHANGED = GOOD.assign(
    displacement_mm=20 + 0.2 * np.sin(GOOD["time_s"]), load_n=GOOD["displacement_mm"]
)  # by a wrong order of names
COUNTED_BACK = EXCHANGED.assign(
    displacement_mm=np.where(GOOD["time_s"] % 20 < 10, 18.0, 30.0), load_n=83 - GOOD["displacement_mm"]
)  # a load of two steps, and a laser whose reading falls: "explained by stick_slip" it was
TWIST_EXCHANGED = GOOD.assign(motor_turns=GOOD["displacement_mm"] + 5.0, displacement_mm=GOOD["motor_turns"])


@pytest.mark.parametrize(
    ("samples", "field", "says"),
    [
        (spoiled("displacement_mm", with_nan), "displacement_mm", "not a number in 1 of 2300 rows, first in row 41"),
        (spoiled("load_n", lambda v: v * np.inf), "load_n", "not a number"),
        (spoiled("time_s", backwards), "time_s", "runs backwards at row 101.*import_run"),
        (spoiled("time_s", repeated), "time_s", "stands still at row 101.*import_run"),
        (spoiled("time_s", lambda v: np.append(v[:-1], 1e308)), "time_s", "leaps by more than a week.*Mend: correct"),
        (spoiled("time_s", lambda v: np.append(-1e308, v[1:])), "time_s", "leaps by more than a week"),
        (spoiled("time_s", lambda v: v * 1000), "time_s", "no rate of a rig.*unit"),
        (spoiled("motor_turns", lambda v: v * 2 * np.pi), "motor_turns", "looks like rad: set channels"),
        (spoiled("motor_turns", lambda v: v * 360), "motor_turns", "looks like deg"),
        (spoiled("displacement_mm", lambda v: v / 1000), "displacement_mm", "looks like m:"),
        (spoiled("displacement_mm", lambda v: v / 25.4), "displacement_mm", "it looks like inches: set .*unit to in"),
        (spoiled("motor_turns", lambda v: v * 3), "motor_turns", "fit with motor_turns, or radius_mm, 0.34 times as"),
        (spoiled("motor_turns", lambda v: v / 9), "motor_turns", "fit with motor_turns, or radius_mm, 9.1 times as"),
        (spoiled("displacement_mm", lambda v: v * 7), "motor_turns", "displacement_mm 0.14 times as"),
        (spoiled("motor_turns", lambda v: -v), "motor_turns", "negative throughout.*scale to -1"),
        (spoiled("displacement_mm", lambda v: -v), "displacement_mm", "falls while the motor winds"),
        (EXCHANGED, "displacement_mm", "exchange the columns of displacement_mm and load_n"),
        (TWIST_EXCHANGED, "displacement_mm", "exchange the columns of motor_turns and displacement_mm"),
        (EXCHANGED.assign(displacement_mm=20.0), "displacement_mm", "exchange the columns of displacement_mm and load"),
        (COUNTED_BACK, "displacement_mm", "exchange the columns of displacement_mm and load_n"),
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
    done = programs.run("pipeline.stages.ingest", folder, "--out", out)
    assert done.returncode == 2
    assert done.stderr.startswith("error: ") and "Mend: " in done.stderr and "Traceback" not in done.stderr
    assert not out.parent.exists()


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"rig": {"torsion_zone_mm": 1e18, "separator_mm": 8}}, r"the torsion zone within it is 1e\+18 mm"),
        (
            {"actuator": "twisted_pair", "rig": None, "radius_mm": 1e-9},
            "thinner than any string. Mend: is it in metres",
        ),
        ({"radius_mm": 0.0004}, "radius_mm: is 0.0004 mm, thinner than any string. Mend: .*Then it is 0.4 mm"),
        ({"rig": {"torsion_zone_mm": 150, "separator_mm": 8, "load_n": 1e18}}, r"load_n: is 1e\+18 N"),
        ({"load_n": 1e308}, r"load_n: is 1e\+308 N. Mend: check channels.load_n"),
        ({"load_n": -1e308}, "load_n: is -1e"),
        ({"load_n": -6000.0}, "which no fibre bears"),
    ],
)
def test_dimensions_and_loads_that_nothing_has_are_refused_in_words(make_run, changes, says):
    changes, samples = dict(changes), GOOD.copy()
    string = {"material": "UHMWPE", "radius_mm": changes.pop("radius_mm", 0.4), "length_mm": 400}
    string["stiffness_n_per_mm"] = 15
    if "load_n" in changes:
        samples["load_n"] = changes.pop("load_n")
    elif "load_n" in (changes.get("rig") or {}):
        samples = samples.drop(columns="load_n")
    with pytest.raises(BadInput, match=says):
        read_samples(make_run("a-01", samples, string=string, **changes))


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
    with pytest.raises(BadInput, match="motor_turns: is not a number in 1 of 2300 lines, first in line 61"):
        read_samples(folder)


def test_a_quotation_mark_that_is_left_open_swallows_no_lines(make_run):
    folder = make_run("a-01", GOOD.assign(note="ok"), suffix=".csv")
    lines = (folder / "recording.csv").read_text().splitlines()
    for row in (60, 90):
        lines[row] = lines[row].replace("ok", '"ok')
    (folder / "recording.csv").write_text("\n".join(lines))
    with pytest.raises(BadInput, match=rf"has {len(GOOD)} lines of samples.*Mend: remove the quotation mark"):
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
    subprocess.run([sys.executable, "-m", "pipeline.stages.ingest", str(folder), "--out", str(out)], check=True)
    assert list(schemas.read(out).columns) == list(GOOD.columns)
    import pyarrow.parquet as pq

    units = {field.name: field.metadata[b"unit"].decode() for field in pq.read_schema(out)}
    assert units == {"time_s": "s", "motor_turns": "turns", "displacement_mm": "mm", "load_n": "N"}


@pytest.mark.parametrize(
    ("text", "field", "says"),
    [
        ("", "file", "holds no samples"),
        ("time_s,motor_turns,displacement_mm\n", "file", "holds no samples"),
        ("time_s,motor_turns,displacement_mm\n1,2,x\n", "displacement_mm", "line 2 holds 'x', not a number"),
        ("time_s;motor_turns;displacement_mm\n1;2;3\n", "file.delimiter", "set file.delimiter to ';'"),
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


@pytest.mark.parametrize("name", ["load_kg", "load [kg]", "Last (kg)"])
def test_a_load_whose_column_names_kg_is_not_read_as_newtons(make_run, name):
    samples = spoiled("load_n", lambda v: v / 9.80665).rename(columns={"load_n": name})
    with pytest.raises(BadInput, match=r"channels.load_n.unit: kg does not measure .* so write kgf"):
        read_samples(make_run("a-01", samples=samples, channels={"load_n": name}))
    as_force = {"load_n": {"column": name, "unit": "kgf"}}
    assert read_samples(make_run("a-02", samples=samples, channels=as_force))[1]["load_n"].median() > 19.0


def test_a_unit_given_wrongly_is_seen(make_run):
    folder = make_run("a-01", channels={"motor_turns": {"unit": "rad"}})
    with pytest.raises(BadInput, match=r"looks like turns: set channels.motor_turns.unit to turns"):
        read_samples(folder)


def test_two_wrong_units_are_both_said(make_run):
    samples = spoiled("motor_turns", lambda v: v * 360)
    samples["displacement_mm"] /= 10
    with pytest.raises(BadInput, match=r"looks like deg: set .* to deg, and it looks like cm: set .* to cm"):
        read_samples(make_run("a-01", samples))


def test_every_mend_that_names_a_unit_was_tried(make_run, tmp_path):
    """Whatever the factor: once its mend is followed, the recording is read as it was before it was spoiled."""
    for number, (column, factor) in enumerate(
        [(c, f) for c in ("motor_turns", "displacement_mm") for f in (1e-3, 0.039, 0.1, 3, 6.2832, 10, 25.4, 360, 1e3)]
    ):
        samples = spoiled(column, lambda v, factor=factor: v * factor)
        folder = make_run(f"a-{number}", samples)
        try:
            run, read = read_samples(folder)
        except BadInput as error:
            mends = re.findall(r"set channels\.(\w+)\.(unit|scale) to ([\w.]+)", str(error))
            if "find out which" in str(error) or len(mends) != 1:
                continue
            channel, key, value = mends[0]
            value = value.rstrip(".")
            again = make_run(
                f"b-{number}", samples, channels={channel: {key: float(value) if key == "scale" else value}}
            )
            _, read = read_samples(again)
            span_mm = np.ptp(GOOD["displacement_mm"])
            assert np.ptp(read["displacement_mm"]) == pytest.approx(span_mm, rel=0.2), (column, factor, mends)
            assert np.ptp(read["motor_turns"]) == pytest.approx(np.ptp(GOOD["motor_turns"]), rel=0.2), (column, factor)
        else:
            assert questions(run, read, folder), (column, factor)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda v: v + 30, "begins at 30 turns and its lowest is 30.*curve fits 0 at that lowest.*offset to -30"),
        (lambda v: v + 5, "begins at 5 turns.*offset to -5"),
        (lambda v: v - 4, "begins at -4 turns.*offset to 4"),
    ],
)
def test_a_twist_that_does_not_start_near_0_is_questioned(make_run, tmp_path, change, says):
    folder = make_run("a-01", spoiled("motor_turns", change))
    done = programs.run("pipeline.stages.ingest", folder, "--out", tmp_path / "samples.parquet")
    assert done.returncode == 0 and re.search(f"warning: .*motor_turns: {says}", done.stderr)
    assert not questions(*read_samples(make_run("b-01")), folder)


def test_one_column_is_no_two_channels(make_run):
    folder = make_run("a-01", channels={"displacement_mm": {"column": "motor_turns"}})
    with pytest.raises(BadInput, match=r"channels.displacement_mm.column: is column motor_turns, which is motor_turns"):
        read_samples(folder)
    folder = make_run("a-02", channels={"motor_turns": {"column": 2}})
    with pytest.raises(BadInput, match=r"channels.motor_turns.column: is column displacement_mm, which is displ"):
        read_samples(folder)


def test_a_column_that_is_there_twice_is_asked_for_by_index(make_run):
    folder = make_run("a-01", suffix=".csv")
    text = GOOD.to_csv(index=False).splitlines()
    (folder / "recording.csv").write_text("\n".join(["time_s,motor_turns,displacement_mm,motor_turns", *text[1:]]))
    with pytest.raises(BadInput, match="motor_turns: the column 'motor_turns' is there 2 times"):
        read_samples(folder)


@pytest.mark.long
def test_a_packed_file_without_end_is_stopped(make_run):
    numbers, blank = b"1," * 400 + b"1\n", b" " * 999 + b"\n"  # long lines are read sooner than short ones
    for number, content in enumerate((b"\0", numbers, blank)):
        folder = make_run(f"a-{number}", suffix=".csv.gz")
        member = gzip.compress(content * (1_000_000 // len(content)))  # of which any number make a file
        (folder / "recording.csv.gz").write_bytes(member * 120)
        with pytest.raises(BadInput, match=r"packed more than 200-fold|a line of more than 100000 characters"):
            read_samples(folder)


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (
            b"PK\x03\x04" + b"x" * 100,
            "Excel workbook or another zip file, no text. Mend: make a run of it with python",
        ),
        (b'{"time_s": [1, 2]}\n{}', "is JSON, not a table. Mend: name it .json"),
        (b'[{"time_s": 1}]', "is JSON, not a table. Mend: name it .json"),
        (b"<html>\n<table>\n", "is a page of the web, not a table"),
        (b"a\tb\n1\t2\n", r"set file.delimiter to \"\\t\""),
        (b"," * 5000 + b"\n1\n", "has 5001 columns"),
        (b"\xff\xfe\x00", "is not utf-8"),
        (b"\x1f\x8b" + b"no gzip", "cannot be read"),
    ],
)
def test_what_is_no_table_of_text_is_named(make_run, content, says):
    folder = make_run("a-01", suffix=".csv")
    (folder / "recording.csv").write_bytes(content)
    with pytest.raises(BadInput, match=says):
        read_samples(folder)


def test_a_recording_that_is_no_plain_file_is_no_hang(make_run):
    folder = make_run("a-01", suffix=".csv")
    (folder / "recording.csv").unlink()
    for make in (os.mkfifo, os.mkdir):
        make(folder / "recording.csv")
        with pytest.raises(BadInput, match="recording"):
            read_samples(folder)
        (folder / "recording.csv").rmdir() if make is os.mkdir else (folder / "recording.csv").unlink()


@pytest.mark.long
def test_reading_text_takes_little_more_than_the_text(make_run):
    folder = make_run("a-01", suffix=".csv")
    many = pd.concat([GOOD] * 150, ignore_index=True)
    many["time_s"] = np.arange(len(many)) / 100
    many.to_csv(folder / "recording.csv", index=False)
    program = (
        "import resource, sys\nfrom pipeline.formats.text import read_text\n"
        "from pipeline.ground.input.text_file import TextFile\n"
        "from pathlib import Path\npeak = lambda: resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\nbefore = peak()\n"
        "read_text(Path(sys.argv[1]), TextFile.model_validate({}))\nprint(1024 * (peak() - before))"
    )
    path = folder / "recording.csv"
    took = int(subprocess.run([sys.executable, "-c", program, str(path)], capture_output=True, check=True).stdout)
    assert took < 5 * path.stat().st_size


@pytest.mark.parametrize(
    ("string", "says"),
    [
        ({"radius_mm": 0.2}, "no fibre bears: 8.1 GPa on two strings of 0.2 mm radius"),
        ({"radius_mm": 0.6, "length_mm": 300, "stiffness_n_per_mm": 10}, "stretch the string by 68% of its length"),
    ],
)
def test_a_load_in_grams_that_reads_as_newtons_is_refused(make_run, string, says):
    samples = spoiled("load_n", lambda v: v / 9.80665e-3)
    folder = make_run("a-01", samples, string={"material": "UHMWPE", "length_mm": 400, **string})
    with pytest.raises(BadInput, match=f"{says}.*are they grams. set channels.load_n.unit to gf"):
        read_samples(folder)
    _, read = read_samples(make_run("a-02", samples, channels={"load_n": {"unit": "gf"}}))
    assert read["load_n"].to_numpy() == pytest.approx(20.0)


def test_a_load_that_hardly_a_string_bears_is_questioned(make_run):
    string = {"material": "UHMWPE", "radius_mm": 0.6, "length_mm": 400}  # its stiffness is the usual one
    folder = make_run("a-01", spoiled("load_n", lambda v: v * 0 + 1530), string=string)
    (question,) = questions(*read_samples(folder), folder)
    assert question.field == "load_n" and "by 19% of its length" in str(question) and "are they grams?" in str(question)


@pytest.mark.parametrize("clock", ["time_ms", "t_ms", "time_us", "millis"])
def test_a_column_whose_name_carries_its_unit_is_read_in_it(make_run, capsys, clock):
    samples = GOOD.rename(columns={"time_s": clock, "motor_turns": "motor_rad", "load_n": "load_gf"})
    samples[clock] *= 1e6 if "us" in clock else 1e3
    samples["motor_rad"] *= 2 * np.pi
    samples["load_gf"] /= 9.80665e-3
    _, read = read_samples(make_run("a-01", samples))
    assert read.to_numpy() == pytest.approx(GOOD.to_numpy())
    assert f"time_s is read from its column {clock}, in {'us' if 'us' in clock else 'ms'}" in capsys.readouterr().err
    samples["time_min"] = samples["t_us" if clock == "time_ms" else "time_ms"] = 1.0
    with pytest.raises(BadInput, match="there is no column 'time_s'"):
        read_samples(make_run("a-02", samples))


def test_a_slow_rig_that_is_no_string_may_have_a_sample_every_few_seconds():
    slow = pd.DataFrame({"time_s": 4.0 * np.arange(50)})
    check_clock(slow, Path("tanks"), SLOWEST_S)
    with pytest.raises(BadInput, match=r"a sample every 4 s is no rate of a rig.*every 0.05 ms to 0.2 s"):
        check_clock(slow, Path("string"))
    with pytest.raises(BadInput, match="no rate of a rig"):
        check_clock(slow.assign(time_s=4000.0 * np.arange(50)), Path("tanks"), SLOWEST_S)


@pytest.mark.parametrize("first_s", [0.0, 1763000000.0])
def test_five_hertz_are_a_rate_of_a_rig_however_the_stamps_round(make_run, first_s):
    """Steps of 0.2 s come out as 0.20000000000000284 s or, in seconds since 1970, as 0.20000005 s."""
    slow = recording(rate_hz=5.0).assign(time_s=lambda table: table["time_s"] + first_s)
    assert float(slow["time_s"].diff().median()) > 0.2 or not first_s
    assert len(read_samples(make_run("slow", slow))[1]) == len(slow)
    check_clock(pd.DataFrame({"time_s": np.arange(30) * 0.20000000000000284}), Path("log.csv"))
    with pytest.raises(BadInput, match=r"a sample every 0.25 s is no rate of a rig.*every 0.05 ms to 0.2 s"):
        check_clock(pd.DataFrame({"time_s": np.arange(30) * 0.25}), Path("log.csv"))
    with pytest.raises(BadInput, match=r"a sample every 0.02 ms is no rate of a rig"):
        check_clock(pd.DataFrame({"time_s": np.arange(30) * 2e-5}), Path("log.csv"))


@pytest.mark.parametrize(
    ("load_n", "changes", "is_questioned"),
    [
        (lambda v: v / 1000.0, {}, True),
        (lambda v: v / 1000.0, {"channels": {"load_n": {"unit": "mN", "scale": 1000.0}}}, False),
        (lambda v: v * 0.0, {}, False),
        (lambda v: 0.01 * np.sin(np.arange(len(v))), {}, False),  # noise of a cell on which nothing hangs
        (lambda v: v / 1000.0, {"string": {"material": "a", "radius_mm": 0.02, "length_mm": 400}}, False),
    ],
    ids=["kN", "said", "none", "noise", "thin"],
)
def test_a_load_that_is_next_to_none_is_questioned(make_run, load_n, changes, is_questioned):
    samples = spoiled("load_n", load_n)
    samples["displacement_mm"] *= 0.012 if "string" in changes else 1.0  # a thin string contracts by less
    folder = make_run("a-01", samples, **changes)
    load_questions = [
        str(question) for question in questions(*read_samples(folder), folder) if question.field == "load_n"
    ]
    assert len(load_questions) == is_questioned and all(
        "kN? Then set channels.load_n.unit to 'kN'" in each for each in load_questions
    )
