"""`import_run --guess`: the mapping that it drafts imports the file once a person has filled in what is empty."""

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

from pipeline.ground.input.header_units import header_unit
from pipeline.run.samples import read_samples

ROOT = Path(__file__).parents[2]
GOOD = recording()
SIZES = {"material": "nylon", "radius_mm": 0.4, "length_mm": 400, "torsion_zone_mm": 150, "separator_mm": 8}
SIZES |= {"load_n": 20}


def program(*words, cwd):
    return programs.run("pipeline.import_run", *words, cwd=cwd)


def filled(text, **more):
    """A draft in which a person has written the sizes, and what else is asked for."""
    for key, value in {**SIZES, **more}.items():
        text = re.sub(rf"^( *{key}):  # fill in.*$", rf"\1: {value}", text, flags=re.M)
    assert "fill in:" not in text, text
    return text


def table(**columns):
    return pd.DataFrame(columns)


T, M, X = GOOD["time_s"], GOOD["motor_turns"], GOOD["displacement_mm"]
GERMAN = table(**{"Zeit [ms]": T * 1e3, "Drehwinkel (°)": M * 360, "Weg [mm]": -X, "Status": T * 0})
PLAIN = table(time=T, motor_angle=M * 2 * np.pi, motor_speed=M * 0 + 3, position=X / 10)
FORCED = table(t_us=T * 1e6, turns=-M, laser_cm=X / 10, force_gf=20 / 9.80665e-3 + T * 0)
STAMPS = pd.Timestamp("2026-11-23 23:59:58.5") + pd.to_timedelta(np.round(T, 6), unit="s")
DATES = table(timestamp=STAMPS, motor_deg=M * 360, position_mm=X)
DATED = DATES.assign(timestamp=STAMPS.dt.strftime("%Y-%m-%d %H:%M:%S.%f"))
CLOCK = table(**{"Uhrzeit": STAMPS.dt.strftime("%H:%M:%S,%f"), "Winkel [deg]": M * 360, "Weg [mm]": X})


def units_below(file):
    rows = [["t", "theta", "x"], ["s", "deg", "cm"], *np.column_stack([T, M * 360, X / 10]).tolist()]
    file.write_text("Rig 7\n" + "\n".join("\t".join(map(str, row)) for row in rows))


def commented(file):
    names = "operator: somebody\ntime [s],motor_angle [rad],motor_speed,position [cm]"
    np.savetxt(file, PLAIN, header=names, delimiter=",")


def lines_of_json(file):
    rows = PLAIN.rename(columns={"position": "pos_cm"}).to_dict("records")
    file.write_text("\n".join(map(json.dumps, rows)))


def of_sheets(file):
    rows = [["Rig 7"], [*GERMAN], *GERMAN.to_numpy().tolist()]
    workbook(file, notes=[["by somebody"]], data=rows)


MAKERS = {
    "german.csv": lambda f: f.write_text(
        "Messung am Prüfstand\n\n" + GERMAN.to_csv(sep=";", decimal=",", index=False), encoding="cp1252"
    ),
    "plain.csv": lambda f: PLAIN.rename(columns={"position": "position_cm"}).to_csv(f, index=False),
    "forced.txt": lambda f: FORCED.to_csv(f, index=False, sep=" "),
    "tabs.dat": units_below,
    "commented.txt": commented,
    "log.xlsx": of_sheets,
    "log.mat": lambda f: scipy.io.savemat(f, {"data": {"time": T, "theta_deg": M * 360, "x_mm": X, "gain": 3.0}}),
    "log.jsonl": lines_of_json,
    "log.parquet": lambda f: FORCED.to_parquet(f),
    "dates.csv": lambda f: DATED.to_csv(f, index=False),
    "clock.csv": lambda f: CLOCK.to_csv(f, sep=";", decimal=",", index=False),
    "dates.parquet": lambda f: DATES.to_parquet(f),
    "dates.jsonl": lambda f: f.write_text(DATED.to_json(orient="records", lines=True)),
}  # fmt: skip


