import shutil
import subprocess
import sys
from io import BytesIO
from pathlib import Path

import downloaded
import numpy as np
import pandas as pd
import programs
import pytest
import ready
import yaml
from made_recording import content, recording

from pipeline.foreign.imported import import_run
from pipeline.foreign.mended_clock import mend_time
from pipeline.formats.own_table import read_table
from pipeline.ground.errors import BadInput
from pipeline.new_run import make_run as new_run
from pipeline.run.samples import read_samples

MAPPINGS = Path(__file__).parent.parent / "pipeline" / "mappings"
GOOD = recording()


@pytest.fixture
def foreign(tmp_path):
    """A logger's file, its mapping, and what the samples must become."""
    table = pd.DataFrame({0: GOOD["time_s"] * 1e3, 1: GOOD["motor_turns"] * 360, 2: GOOD["displacement_mm"]})
    file, mapping = tmp_path / "log.csv", tmp_path / "map.yaml"
    file.write_text("% a logger's remark\n" + table.to_csv(index=False, header=False, sep=";"))
    channels = {
        "time_s": {"column": 0, "unit": "ms"},
        "motor_turns": {"column": 1, "unit": "deg"},
        "displacement_mm": {"column": 2},
    }
    layout = {"delimiter": ";", "header": False, "comment": "%"}
    mapping.write_text(yaml.safe_dump(content("x", run=None, file=layout, channels=channels)))
    return file, mapping, tmp_path / "raw"


def test_import_makes_a_run_folder_that_reads_like_any_other(foreign):
    file, mapping, raw = foreign
    import_run(file, mapping, "a-01", raw)
    run, samples = read_samples(raw / "a-01")
    assert samples["motor_turns"].to_numpy() == pytest.approx(GOOD["motor_turns"].to_numpy())
    assert samples["time_s"].to_numpy() == pytest.approx(GOOD["time_s"].to_numpy())
    assert run.mended == {}


def test_a_second_run_of_the_same_size_is_said_to_be_of_another_string_until_its_id_is_given(foreign):
    """It became a new string without a word, and its strokes counted from 1 again."""

    def imported(name, *words):
        return programs.run(
            "pipeline.import_run", foreign[0], "--map", foreign[1], "--out", foreign[2], "--run", name, *words
        )

    done = imported("a-01")
    assert done.returncode == 0 and "note:" not in done.stderr
    done = imported("a-02")
    note = "note: this counts as another string than a-01, of the same material and size. If it is the same one, write "
    mend = f"`id: a-01` under `string` in {foreign[2]}/a-02/run.yaml; the next import of it: --string-id a-01\n"
    assert done.returncode == 0 and note + mend in done.stderr, done.stderr
    assert "byte by byte" in done.stderr and "that of a-01; if it is no second recording, remove" in done.stderr
    done = imported("a-03", "--string-id", "a-01")
    assert "of the same string: its strokes count twice there" in done.stderr
    assert done.returncode == 0 and "note:" not in done.stderr
    assert f"{foreign[2]}/a-01 {foreign[2]}/a-03 --together" in done.stdout
    own = foreign[2] / "a-02" / "run.yaml"
    own.write_text(own.read_text().replace("string:\n", "string:\n  id: a-01\n"))
    assert {read_samples(foreign[2] / name)[0].string_id for name in ("a-01", "a-02", "a-03")} == {"a-01"}


def test_a_rule_s_import_looks_at_no_other_run_and_a_folder_s_warns_of_copies(foreign, tmp_path, capsys):
    """A job of `make real` opened the runs beside its own, which are outputs of other jobs."""
    for name in ("a-01", "a-02"):
        import_run(*foreign[:2], name, foreign[2])
    assert "byte by byte" not in capsys.readouterr().err
    files = tmp_path / "logs"
    files.mkdir()
    for name in ("1", "2"):
        shutil.copy(foreign[0], files / f"{name}{foreign[0].suffix}")
    done = programs.run("pipeline.import_run", files, "--map", foreign[1], "--out", tmp_path / "own", "--run", "b")
    assert done.returncode == 0 and "b-2: the recording is byte by byte that of b-1" in done.stderr, done.stderr