@pytest.mark.parametrize("name", MAKERS)
def test_a_drafted_mapping_imports_the_file_once_the_sizes_are_filled_in(tmp_path, name):
    MAKERS[name](tmp_path / name)
    done = program("--guess", name, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "  # id: NAME  # of this very string" in done.stdout and "  # stiffness_n_per_mm: K" in done.stdout
    assert "  # strokes_before: 0" in done.stdout
    assert "its first rows, as they are read:" in done.stderr and "displacement_mm" in done.stderr
    (tmp_path / "map.yaml").write_text(filled(done.stdout), encoding="utf-8")
    done = program(name, "--map", "map.yaml", "--run", "a-01", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    read = read_samples(tmp_path / "raw" / "a-01")[1]
    assert read["time_s"].to_numpy() == pytest.approx(T.to_numpy())
    assert read["motor_turns"].to_numpy() == pytest.approx(M.to_numpy(), abs=1e-6)
    assert read["displacement_mm"].to_numpy() == pytest.approx(X.to_numpy(), abs=1e-6)
    if name in ("forced.txt", "log.parquet"):
        assert read["load_n"].to_numpy() == pytest.approx(20.0)


def test_what_no_name_tells_is_left_to_a_person(tmp_path):
    np.savetxt(tmp_path / "bare.csv", np.column_stack([T, M, X]), delimiter=",")
    done = program("--guess", "bare.csv", "--out", "map.yaml", cwd=tmp_path)
    assert done.returncode == 0 and "map.yaml: fill in what is empty" in done.stdout
    text = (tmp_path / "map.yaml").read_text()
    assert "time_s: {column: 0, unit: s}" in text and "column:  # fill in: one of 1, 2" in text
    done = program("bare.csv", "--map", "map.yaml", "--run", "a-01", cwd=tmp_path)
    assert done.returncode == 2 and "map.yaml: string.material, string.radius_mm," in done.stderr
    assert not (tmp_path / "raw").exists()
    done = program("--guess", "bare.csv", "--out", "map.yaml", cwd=tmp_path)
    assert done.returncode == 2 and "is there already" in done.stderr


def test_counts_and_guessed_units_are_said(tmp_path):
    table(t=T, encoder_counts=(M * 4096).round(), angle=M * 360, weg=X).to_csv(tmp_path / "a.csv", index=False)
    text = program("--guess", "a.csv", cwd=tmp_path).stdout
    assert "counts_per_turn:  # fill in: how many counts a turn has" in text
    assert "# check: the unit is a guess from its numbers" in text
    table(t=T, angle=M * 360, theta=M * 360, weg=X).to_csv(tmp_path / "b.csv", index=False)
    text = program("--guess", "b.csv", cwd=tmp_path).stdout
    assert "motor_turns: {column: angle, unit: deg}" in text and "theta may be meant as well" in text


@pytest.mark.parametrize("name", ["Last [kg]", "Kraft (kg)", "load_kg", "Gewicht in kg", "Last"])
def test_a_load_in_kg_is_drafted_as_kilograms_of_force_to_be_checked(tmp_path, name):
    columns = {"Zeit [s]": T, "Winkel [deg]": M * 360, "Weg [mm]": X, name: 2.0 + 0.1 * np.sin(T)}
    rows = [] if "kg" in name else [["s", "deg", "mm", "kg"]]
    lines = [";".join(columns), *(";".join(map(str, row)) for row in [*rows, *np.column_stack([*columns.values()])])]
    (tmp_path / "a.csv").write_text("\n".join(lines))
    done = program("--guess", "a.csv", cwd=tmp_path)
    assert re.search(r"load_n: \{column: .+, unit: kgf\} +# check: kg is taken as kilograms of force", done.stdout)
    assert "  load_n:  # fill in" not in done.stdout and "not read" not in done.stderr


@pytest.mark.parametrize(
    ("name", "draft"),
    [
        ("Kraft kgf", "{column: Kraft kgf, unit: kgf}"),
        ("Kraft kp", "{column: Kraft kp, unit: kgf}"),
        ("Zug gf", "{column: Zug gf, unit: gf}"),
        ("F kgf", "{column: F kgf, unit: kgf}"),
        ("Kraft N", "{column: Kraft N, unit: N}"),
    ],
)
def test_a_unit_after_a_space_is_the_columns_unit(tmp_path, name, draft):
    """Kraft kgf was asked for its unit, and F kgf was no load."""
    table(**{"Zeit ms": T * 1e3, "Winkel deg": M * 360, "Weg mm": X, name: 2.0 + 0.1 * np.sin(T)}).to_csv(
        tmp_path / "a.csv", index=False
    )
    text = program("--guess", "a.csv", cwd=tmp_path).stdout
    assert f"  load_n: {draft}\n" in text and "time_s: {column: Zeit ms, unit: ms}\n" in text
    assert "motor_turns: {column: Winkel deg, unit: deg}\n" in text
    assert "displacement_mm: {column: Weg mm, unit: mm}\n" in text


def test_a_letter_or_in_after_a_space_may_be_an_axis_or_an_input_and_is_no_unit():
    for name in ("angle A", "angle K", "slide in", "load m", "load C", "Kraft roh"):
        assert header_unit(name) is None, name


def test_a_column_called_f_is_the_load_and_is_asked_for_its_unit(tmp_path):
    """The command that was offered left F out, and wrote a run under 0 N."""
    log = tmp_path / "a.csv"
    table(t_ms=T * 1e3, turns=M, x_mm=X, F=30.0 + 0.1 * np.sin(T)).to_csv(log, index=False)
    sizes = ("--actuator", "twisted_pair", "--material", "nylon", "--radius-mm", 0.4, "--length-mm", 300)
    done = programs.run("pipeline.new_run", "a-01", *sizes, "--recording", log, cwd=tmp_path)
    assert done.returncode == 2 and "load_n: {column: F, unit: …}}'" in done.stderr, done.stderr
    assert "fill in each …" in done.stderr and not (tmp_path / "raw").exists()


def test_a_mass_in_kg_that_no_name_calls_a_load_is_none(tmp_path):
    columns = {"Zeit [s]": T, "Winkel [deg]": M * 360, "Weg [mm]": X, "Masse [kg]": 2.0 + 0.1 * np.sin(T)}
    table(**columns).to_csv(tmp_path / "a.csv", index=False)
    done = program("--guess", "a.csv", cwd=tmp_path)
    assert "load_n: {" not in done.stdout and "load_n:  # fill in" in done.stdout and "Masse" in done.stderr


def test_inches_and_a_column_called_by_its_unit_alone_are_read(tmp_path):
    """Weg [inch] was guessed to be in m, and a column newton was no load."""
    table(**{"ms": T * 1e3, "degrees": M * 360, "Weg [inch]": X / 25.4, "newton": 15 + 0 * T}).to_csv(
        tmp_path / "a.csv", index=False
    )
    text = program("--guess", "a.csv", cwd=tmp_path).stdout
    assert "displacement_mm: {column: 'Weg [inch]', unit: in}\n" in text, text
    assert "load_n: {column: newton, unit: N}\n" in text
    (tmp_path / "map.yaml").write_text(filled(text))
    done = program("a.csv", "--map", "map.yaml", "--run", "a-01", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    read = read_samples(tmp_path / "raw" / "a-01")[1]
    assert read["displacement_mm"].to_numpy() == pytest.approx(X.to_numpy(), abs=1e-6) and (read["load_n"] == 15).all()


@pytest.mark.parametrize("name", ["weg_in", "in", "count"])
def test_a_name_that_may_mean_an_input_or_a_count_tells_no_unit(tmp_path, name):
    table(t=T, theta=M * 360, position=X, **{name: X / 25.4}).to_csv(tmp_path / "a.csv", index=False)
    text = program("--guess", "a.csv", cwd=tmp_path).stdout
    assert "unit: in}" not in text and "motor_turns: {column: theta, unit: deg}" in text


def test_a_unit_in_the_header_that_gives_no_rate_of_a_rig_is_doubted(tmp_path):
    table(**{"Time [ms]": T, "theta_deg": M * 360, "x_mm": X}).to_csv(tmp_path / "a.csv", index=False)
    text = program("--guess", "a.csv", cwd=tmp_path).stdout
    assert re.search(
        r"time_s: \{column: 'Time \[ms\]', unit: s\} +# check: in ms, as its name says, it would have no", text
    )


def test_another_kind_of_rig_is_drafted_for(tmp_path):
    table(t=T, q_m=np.sin(T), motor_force=np.cos(T)).to_csv(tmp_path / "a.csv", index=False)
    text = program("--guess", "a.csv", "--actuator", "moving_mass", cwd=tmp_path).stdout
    assert "position_m: {column: q_m, unit: m}" in text and "column: motor_force" in text and "string:" not in text


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["--guess", "no.csv"], "no.csv: file: is not there"),
        (["--guess", "words.csv"], "Mend: "),
        (["--guess", "good.csv", "--actuator", "rope"], "use one of"),
        (["good.csv", "--run", "a"], "draft one with --guess"),
    ],
)
def test_what_cannot_be_guessed_is_refused_in_words(tmp_path, words, says):
    (tmp_path / "words.csv").write_text("a,b\nc,d\n")
    PLAIN.to_csv(tmp_path / "good.csv", index=False)
    done = program(*words, cwd=tmp_path)
    assert done.returncode == 2 and says in done.stderr, done.stderr
    assert done.stdout == ""