def test_a_string_id_for_a_rig_without_a_string_is_refused(foreign):
    mapping = {"actuator": "moving_mass", "channels": {"position_m": {"column": 2}}}
    foreign[1].write_text(yaml.safe_dump(mapping))
    with pytest.raises(BadInput, match="leave --string-id out"):
        import_run(*foreign[:2], "a-01", foreign[2], "spool")


def test_it_says_which_column_it_read_as_what_over_which_range(foreign):
    lines = import_run(foreign[0], foreign[1], "a-01", foreign[2]).splitlines()
    assert lines[0] == f"{foreign[2] / 'a-01'}: {len(GOOD)} samples"
    assert "  motor_turns 0 to 27 (from 1 in deg)" in lines and lines[2].startswith("  time_s 0 to ")
    assert any(line.startswith("  no load: taken as 0 N; if one hangs, name its column as load_n") for line in lines)
    mapping = yaml.safe_load(foreign[1].read_text())
    mapping["rig"]["load_n"] = 30
    foreign[1].write_text(yaml.safe_dump(mapping))
    assert "no load" not in import_run(foreign[0], foreign[1], "a-02", foreign[2])


def test_a_displacement_the_wrong_way_is_mended_by_the_other_sign_of_its_own_scale(foreign):
    file, mapping, raw = foreign
    content_before = yaml.safe_load(mapping.read_text())
    for by, mend in (
        (-1, "set channels.displacement_mm.scale to 1, not -1"),
        (-2.5, "set channels.displacement_mm.scale to 2.5, not -2.5"),
    ):
        content_before["channels"]["displacement_mm"]["scale"] = by
        mapping.write_text(yaml.safe_dump(content_before))
        with pytest.raises(BadInput, match=mend):
            import_run(file, mapping, "a-01", raw)


@pytest.mark.parametrize(("unit", "asks"), [("K", True), ("degC", False)])
def test_a_temperature_that_no_room_has_is_questioned(foreign, capsys, unit, asks):
    file, mapping, raw = foreign
    table = pd.read_csv(file, sep=";", header=None, comment="%").assign(warm=21.5)
    file.write_text(table.to_csv(index=False, header=False, sep=";"))
    changed = yaml.safe_load(mapping.read_text())
    changed["channels"]["temperature_c"] = {"column": 3, "unit": unit}
    mapping.write_text(yaml.safe_dump(changed))
    import_run(file, mapping, "a-01", raw)
    assert ("temperature_c: is -251.6 to -251.6 °C, which no room has" in capsys.readouterr().err) == asks


def test_the_rows_of_a_file_without_a_clock_are_as_far_apart_as_the_mapping_says(foreign):
    file, mapping, raw = foreign
    mapping_content = yaml.safe_load(mapping.read_text())
    mapping_content["channels"]["time_s"] = {"step_s": 0.05}
    mapping.write_text(yaml.safe_dump(mapping_content))
    import_run(file, mapping, "a-01", raw)
    _, samples = read_samples(raw / "a-01")
    assert samples["time_s"].to_numpy() == pytest.approx(0.05 * np.arange(len(GOOD)))
    for channels in ({"time_s": {"step_s": 0.05, "unit": "ms"}}, {"displacement_mm": {"column": 2, "step_s": 0.05}}):
        mapping.write_text(yaml.safe_dump({**mapping_content, "channels": {**mapping_content["channels"], **channels}}))
        with pytest.raises(BadInput, match=r"step_s: says how far apart the rows are.* keep it for time_s alone"):
            import_run(file, mapping, "a-02", raw)
        assert not (raw / "a-02").exists()