AXES = """
actuator: separator
rig: {torsion_zone_mm: 150, separator_mm: 8}
string: {material: nylon, radius_mm: 0.4, length_mm: 400}
channels: {time_s: {column: t}}
axes:
  left:
    channels: {motor_turns: {column: m1, unit: deg}, displacement_mm: {column: x1}}
  right:
    string: {material: UHMWPE}
    channels: {motor_turns: {column: m2}, displacement_mm: {column: x2, scale: -1}}
"""


@pytest.fixture
def two_axes(tmp_path):
    table(t=T, m1=M * 360, x1=X, m2=M, x2=-X).to_csv(tmp_path / "two.csv", index=False)
    (tmp_path / "map.yaml").write_text(AXES)
    return tmp_path


def test_a_file_with_several_axes_makes_a_run_of_each(two_axes):
    done = program("two.csv", "--map", "map.yaml", "--run", "a-01", cwd=two_axes)
    assert done.returncode == 0, done.stderr
    for axis, material in (("left", "nylon"), ("right", "UHMWPE")):
        run, read = read_samples(two_axes / "raw" / f"a-01-{axis}")
        assert run.string.material == material and run.string.radius_mm == 0.4
        assert read["motor_turns"].to_numpy() == pytest.approx(M.to_numpy())
        assert read["displacement_mm"].to_numpy() == pytest.approx(X.to_numpy())