def dated(foreign, change=lambda stamps: stamps, **time_s):
    """The logger's file with dates for its time, and its mapping."""
    file, mapping, raw = foreign
    stamps = pd.Timestamp("2026-11-23 23:59:59") + pd.to_timedelta(GOOD["time_s"].round(6), unit="s")
    table = pd.read_csv(file, sep=";", header=None, comment="%")
    table[0] = change(stamps.dt.strftime("%d.%m.%Y %H:%M:%S.%f"))
    file.write_text("% a logger's remark\n" + table.to_csv(index=False, header=False, sep=";"))
    mapping_content = yaml.safe_load(mapping.read_text())
    mapping_content["channels"]["time_s"] = {"column": 0, **time_s}
    mapping.write_text(yaml.safe_dump(mapping_content))
    return file, mapping, raw


def test_dates_are_read_as_seconds_from_the_first_and_pass_midnight(foreign):
    file, mapping, raw = dated(foreign)
    import_run(file, mapping, "a-01", raw)
    assert read_samples(raw / "a-01")[1]["time_s"].to_numpy() == pytest.approx(GOOD["time_s"].to_numpy(), abs=1e-5)


def test_dates_with_a_unit_are_refused(foreign):
    with pytest.raises(BadInput, match=r"time_s.unit: ms is not the unit of dates and times of day.* take it out"):
        import_run(*dated(foreign, unit="ms")[:2], "a-01", foreign[2])


@pytest.mark.parametrize("wrong", ["30.02.2026 10:00:00", "12:5", "soon", "17.5"])
def test_a_row_without_a_date_among_dates_is_named(foreign, wrong):
    file, mapping, raw = dated(foreign, lambda stamps: stamps.where((stamps.index < 700) | (stamps.index > 730), wrong))
    with pytest.raises(BadInput, match=rf"time_s: line 702 holds '?{wrong}'?, not a time of day like '23.11.2026"):
        import_run(file, mapping, "a-01", raw)
    assert not raw.exists()


def test_some_rows_of_a_file_can_be_asked_for_and_no_more_than_it_has(foreign):
    file, mapping, raw = foreign
    mapping_content = yaml.safe_load(mapping.read_text())
    last = len(GOOD) - 10
    for rows, name in (([5, last], "a-01"), ([5, len(GOOD) + 1], "a-02"), ([9, 9], "a-02")):
        mapping.write_text(yaml.safe_dump({**mapping_content, "file": {**mapping_content["file"], "rows": rows}}))
        if name == "a-01":
            import_run(file, mapping, name, raw)
            continue
        with pytest.raises(BadInput, match=r"file.rows: (asks for rows up to|ends before it begins)"):
            import_run(file, mapping, name, raw)
    _, samples = read_samples(raw / "a-01")
    assert samples["motor_turns"].to_numpy() == pytest.approx(GOOD["motor_turns"].to_numpy()[5:last])
    assert not (raw / "a-02").exists()


def test_import_mends_time_stamps_says_so_and_drops_nothing(foreign):
    file, mapping, raw = foreign
    lines = file.read_text().splitlines()
    for row in (50, 51, 300):
        lines[row] = ";".join([lines[row - 1].split(";")[0], *lines[row].split(";")[1:]])
    lines[400] = ";".join(["0", *lines[400].split(";")[1:]])
    file.write_text("\n".join(lines))
    summary = import_run(file, mapping, "a-01", raw)
    run, samples = read_samples(raw / "a-01")
    assert len(samples) == len(GOOD)
    assert run.mended == {"backward_time_stamps": 1, "repeated_time_stamps": 3}
    assert "3 repeated time stamps" in summary
    assert samples["time_s"].to_numpy() == pytest.approx(GOOD["time_s"].to_numpy(), abs=0.05)