def test_an_axis_may_name_its_column_alone_and_keep_the_unit_that_all_share(two_axes):
    shared = "channels: {time_s: t, displacement_mm: {scale: -1}}\naxes:"
    mapping = AXES.replace("channels: {time_s: {column: t}}\naxes:", shared)
    mapping = mapping.replace("{column: m2}", "m2").replace("{column: x2, scale: -1}", "x2")
    (two_axes / "map.yaml").write_text(mapping.replace("{column: x1}", "{column: x1, scale: 1}"))
    done = program("two.csv", "--map", "map.yaml", "--run", "a-01", cwd=two_axes)
    assert done.returncode == 0, done.stderr
    assert done.stdout.count("radius 0.4 mm ± 0.012 mm (a share: 3 %, default)") == 2
    _, read = read_samples(two_axes / "raw" / "a-01-right")
    assert read["displacement_mm"].to_numpy() == pytest.approx(X.to_numpy())


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (("x2, scale", "x9, scale"), "there is no column 'x9'"),
        (("  right:", "  Right:"), "axes.Right: cannot end a run's name"),
        (("string: {material: UHMWPE}", "run: b"), "axes.right.run: belongs to no axis"),
        (("  left:", "  left: 3\n  leftover:"), "axes.left: is 3"),
    ],
)
def test_one_bad_axis_writes_none(two_axes, change, says):
    (two_axes / "map.yaml").write_text(AXES.replace(*change))
    done = program("two.csv", "--map", "map.yaml", "--run", "a-01", cwd=two_axes)
    assert done.returncode == 2 and says in done.stderr, done.stderr
    assert not (two_axes / "raw").exists()


def test_every_field_that_a_person_left_empty_is_named_at_once(tmp_path):
    PLAIN.to_csv(tmp_path / "log.csv", index=False)
    assert program("log.csv", "--guess", "--out", "map.yaml", cwd=tmp_path).returncode == 0
    done = program("log.csv", "--map", "map.yaml", "--run", "a-1", cwd=tmp_path)
    text = (tmp_path / "map.yaml").read_text()
    fields = ["string.material", "string.radius_mm", "string.length_mm", "rig.torsion_zone_mm", "rig.separator_mm"]
    assert text.count("fill in:") >= len(fields) and done.returncode == 2
    assert f"map.yaml: {', '.join(fields)}" in done.stderr and "are empty. Mend: fill each in" in done.stderr
    assert done.stderr.count("\n") == 1 and not (tmp_path / "raw").exists()
    named = done.stderr.partition("map.yaml: ")[2].partition(": are empty")[0].split(", ")
    assert len(named) == text.count("fill in:"), done.stderr
    (tmp_path / "map.yaml").write_text(re.sub(r"^( *material):  # fill in.*$", r"\1: nylon", text, flags=re.M))
    message = program("log.csv", "--map", "map.yaml", "--run", "a-1", cwd=tmp_path).stderr
    assert "string.material" not in message and ", ".join(fields[1:]) in message


def test_a_guessed_actuator_is_marked_and_a_load_of_nobody_is_to_be_filled_in(tmp_path):
    """The actuator stood as if a file told it, and a load that was not found was 0 N without a mark."""
    PLAIN.to_csv(tmp_path / "log.csv", index=False)
    FORCED.to_csv(tmp_path / "forced.csv", index=False)
    alone = program("log.csv", "--guess", cwd=tmp_path).stdout
    guessed = (
        "# check: a guess; without a separator write twisted_pair, and take both lengths out of rig (if nothing is"
    )
    assert f"\nactuator: separator  {guessed} left: rig: {{}})\n" in alone, "a second draft had to be filled in again"
    assert re.search(r"^  load_n:  # fill in: the load in N .*, 0 for none; if a column has it, name it", alone, re.M)
    pair = program("log.csv", "--guess", "--actuator", "twisted_pair", "--out", "map.yaml", cwd=tmp_path)
    text = (tmp_path / "map.yaml").read_text()
    assert pair.returncode == 0 and "\nactuator: twisted_pair\n" in text
    assert re.search(r"^rig:\n  load_n:  # fill in: ", text, re.M) and "torsion_zone" not in text
    (tmp_path / "map.yaml").write_text(filled(text))
    done = program("log.csv", "--map", "map.yaml", "--run", "a-1", cwd=tmp_path)
    assert done.returncode == 0 and "taken as 0 N" not in done.stdout, done.stderr
    assert "load_n:  # fill in" not in program("forced.csv", "--guess", cwd=tmp_path).stdout, "a column has it"
    drive = program("log.csv", "--guess", "--actuator", "cable_drive", cwd=tmp_path).stdout
    assert "load_n" not in drive and "# check: a guess, as no" not in drive