@pytest.mark.parametrize(
    ("name", "change", "says"),
    [
        ("A_01", None, "--run: run"),
        ("../../escape", None, "--run: run"),
        ("a-01", ("% a", "a"), "not a number|not a table|which has not the"),
        ("a-01", None, None),
    ],
)
def test_bad_imports_write_nothing(foreign, name, change, says):
    file, mapping, raw = foreign
    if change:
        file.write_text(file.read_text().replace(*change))
    if says is None:
        import_run(file, mapping, name, raw)
        says = "is there already"
    before = sorted(raw.rglob("*")) if raw.exists() else []
    with pytest.raises(BadInput, match=says):
        import_run(file, mapping, name, raw)
    assert (sorted(raw.rglob("*")) if raw.exists() else []) == before


def test_many_time_stamps_that_are_no_numbers_are_not_mended(foreign):
    file, mapping, raw = foreign
    lines = file.read_text().splitlines()
    for row in range(30, 60):
        lines[row] = ";".join(["nan", *lines[row].split(";")[1:]])
    file.write_text("\n".join(lines))
    with pytest.raises(BadInput, match="time_s: is not a number"):
        import_run(file, mapping, "a-01", raw)
    assert not raw.exists()


@pytest.mark.parametrize("damaged", ["75,0#;;7Ã9,", "1500,0", "1500,0;2x,772;1,5", "nan;1,0;2,0"])
def test_a_damaged_line_costs_itself_and_is_named_by_its_line_in_the_file(foreign, capsys, damaged):
    """One line of 3000 refused the file: by its row, and "write numbers with a decimal point" of decimal commas."""
    file, mapping, raw = foreign
    lines = file.read_text().replace(".", ",").splitlines()
    lines[30] = damaged
    file.write_text("\n".join(lines) + "\n")
    text = yaml.safe_load(mapping.read_text())
    mapping.write_text(yaml.safe_dump({**text, "file": {**text["file"], "decimal": ","}}))
    import_run(file, mapping, "a-01", raw)
    assert f"log.csv: 1 damaged line left out: line 31, '{damaged}'\n" in capsys.readouterr().err
    samples = pd.read_parquet(raw / "a-01" / "recording.parquet")
    assert np.allclose(samples["motor_turns"], GOOD["motor_turns"].drop(index=29))
    mapping.write_text(yaml.safe_dump({**text, "file": {**text["file"], "decimal": ",", "rows": [20, len(GOOD)]}}))
    import_run(file, mapping, "a-02", raw)
    assert f"left out: line 31, '{damaged}'\n" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("cell", "decimal", "mend"),
    [
        ("75,0#", ",", "remove these lines, or name the column that is meant"),
        ("75,5", ".", 'set file.decimal to ","'),
        ("1.075,5", ",", 'write numbers with no other sign in them than the decimal sign ","'),
    ],
)
def test_many_damaged_cells_are_refused_with_a_mend_that_fits_them(foreign, cell, decimal, mend):
    file, mapping, raw = foreign
    lines = file.read_text().splitlines() if decimal == "." else file.read_text().replace(".", ",").splitlines()
    for row in range(30, 60):
        lines[row] = ";".join([lines[row].split(";")[0], cell, "1"])
    file.write_text("\n".join(lines) + "\n")
    text = yaml.safe_load(mapping.read_text())
    mapping.write_text(yaml.safe_dump({**text, "file": {**text["file"], "decimal": decimal}}))
    with pytest.raises(BadInput) as error:
        import_run(file, mapping, "a-01", raw)
    problem = f"line 31 holds '{cell}', not a number; so do 29 more lines"
    assert (error.value.field, error.value.problem, error.value.mend) == ("motor_turns", problem, mend)
    assert not raw.exists()