def test_a_delimiter_that_ends_the_rows_of_numbers_alone_costs_no_names(tmp_path):
    """The draft had neither names nor units, and skipped the first rows."""
    rows = [f"{t:.6f}\t{m * 360:.6f}\t{x / 10:.6f}\t" for t, m, x in zip(T, M, X, strict=True)]
    (tmp_path / "a.txt").write_text("\n".join(["t [s]\tmotor [deg]\tx [cm]", *rows]) + "\n")
    text = program("--guess", "a.txt", cwd=tmp_path).stdout
    assert 'file: {delimiter: "\\t"}\n' in text and "motor_turns: {column: 'motor [deg]', unit: deg}" in text, text
    (tmp_path / "map.yaml").write_text(filled(text))
    done = program("a.txt", "--map", "map.yaml", "--run", "a-01", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert read_samples(tmp_path / "raw" / "a-01")[1]["motor_turns"].to_numpy() == pytest.approx(M.to_numpy(), abs=1e-6)


def test_a_few_lines_with_a_field_too_many_cost_themselves_and_are_named_by_the_draft_and_the_import(tmp_path):
    """One boot message of a microcontroller refused the whole file."""
    lines = table(time_s=T, motor_turns=M, x_mm=X).to_csv(index=False).splitlines()
    lines[57] += ",9"
    lines[70] = "nan," + lines[70].split(",", 1)[1]  # its line is told right below one that is no row
    (tmp_path / "a.csv").write_text("\n".join(lines) + "\n")
    done = program("--guess", "a.csv", cwd=tmp_path)
    assert done.returncode == 0 and "1 damaged line, which the import leaves out: line 71, 'nan," in done.stderr
    assert f"\n1 line with fields too many, which the import leaves out: line 58, '{lines[57]}'" in done.stderr
    (tmp_path / "map.yaml").write_text(filled(done.stdout))
    words = ("a.csv", "--map", "map.yaml", "--run", "a-01")
    done = program(*words, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert f"warning: a.csv: 1 line with fields too many left out: line 58, '{lines[57]}'\n" in done.stderr
    assert "a.csv: 1 damaged line left out: line 71, 'nan," in done.stderr
    read = read_samples(tmp_path / "raw" / "a-01")[1]
    assert read["motor_turns"].to_numpy() == pytest.approx(M.drop(index=[56, 69]).to_numpy())


def test_many_lines_with_a_field_too_many_are_refused_and_the_draft_says_so(tmp_path):
    lines = table(time_s=T, motor_turns=M, x_mm=X).iloc[:900].to_csv(index=False).splitlines()
    for row in range(57, 70):
        lines[row] += ",9"
    (tmp_path / "a.csv").write_text("\n".join(lines) + "\n")
    done = program("--guess", "a.csv", cwd=tmp_path)
    assert done.returncode == 0 and "but as it is the import will refuse it: a.csv: file: is not a" in done.stderr
    (tmp_path / "map.yaml").write_text(filled(done.stdout))
    words = ("a.csv", "--map", "map.yaml", "--run", "a-01")
    done = program(*words, cwd=tmp_path)
    assert done.returncode == 2 and "has 4 fields, its first line 'time_s,motor_turns,x_mm' has 3; so" in done.stderr
    assert "(line 58, " in done.stderr and "Mend: take the fields that are too many out of line 58 and" in done.stderr
    (tmp_path / "a.csv").write_text("\n".join([lines[0], *(f"{line},9" for line in lines[1:])]) + "\n")
    done = program(*words[:-1], "a-02", cwd=tmp_path)
    assert done.returncode == 2 and "more lines" in done.stderr and "Mend: check file.delimiter, file." in done.stderr


def test_damaged_rows_are_named_by_their_lines_and_what_the_import_does_about_them(tmp_path):
    """The draft said "3026 rows of 4 columns of numbers", and not a word of the damaged ones."""
    lines = ["Log 7", *GERMAN.to_csv(sep=";", decimal=",", index=False).splitlines()]
    lines[300], lines[400] = "75,0#;;7Ã9,;", "1,0;2"
    (tmp_path / "log.csv").write_text("\n".join(lines) + "\n")
    done = program("--guess", "log.csv", cwd=tmp_path)
    message = "2 damaged lines, which the import leaves out: line 301, '75,0#;;7Ã9,;'; line 401, '1,0;2'\n"
    assert done.returncode == 0 and message in done.stderr, done.stderr
    for row in range(500, 540):
        lines[row] = "1,0;off;2,0;0"
    (tmp_path / "log.csv").write_text("\n".join(lines) + "\n")
    done = program("--guess", "log.csv", cwd=tmp_path)
    many = "has no number in 41 of 2300 lines"
    assert many in done.stderr and "first in line 301, '75,0#;;7Ã9,;'. The import refuses it so" in done.stderr


def test_what_is_not_read_is_named_columns_of_words_and_lines_below_the_numbers_too(tmp_path):
    """A column of remarks and the foot of a file were passed over without a word."""
    german = GERMAN.assign(Bemerkung="", Zustand="OK").to_csv(sep=";", decimal=",", index=False)
    (tmp_path / "log.csv").write_text(german + "Ende der Messung;;;;;\nBediener: X;;;;;\n", encoding="cp1252")
    done = program("--guess", "log.csv", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    free = "not read:\n  Status: 0 to 0\n  Bemerkung: empty\n  Zustand: no numbers, but such as 'OK'\n"
    foot = "2 lines below the numbers, which the import leaves out: line 2302, 'Ende der Messung;;;;;'; line 2303, "
    assert free in done.stderr and foot in done.stderr, done.stderr


@pytest.mark.parametrize(
    ("unit", "column", "turn"),
    [
        ("deg", M * 360 % 360, "360"),
        ("rad", (M * 2 * np.pi + 3.0) % (2 * np.pi) - np.pi, "6.28319"),
        (None, np.floor(M % 1 * 4096), "a turn"),
    ],
)
def test_an_angle_that_wraps_is_told_by_the_draft_and_by_the_import(tmp_path, unit, column, turn):
    """The draft turned the sign of the displacement, and the import said that it falls while the motor winds."""
    file, mapping = tmp_path / "wrap.csv", tmp_path / "map.yaml"
    table(time_s=T, angle=column, displacement_mm=X).to_csv(file, index=False)
    done = program("--guess", file, cwd=tmp_path)
    mend = f"unwrap it in the file: from each jump down on add {turn}, from each jump up on take it off; numpy.unwrap("
    lines = [line for line in done.stdout.splitlines() if line.startswith("  motor_turns:")]
    assert done.returncode == 0 and len(lines) == 1 and f"goes on: it wraps; {mend}" in lines[0], done.stdout
    assert "scale" not in done.stdout and (unit is None or f"unit: {unit}}}" in lines[0])
    counts = "unit: count\n    counts_per_turn: 4096"
    mapping.write_text(filled(done.stdout.replace("unit:  # fill in: turns, rad, deg or count", counts)))
    done = program(file, "--map", mapping, "--run", "a-01", cwd=tmp_path)
    says = (
        "motor_turns: jumps by about 1 turn again and again and goes on: the angle wraps. Mend: unwrap it in the file: "
    )
    assert done.returncode == 2 and says in done.stderr and not (tmp_path / "raw").exists(), done.stderr


def test_an_angle_that_is_unwrapped_as_the_mend_says_is_imported(tmp_path):
    file, mapping = tmp_path / "log.csv", tmp_path / "map.yaml"
    table(time_s=T, angle=np.unwrap(M * 360 % 360, period=360), displacement_mm=X).to_csv(file, index=False)
    done = program("--guess", file, cwd=tmp_path)
    assert "wraps" not in done.stdout
    mapping.write_text(filled(done.stdout.replace("unit: rad", "unit: deg")))
    done = program(file, "--map", mapping, "--run", "a-01", cwd=tmp_path)
    assert done.returncode == 0 and (tmp_path / "raw" / "a-01").exists(), done.stderr


def test_a_load_in_kilonewtons_is_read_in_them_and_one_that_is_read_in_newtons_is_questioned(tmp_path):
    """`did you mean 'N' or 'K'?`: by that advice 20 to 40 N became 0.02 to 0.04 N, without a word."""
    columns = {"Zeit": T, "Winkel": M * 2.0 * np.pi, "Weg": X / 10.0, "Kraft": 0.02 + 1e-4 * np.sin(T)}
    rows = [["s", "rad", "cm", "kN"], *np.column_stack([*columns.values()])]
    (tmp_path / "a.csv").write_text("\n".join(";".join(map(str, row)) for row in [list(columns), *rows]))
    drafted = program("--guess", "a.csv", "--out", "map.yaml", cwd=tmp_path)
    text = (tmp_path / "map.yaml").read_text()
    assert drafted.returncode == 0 and "  load_n: {column: Kraft, unit: kN}\n" in text, text
    sizes = {"material": "nylon", "radius_mm": "0.4", "length_mm": "400", "torsion_zone_mm": "150", "separator_mm": "8"}
    for key, value in sizes.items():
        text = re.sub(rf"(?m)^(  {key}:).*$", rf"\1 {value}", text)
    (tmp_path / "map.yaml").write_text(text)
    done = program("a.csv", "--map", "map.yaml", "--run", "a-01", cwd=tmp_path)
    assert done.returncode == 0 and "(from Kraft in kN)" in done.stdout and "next to no" not in done.stderr, done.stderr
    assert read_samples(tmp_path / "raw" / "a-01")[1]["load_n"].mean() == pytest.approx(20.0, abs=0.1)
    (tmp_path / "map.yaml").write_text(text.replace("kN}", "N}"))
    done = program("a.csv", "--map", "map.yaml", "--run", "a-02", cwd=tmp_path)
    question = "load_n: is 0.0201 N at most, next to no load. Mend: kN? Then set channels.load_n.unit to 'kN'"
    assert done.returncode == 0 and question in done.stderr, done.stderr