def test_the_rigs_load_is_not_baked_in(foreign):
    file, mapping, raw = foreign
    import_run(file, mapping, "a-01", raw)
    assert "load_n" not in pd.read_parquet(raw / "a-01" / "recording.parquet").columns
    text = (raw / "a-01" / "run.yaml").read_text()
    (raw / "a-01" / "run.yaml").write_text(text.replace("separator_mm: 8", "separator_mm: 8\n  load_n: 30"))
    assert (read_samples(raw / "a-01")[1]["load_n"] == 30).all()


def test_no_flipped_bit_of_an_imported_recording_is_read_with_other_values(foreign):
    file, mapping, raw = foreign
    import_run(file, mapping, "a-01", raw)
    path = raw / "a-01" / "recording.parquet"
    content, good = path.read_bytes(), read_table(path, None)
    for place in np.random.default_rng(0).integers(0, 8 * len(content), 200):
        flipped = bytearray(content)
        flipped[place // 8] ^= 1 << (place % 8)
        path.write_bytes(flipped)
        try:
            assert read_table(path, None).equals(good), place  # the bit was the seal's own mark
        except BadInput as error:
            assert "damaged" in str(error) or "Parquet" in str(error)
    pd.read_parquet(BytesIO(content)).to_parquet(path)
    assert read_table(path, None).equals(good)  # a foreign file without a seal


def test_a_bad_mapping_is_named_not_the_run(foreign):
    file, mapping, raw = foreign
    mapping.write_text(mapping.read_text().replace("radius_mm", "raduis_mm"))
    with pytest.raises(BadInput, match=rf"{mapping}: string.raduis_mm"):
        import_run(file, mapping, "a-01", raw)


def test_the_program_exits_2_on_bad_input(foreign):
    file, mapping, raw = foreign
    words = ["pipeline.import_run", str(file), "--map", str(mapping), "--out", str(raw), "--run"]
    assert subprocess.run([sys.executable, "-m", *words, "Bad"], capture_output=True).returncode == 2
    assert ready.run(*words, "good").returncode == 0


@pytest.mark.parametrize("kind", ["two leap", "ten are zero", "wraps", "runs backwards", "leap for good"])
def test_a_clock_that_is_wrong_for_long_is_refused_and_not_mended(foreign, kind):
    file, mapping, raw = foreign
    time_s = GOOD["time_s"].to_numpy(copy=True)
    if kind == "two leap":
        time_s[400:402] += 1e6
    elif kind == "ten are zero":
        time_s[500:510] = 0
    elif kind == "wraps":
        time_s %= 16.384
    elif kind == "leap for good":
        time_s[400:] += 1e6
    else:
        time_s = time_s[::-1]
    lines = file.read_text().splitlines()
    cells = [";".join([str(1e3 * at), *line.split(";")[1:]]) for at, line in zip(time_s, lines[1:], strict=True)]
    file.write_text("\n".join([lines[0], *cells]))
    with pytest.raises(
        BadInput, match=r"time_s: (falls back or leaps|leaps by more than a week).*Mend: correct the stamp"
    ):
        import_run(file, mapping, "a-01", raw)
    assert not raw.exists()


@pytest.mark.parametrize(
    ("stamps", "mended", "rules"),
    [
        ([0, 1, 2, 3], [0, 1, 2, 3], {}),
        ([0, 1, 1, 1, 2, 3], [0, 1, 4 / 3, 5 / 3, 2, 3], {"repeated_time_stamps": 2}),
        ([0, 1, 2, 1.5, 4, 5], [0, 1, 2, 3, 4, 5], {"backward_time_stamps": 1}),
        ([0, 1, 9, 3, 4, 5], [0, 1, 2, 3, 4, 5], {"backward_time_stamps": 1}),
        ([0, 1, 2, 0, 1, 2], [0, 1, 2, 3, 4, 5], {"backward_time_stamps": 1}),
        ([0, 1, 2, 3, 3], [0, 1, 2, 3, 4], {"repeated_time_stamps": 1}),
        ([0, 1, 2, 3, 99], [0, 1, 2, 3, 4], {"leaping_time_stamps": 1}),
        ([-99, 1, 2, 3, 4], [0, 1, 2, 3, 4], {"leaping_time_stamps": 1}),
        ([0, 1, 2, 3, 9], [0, 1, 2, 3, 9], {}),
        ([0, 1, 50, 51, 90], [0, 1, 50, 51, 90], {}),
    ],
)
def test_mended_time(stamps, mended, rules):
    time_s, counts = mend_time(np.array(stamps, float))
    assert time_s == pytest.approx(np.array(mended, float))
    assert counts == rules


def test_new_run_checks_and_copies(tmp_path):
    file = tmp_path / "log.csv.gz"
    GOOD.to_csv(file, index=False)
    folder = new_run(content("a-01"), file, tmp_path / "raw")
    _, samples = read_samples(folder)
    assert len(samples) == len(GOOD)
    with pytest.raises(BadInput, match="is there already"):
        new_run(content("a-01"), file, tmp_path / "raw")
    with pytest.raises(BadInput, match="did you mean"):
        new_run({**content("a-02"), "rigg": {}}, file, tmp_path / "raw")
    with pytest.raises(BadInput, match="--recording"):
        new_run(content("a-02"), tmp_path / "log.xlsx", tmp_path / "raw")
    assert [path.name for path in (tmp_path / "raw").iterdir()] == ["a-01"]


def test_new_run_describes_a_recording_that_is_there_already(make_run, tmp_path):
    folder = make_run("a-01")
    (folder / "run.yaml").unlink()
    new_run(content("a-01"), None, tmp_path / "raw")
    assert len(read_samples(folder)[1]) == len(GOOD)


def test_new_run_from_the_command_line(tmp_path):
    command = (
        "new_run nylon-01 --material nylon --radius-mm 0.5 --length-mm 300 --stiffness-n-per-mm 8 "
        f"--torsion-zone-mm 150 --separator-mm 8 --load-n 20 --string-id spool-1 --out {tmp_path}"
    )
    subprocess.run([sys.executable, "-m", *f"pipeline.{command}".split()], check=True, capture_output=True)
    written = yaml.safe_load((tmp_path / "nylon-01" / "run.yaml").read_text())
    assert written["string"] == {
        "material": "nylon", "radius_mm": 0.5, "length_mm": 300.0, "stiffness_n_per_mm": 8.0, "id": "spool-1",
    }  # fmt: skip


@pytest.mark.parametrize("module", [1, 2, 3])
def test_the_haptic_device_imports_through_its_committed_mapping(tmp_path, module):
    for file in downloaded.files("tsa_haptic", "*.csv.gz"):
        name = file.name.split(".")[0].replace("_", "-")
        import_run(file, MAPPINGS / f"tsa_haptic_{module}.yaml", name, tmp_path)
        run, samples = read_samples(tmp_path / name)
        raw = pd.read_csv(file, header=None)
        assert samples["displacement_mm"].to_numpy() == pytest.approx(raw[12 + module].to_numpy())
        assert samples["motor_turns"].to_numpy() == pytest.approx(raw[module].to_numpy() / 2 / np.pi)
        assert run.string.material == f"tsa_haptic_{module}"


def test_a_tolerance_that_is_likely_a_mistake_is_questioned_by_import_and_ingest(foreign, capsys):
    file, mapping, raw = foreign
    mapping.write_text(mapping.read_text() + "tolerance: {radius: 0.5}\n")
    import_run(file, mapping, "a-01", raw)
    question = "tolerance.radius: is 0.5, a share: 50 % of 0.4 mm, or ± 0.2 mm"
    assert f"warning: {mapping}: {question}" in capsys.readouterr().err
    done = ready.run("pipeline.stages.ingest", raw / "a-01", "--out", raw / "samples.parquet")
    assert done.returncode == 0 and f"warning: {raw / 'a-01' / 'run.yaml'}: {question}" in done.stderr
