"""New runs: what ingest would refuse is refused at once, and a second run of one string is not taken for another's."""

import json
import math
import os
import pty
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import programs
import pytest
import yaml
from made_recording import content, recording

from pipeline.ground.errors import BadInput
from pipeline.ground.input.strict_yaml import read_yaml
from pipeline.new_run import main
from pipeline.new_run import make_run as new_folder
from pipeline.run.folder import read_run
from pipeline.run.option_mend import by_option
from pipeline.run.samples import read_samples

GOOD = recording()
SIZES = ["--radius-mm", "0.4", "--length-mm", "400", "--torsion-zone-mm", "150", "--separator-mm", "8"]


@pytest.fixture
def new(tmp_path, monkeypatch, capsys):
    """The program on a command line, under tmp_path/raw: its status and what it says on either stream."""

    def run(name, *more, samples=None, material="UHMWPE"):
        monkeypatch.setattr(sys, "argv", ["new_run", name, "--material", material, *SIZES, *more])
        sys.argv += ["--out", str(tmp_path / "raw")]
        if samples is not None:
            samples.to_csv(tmp_path / "log.csv", index=False)
            sys.argv += ["--recording", str(tmp_path / "log.csv")]
        with pytest.raises(SystemExit) as end:
            main()
        printed = capsys.readouterr()
        return end.value.code, printed.out, printed.err

    return run


def pasted(message):
    """The words of the command that a refusal ends with, on a line of its own, without the program."""
    words = shlex.split(message.splitlines()[-1])
    assert words[:3] == ["python", "-m", "pipeline.new_run"], message
    return words[3:]


def new_by(words):
    """What the program ends with on such words."""
    return programs.run("pipeline.new_run", *words).returncode


def spoiled(column, change):
    samples = GOOD.copy()
    samples[column] = change(samples[column].to_numpy(copy=True))
    return samples


def test_one_time_stamp_that_falls_back_is_mended_by_the_command_that_the_refusal_gives(new, tmp_path):
    samples = GOOD.rename(columns={"motor_turns": "it's turned"})
    samples.loc[100, "time_s"] -= 0.06
    channels = {"motor_turns": {"column": "it's turned", "scale": 1.0}}
    code, _, message = new("nylon-1", "--channels", json.dumps(channels), samples=samples)
    assert code == 2 and not (tmp_path / "raw").exists()
    recorded = tmp_path / "raw" / "nylon-2"
    recorded.mkdir(parents=True)
    (recorded / "run.yaml").write_text(yaml.safe_dump(content("nylon-2", channels=channels)))
    shutil.copy(tmp_path / "log.csv", recorded / "recording.csv")
    ingested = programs.run("pipeline.stages.ingest", "raw/nylon-2", "--out", "samples.parquet", cwd=tmp_path)
    for refusal, run in ((message, "nylon-1"), (ingested.stderr, "nylon-2-mended")):
        assert "time_s: runs backwards at line 102 (1 time in all). Mend: import it: " in refusal
        typed = refusal.partition("import it: ")[2].partition("; python -m pipeline.import_run mends")[0]
        mapped, _, imports = typed.partition(" && python -m ")
        subprocess.run(mapped, shell=True, check=True, cwd=tmp_path)
        imported = programs.run(*shlex.split(imports), cwd=tmp_path)
        assert imported.returncode == 0 and "mended 1 backward time stamp" in imported.stdout, imported
        _, read = read_samples(tmp_path / "raw" / run)
        assert len(read) == len(GOOD) and np.allclose(read["motor_turns"], GOOD["motor_turns"])


@pytest.mark.parametrize(
    ("samples", "says"),
    [
        (spoiled("time_s", lambda v: v[::-1]), "time_s: runs backwards"),
        (spoiled("displacement_mm", lambda v: np.where(v > 5, np.nan, v)), "displacement_mm: is not a number"),
        (spoiled("motor_turns", lambda v: v * 360), "it looks like deg"),
        (GOOD.drop(columns="motor_turns"), "there is no column 'motor_turns'"),
        (GOOD.iloc[:9], "holds 9 samples"),
        (spoiled("motor_turns", lambda v: v * 0), "no stroke in it"),
    ],
)
def test_a_recording_that_ingest_refuses_is_refused_and_nothing_written(new, tmp_path, samples, says):
    status, _, message = new("a-01", samples=samples)
    assert status == 2 and message.startswith("error: ") and says in message and "Mend: " in message
    assert not (tmp_path / "raw").exists()


def test_a_twist_far_from_0_needs_a_person_who_is_sure(new, tmp_path):
    far = spoiled("motor_turns", lambda v: v + 30)
    status, _, message = new("a-01", samples=far)
    assert status == 2 and "begins at 30 turns" in message and "if it is right as it is, add --sure" in message
    assert not (tmp_path / "raw").exists()
    status, _, message = new("a-01", "--sure", samples=far)
    assert status == 0 and "warning: " in message and "begins at 30 turns" in message
    status, _, _ = new("a-02", "--channels", "{motor_turns: {offset: -30}}", samples=far)
    assert status == 0  # the mend that was given
    assert read_samples(tmp_path / "raw" / "a-02")[1]["motor_turns"].to_numpy() == pytest.approx(GOOD["motor_turns"])


@pytest.mark.parametrize("sign", [1, -1])
def test_exchanged_columns_are_refused_with_the_option_that_reads_them_right(new, tmp_path, sign):
    """With the laser's sign turned as well, they were taken without a word."""
    samples = GOOD.rename(columns={"displacement_mm": "Laser [mm]"})
    samples["Kraft [N]"] = np.where(samples["time_s"] % 20 < 10, 18.0, 30.0)
    samples["Laser [mm]"] = 40 + sign * samples["Laser [mm]"]
    samples = samples.drop(columns="load_n")
    entry = "'Kraft [N]'" if sign > 0 else "{column: 'Kraft [N]', scale: -1}"
    channels = f"{{displacement_mm: {entry}, load_n: 'Laser [mm]'}}"
    status, _, message = new("a-01", "--channels", channels, samples=samples)
    assert status == 2 and "does not follow the twist as this string would" in message
    assert message.count("exchange the columns of displacement_mm and load_n: here by --channels ") == 1
    new_channels = shlex.split(message.rstrip(".\n").partition("here by --channels ")[2])[0]
    status, _, message = new("a-01", "--channels", new_channels, samples=samples)
    assert status == 0, message
    _, read = read_samples(tmp_path / "raw" / "a-01")
    assert set(read["load_n"]) == {18.0, 30.0}


def test_exchanged_columns_of_channels_that_are_called_so_are_named_in_the_option(new):
    samples = GOOD.assign(displacement_mm=20.0 + 0.2 * np.sin(GOOD["time_s"]), load_n=GOOD["displacement_mm"])
    status, _, message = new("a-01", "--channels", "{displacement_mm: {scale: 1}, load_n: {scale: 1}}", samples=samples)
    option = "'{displacement_mm: {scale: 1, column: load_n}, load_n: {scale: 1, column: displacement_mm}}'"
    assert status == 2 and f"here by --channels {option}" in message, message


def test_a_displacement_that_hardly_follows_the_twist_is_questioned(new):
    wave = 5 + 5 * np.sin(GOOD["time_s"] / 3)
    status, _, message = new("a-01", samples=GOOD.assign(displacement_mm=wave))
    assert status == 2 and "displacement_mm: hardly follows the twist: it differs from the curve of such a" in message
    assert "check which columns motor_turns and displacement_mm are read from" in message and "--sure" in message


def test_other_names_units_and_layouts_are_told_on_the_command_line(new, tmp_path):
    samples = GOOD.rename(columns={"motor_turns": "theta"})
    samples["theta"] *= 360
    channels = "{motor_turns: {column: theta, unit: deg}}"
    status, printed, message = new("a-01", "--channels", channels, "--file", '{comment: "%"}', samples=samples)
    assert status == 0, message
    most = samples["theta"].max() / 360
    assert printed.startswith(f"log.csv has {len(samples)} samples. They are read as:\n  time_s 0 to ")
    assert f"\n  motor_turns 0 to {most:.4g} (from theta in deg)\n  displacement_mm " in printed, "ranges in our units"
    assert "not read" not in printed
    assert max(map(len, printed.splitlines())) < 120 + len(str(tmp_path)), (
        "the next command was a line of 400 characters"
    )
    written = read_yaml(tmp_path / "raw" / "a-01" / "run.yaml")
    assert (
        written["channels"] == {"motor_turns": {"column": "theta", "unit": "deg"}} and written["file"]["comment"] == "%"
    )
    for text, says in [("{a: 1, a: 2}", "--channels: line 1: says 'a' a second time"), ("[", "is not YAML")]:
        status, _, message = new("a-02", "--channels", text, samples=samples)
        assert status == 2 and says in message


def test_the_folder_is_made_though_nobody_reads_what_is_said(tmp_path):
    """`new_run … | head -1` left no folder where Python does not hold back what it prints."""
    GOOD.to_csv(tmp_path / "log.csv", index=False)
    sizes = shlex.split("--material m --radius-mm 0.4 --length-mm 400 --torsion-zone-mm 150 --separator-mm 8")
    command = [sys.executable, "-um", "pipeline.new_run", "a-01", *sizes, "--recording", tmp_path / "log.csv"]
    reader, writer = os.pipe()
    os.close(reader)
    done = subprocess.run([*command, "--out", tmp_path / "raw"], stdout=writer, stderr=subprocess.PIPE, text=True)
    os.close(writer)
    assert done.stderr == "" and sorted(path.name for path in (tmp_path / "raw" / "a-01").iterdir()) == [
        "recording.csv",
        "run.yaml",
    ]


def test_columns_that_nothing_is_read_from_are_named(new, tmp_path):
    """A load in a column of another name was taken as 0 N, and no line said that the column is there."""
    status, printed, _ = new("a-01", samples=GOOD.drop(columns="load_n", errors="ignore").assign(pull=15.0))
    assert status == 0 and "\n  no load: taken as 0 N" in printed and "\n  not read: pull\n" in printed
    assert "is it" not in printed
    forced = GOOD.drop(columns="load_n", errors="ignore").assign(**{"Kraft [N]": 15.0})
    status, printed, _ = new("a-02", samples=forced)
    assert status == 0 and "if one hangs, name its column (is it Kraft [N]?) as load_n, or" in printed
    status, _, message = new("a-01", samples=GOOD)
    assert status == 2 and "remove that folder yourself if nobody needs it" in message


def test_a_stiffness_that_nobody_measured_is_left_out(new, tmp_path):
    assert new("a-01", samples=GOOD)[0] == 0
    run, _ = read_samples(tmp_path / "raw" / "a-01")
    assert run.string.stiffness_n_per_mm is None and run.string.nominal_stiffness_n_per_mm > 1


@pytest.mark.parametrize("value", ["nan", "inf", "-1", "0"])
def test_a_size_that_is_none_is_refused(new, tmp_path, value):
    status, _, message = new("a-01", "--stiffness-n-per-mm", value)
    assert status == 2 and "string.stiffness_n_per_mm" in message and not (tmp_path / "raw").exists()


def test_a_second_run_of_the_same_size_is_told_how_to_be_of_the_same_string(new, tmp_path):
    assert "note:" not in new("a-01", samples=GOOD)[2]
    assert "note:" not in new("n-01", samples=GOOD, material="nylon")[2]
    status, _, message = new("a-02", samples=GOOD)
    assert status == 0 and "counts as another string" in message and "--string-id a-01" in message
    status, _, message = new("a-03", "--string-id", "a-01", samples=GOOD)
    assert status == 0 and "note:" not in message
    assert read_run(tmp_path / "raw" / "a-03").string_id == read_run(tmp_path / "raw" / "a-01").string_id
    (tmp_path / "raw" / "a-02" / "run.yaml").write_text("no run")  # ingest's business
    assert "--string-id a-01" in new("a-04", samples=GOOD)[2]


@pytest.mark.parametrize(("answer", "same"), [("y", True), ("n", False)])
def test_on_a_terminal_it_asks_whether_it_is_the_same_string(tmp_path, answer, same):
    new_folder(content("a-01", string={**content("x")["string"], "id": "spool 3"}), None, tmp_path / "raw")
    command = [sys.executable, "-m", "pipeline.new_run", "a-02", "--material", "UHMWPE", *SIZES, "--out"]
    ours, theirs = pty.openpty()
    process = subprocess.Popen([*command, str(tmp_path / "raw")], stdin=theirs, stdout=theirs, stderr=theirs)
    os.close(theirs)
    os.write(ours, f"{answer}\n".encode())
    assert process.wait(300) == 0
    assert b"Is it the string 'spool 3'" in os.read(ours, 10_000)
    os.close(ours)
    assert read_run(tmp_path / "raw" / "a-02").string_id == ("spool 3" if same else "a-02")


@pytest.mark.parametrize("material", ["synthetic", "diagnosis", "real", "../x"])
def test_a_material_that_is_taken_is_refused(new, tmp_path, material):
    status, _, message = new("a-01", samples=GOOD, material=material)
    assert status == 2 and "string.material" in message and not (tmp_path / "raw").exists()


def test_what_was_recorded_before_it_was_described_is_checked_too(make_run, new):
    folder = make_run("a-01", spoiled("motor_turns", lambda v: v * 360))
    (folder / "run.yaml").unlink()
    status, _, message = new("a-01")
    assert status == 2 and "it looks like deg" in message and not (folder / "run.yaml").exists()
    assert new("a-01", "--channels", "{motor_turns: {unit: deg}}")[0] == 0
    assert "is there already" in new("a-01")[2]


def test_what_is_made_elsewhere_than_in_raw_is_not_handed_to_snakemake(new, tmp_path, monkeypatch):
    status, printed, _ = new("a-01", "--string-id", "s1", samples=GOOD)
    folder = tmp_path / "raw" / "a-01"
    assert status == 0 and f"\n{folder} is there.\nNext: " in printed
    alone = f"python -m pipeline.diagnose {folder} --out reports/mine"
    assert f"Next: diagnose it, as snakemake reads raw/ alone: {alone}\n" in printed
    monkeypatch.chdir(tmp_path)
    status, printed, _ = new("a-02", "--string-id", "s1", samples=GOOD)
    quick = "snakemake --cores 2 --configfile pipeline/config/ci.yaml -- reports/UHMWPE/index.html"
    small = f"quick, small fits that are no results: {quick}"
    readme = (Path(__file__).parent.parent / "README.md").read_text()
    assert quick.replace("UHMWPE", "nylon") in readme, "the README and the program say one command"
    both = f"{folder} {folder.with_name('a-02')} --together --out reports/mine/a-02"
    reports = [
        "make its reports: snakemake --cores 2",
        f"  {small}",
        "  or ask only what the simulator leaves out: python -m pipeline.diagnose",
    ]
    assert status == 0 and f"\nNext: {chr(10).join(reports)} {both}\n" in printed
    status, printed, _ = new("a-03", "--string-id", "s1")
    folder = folder.with_name("a-03")
    runs = " ".join(str(folder.with_name(f"a-0{number}")) for number in (1, 2, 3))
    assert status == 0 and printed.splitlines()[:6] == [
        f"{folder} is there; nothing is recorded in it yet.",
        f"Next: record into it: python -m pipeline.capture PORT {folder}",
        "  (add --text where the rig prints lines of numbers)",
        f"Then: {reports[0]}",
        *reports[1:2],
        f"{reports[2]} {runs} --together --out reports/mine/a-03",
    ]


def made_like(tmp_path, monkeypatch, capsys, *more):
    """`new_run a-02 --like raw/a-01 …`: its status, what it says, and the run.yaml that it wrote."""
    monkeypatch.setattr(sys, "argv", ["new_run", "a-02", "--like", str(tmp_path / "raw" / "a-01"), *more])
    with pytest.raises(SystemExit) as end:
        main()
    printed = capsys.readouterr()
    path = tmp_path / "raw" / "a-02" / "run.yaml"
    return end.value.code, printed.out + printed.err, read_yaml(path) if path.is_file() else None


def test_a_run_like_another_is_of_the_same_string_on_the_same_rig_but_for_what_is_given(
    new, tmp_path, monkeypatch, capsys
):
    assert new("a-01", "--strokes-before", "40", "--load-n", "20", samples=GOOD)[0] == 0
    path = tmp_path / "raw" / "a-01" / "run.yaml"
    path.write_text(path.read_text() + "tolerance: {radius: 0.05}\ntare: run\nmended: {time_s: 3}\n")
    before = read_yaml(path)
    status, printed, run_yaml = made_like(tmp_path, monkeypatch, capsys, "--load-n", "40")
    assert status == 0 and "note:" not in printed, printed
    both = f"{tmp_path / 'raw' / 'a-01'} {tmp_path / 'raw' / 'a-02'} --together --out reports/mine/a-02"
    assert f"python -m pipeline.diagnose {both}" in printed, "one string: both runs in one diagnosis"
    string = {key: value for key, value in before["string"].items() if key != "strokes_before"} | {"id": "a-01"}
    rig, tolerance = before["rig"] | {"load_n": 40.0}, before["tolerance"]
    assert run_yaml == {"run": "a-02", "actuator": "separator", "string": string, "rig": rig, "tolerance": tolerance}
    assert next(iter(run_yaml)) == "run"
    assert read_run(tmp_path / "raw" / "a-02").string_id == read_run(tmp_path / "raw" / "a-01").string_id
    assert "is there already" in made_like(tmp_path, monkeypatch, capsys)[1] and read_yaml(path) == before
    shutil.rmtree(tmp_path / "raw" / "a-02")
    path.write_text(path.read_text().replace("UHMWPE", "synthetic"))  # a run of the paper's rig
    assert "kept for the synthetic rig's own runs" in made_like(tmp_path, monkeypatch, capsys)[1]  # which made no CSV
    path.with_name("recording.csv").unlink()
    status, printed, run_yaml = made_like(tmp_path, monkeypatch, capsys)
    assert status == 0 and run_yaml["string"]["material"] == "synthetic", printed


@pytest.mark.parametrize(
    ("options", "begins"), [([], "warning: The zero jumps"), (["checked"], "note: At rest a-02 reads")]
)
def test_a_zero_that_was_checked_is_noted_and_not_warned_of(new, tmp_path, monkeypatch, capsys, options, begins):
    assert new("a-01", samples=GOOD)[0] == 0
    offset = GOOD.assign(displacement_mm=GOOD["displacement_mm"] + 3.0)
    offset.to_csv(tmp_path / "log.csv", index=False)
    words = ["--recording", str(tmp_path / "log.csv"), *(word for how in options for word in ("--tare", how))]
    status, printed, run_yaml = made_like(tmp_path, monkeypatch, capsys, *words)
    assert status == 0 and run_yaml.get("tare") == (options[0] if options else None), printed
    assert f"\n{begins}" in printed and ("warning: " in printed) == (not options)


def test_a_run_like_one_that_adopted_effects_says_that_it_has_them_too(new, tmp_path, monkeypatch, capsys):
    assert new("a-01", samples=GOOD)[0] == 0
    path = tmp_path / "raw" / "a-01" / "run.yaml"
    drift = "simulation:\n- {id: sensor_drift, parameters: {mm_per_hour: 1.0}}\n"
    path.write_text(path.read_text() + drift)
    status, printed, run_yaml = made_like(tmp_path, monkeypatch, capsys)
    assert status == 0 and run_yaml["simulation"][0]["id"] == "sensor_drift", printed
    assert "had adopted (sensor_drift). To take that out: python -m pipeline.adopt --remove " in printed


@pytest.mark.parametrize("more", [["--like", "a-01", "--string-id", "another"], ["--material", "nylon"]])
def test_a_name_that_no_run_may_have_is_refused_before_a_mend_repeats_it(new, tmp_path, monkeypatch, capsys, more):
    """The mend was a command with that name, which was then refused for the name."""
    assert new("a-01", samples=GOOD)[0] == 0
    monkeypatch.chdir(tmp_path / "raw")
    monkeypatch.setattr(sys, "argv", ["new_run", "vectran-B-01", *more])
    with pytest.raises(SystemExit) as end:
        main()
    message = capsys.readouterr().err
    assert end.value.code == 2 and "error: the command line: run: is 'vectran-B-01'. Mend: use lower-case" in message
    assert "run.yaml" not in message and "begin with a letter or a digit" in message, message
    assert "pipeline.new_run vectran-B-01" not in message and "--radius-mm" not in message, message


def test_a_run_like_another_of_which_another_string_is_given_is_refused(new, tmp_path, monkeypatch, capsys):
    channels = "{time_s: {column: t's, unit: s}, motor_turns: turns, displacement_mm: {column: mm, scale: -1}}"
    names = {"time_s": "t's", "motor_turns": "turns", "displacement_mm": "mm"}
    samples = GOOD.assign(displacement_mm=-GOOD["displacement_mm"]).rename(columns=names)
    with_tolerance = ["--tolerance", "{radius: 0.02}"]
    assert new("a-01", "--channels", channels, *with_tolerance, samples=samples)[0] == 0
    for option in (["--string-id", "spool 9"], ["--material", "nylon"]):
        recorded = ["--recording", str(tmp_path / "log.csv")]
        status, printed, run_yaml = made_like(tmp_path, monkeypatch, capsys, *option, *recorded)
        assert status == 2 and run_yaml is None and "is of the string a-01, of UHMWPE. Mend: for that string" in printed
        anew = shlex.split(printed.rpartition("for another one of its size: ")[2].strip().removesuffix("."))
        assert anew[:3] == ["python", "-m", "pipeline.new_run"]
        monkeypatch.setattr(sys, "argv", anew[2:])
        with pytest.raises(SystemExit) as end:
            main()
        words = capsys.readouterr()
        assert end.value.code == 0, words
        folder = tmp_path / "raw" / anew[3]
        run_yaml = read_yaml(folder / "run.yaml")
        assert run_yaml["string"]["radius_mm"] == 0.4 and option[1] in run_yaml["string"].values()
        assert run_yaml["channels"] == yaml.safe_load(channels) and run_yaml["tolerance"] == {"radius": 0.02}
        assert len(read_samples(folder)[1]) == len(GOOD)
        shutil.rmtree(folder)
    (tmp_path / "raw" / "a-01" / "run.yaml").unlink()
    assert made_like(tmp_path, monkeypatch, capsys)[0] == 2
    monkeypatch.setattr(sys, "argv", ["new_run", "a-03", "--material", "nylon"])
    with pytest.raises(SystemExit) as end:
        main()
    lacking = "are required without --like: --radius-mm, --length-mm, --torsion-zone-mm, --separator-mm; a rig without"
    assert end.value.code == 2 and lacking in capsys.readouterr().err


def test_a_rig_without_a_separator_is_told_its_actuator(new, monkeypatch, capsys):
    pair = ["a-01", "--material", "nylon", "--radius-mm", "0.4", "--length-mm", "400"]
    monkeypatch.setattr(sys, "argv", ["new_run", *pair])
    with pytest.raises(SystemExit) as end:
        main()
    message = capsys.readouterr().err
    assert end.value.code == 2 and "required without --like: --torsion-zone-mm, --separator-mm; " in message
    assert "a rig without a separator: --actuator twisted_pair" in message
    monkeypatch.setattr(sys, "argv", ["new_run", "--help"])
    with pytest.raises(SystemExit):
        main()
    words = " ".join(capsys.readouterr().out.split())
    assert "separator (default), or twisted_pair: two strings without a separator" in words


def test_a_load_of_nobody_is_said_to_be_taken_as_none(new):
    """Without a recording nothing said that a run without a load hangs under 0 N."""
    taken = "No load is given: where the recording has no channel load_n, it is taken as 0 N."
    assert taken in new("a-01")[1] and taken not in new("a-02", "--load-n", "20")[1]
    assert taken not in new("a-03", "--channels", "{load_n: {column: F, unit: N}}")[1]
    status, printed, _ = new("a-04", samples=GOOD.drop(columns="load_n", errors="ignore"))
    assert status == 0 and taken not in printed and "no load: taken as 0 N" in printed, printed


@pytest.mark.parametrize("name", ["Zeit [ms]", "Zeit (ms)"])
def test_a_name_that_ends_in_a_unit_in_brackets_is_read_in_it(new, tmp_path, name):
    """It was read in seconds: a run of a minute lasted 17 hours."""
    samples = GOOD.rename(columns={"time_s": name, "motor_turns": "turns (lap)"}).assign(**{name: GOOD["time_s"] * 1e3})
    channels = f"{{time_s: '{name}', motor_turns: 'turns (lap)'}}"
    status, printed, wrong = new("a-01", "--channels", channels, samples=samples)
    assert status == 0 and f"(from {name} in ms)" in printed, wrong
    read = read_samples(tmp_path / "raw" / "a-01")[1]
    assert read["time_s"].to_numpy() == pytest.approx(GOOD["time_s"].to_numpy())
    assert read["motor_turns"].to_numpy() == pytest.approx(GOOD["motor_turns"].to_numpy()), "lap is no unit"
    status, _, printed = new("a-02", "--channels", channels.replace("lap", "rev."), samples=samples)
    option = f"--channels {chr(34) if '[' in name else chr(39)}{{time_s: "
    assert option in printed and "'\"'" not in printed, printed
    assert new_by(pasted(printed)) == 0


@pytest.mark.parametrize(
    ("name", "kept"), [("log.txt", ".csv"), ("log.DAT", ".csv"), ("log.tsv.gz", ".csv.gz"), ("log.TXT.GZ", ".csv.gz")]
)
def test_a_text_of_any_usual_ending_is_kept_as_the_recording(new, tmp_path, name, kept):
    """A `.txt` was refused by its ending, though it was read as soon as somebody renamed it."""
    GOOD.to_csv(tmp_path / name, index=False, compression="gzip" if kept.endswith(".gz") else None)
    status, printed, message = new("a-01", "--recording", str(tmp_path / name))
    assert status == 0 and printed.startswith(f"{name} has {len(GOOD)} samples"), message
    assert (tmp_path / "raw" / "a-01" / f"recording{kept}").read_bytes() == (tmp_path / name).read_bytes()
    assert len(read_samples(tmp_path / "raw" / "a-01")[1]) == len(GOOD)


def test_a_column_given_by_its_name_alone_is_enough(new, tmp_path):
    samples = GOOD.rename(columns={"time_s": "t", "motor_turns": "turns", "displacement_mm": "slide_cm"})
    samples["slide_cm"] /= 10
    channels = "{time_s: t, motor_turns: turns, displacement_mm: slide_cm}"
    status, printed, wrong = new("a-01", "--channels", channels, samples=samples)
    assert status == 0, wrong
    assert "(from t)" in printed and "(from turns)" in printed and "(from slide_cm in cm)" in printed
    written = read_yaml(tmp_path / "raw" / "a-01" / "run.yaml")["channels"]
    assert written == {"time_s": "t", "motor_turns": "turns", "displacement_mm": "slide_cm"}
    read = read_samples(tmp_path / "raw" / "a-01")[1]
    assert read["displacement_mm"].to_numpy() == pytest.approx(GOOD["displacement_mm"].to_numpy())
    by_index = "{time_s: 0, motor_turns: 1, displacement_mm: {column: 2, unit: cm}}"
    assert new("a-02", "--channels", by_index, samples=samples)[0] == 0
    status, _, printed = new("a-03", "--channels", channels.replace(": turns", ": tunrs"), samples=samples)
    option = "--channels '{time_s: t, motor_turns: turns, displacement_mm: slide_cm, load_n: load_n}'"
    assert status == 2 and "there is no column 'tunrs'" in printed and option in printed
    status, _, printed = new("a-03", samples=samples.rename(columns={"slide_cm": "displacement_mm"}))
    assert (
        status == 2 and "time_s, motor_turns: there are no columns 'time_s' and 'motor_turns', only t, turns" in printed
    )
    likely = "{time_s: t, motor_turns: turns, displacement_mm: displacement_mm, load_n: load_n}"
    assert "Mend: say what the file looks like by the command below, and check it\n  python" in printed
    assert printed.endswith(f" --channels '{likely}'\n"), "a command on a line of its own"
    status, _, printed = new("a-03", samples=samples.rename(columns={"turns": "a", "slide_cm": "displacement_mm"}))
    assert "below, and fill in each … and check it\n" in printed
    assert "--channels '{time_s: t, motor_turns: …, displ" in printed
    status, _, printed = new("a-03", "--channels", "{motor_turns: [turns]}", samples=samples)
    assert status == 2 and "channels.motor_turns: is ['turns']" in printed and "or the column's name alone" in printed


@pytest.mark.parametrize(
    ("samples", "option"),
    [
        (GOOD.rename(columns={"motor_turns": "theta"}), "motor_turns: theta, "),
        (spoiled("motor_turns", lambda v: v * 360), "--channels '{motor_turns: {unit: deg}}'"),
    ],
)
def test_before_there_is_a_run_yaml_a_mend_names_the_option(new, samples, option):
    status, _, message = new("a-01", samples=samples)
    assert status == 2 and option in message and "run.yaml" not in message.partition("Mend: ")[2]


@pytest.mark.parametrize(("text", "option"), [
    (lambda csv: csv.replace(",", ";"), "--file '{delimiter: ;}'"),
    (lambda csv: csv.replace(",", "\t"), "--file '{delimiter: \"\\t\"}'"),
    (lambda csv: "Rig 7\nby somebody\n" + csv, "--file '{skip: 2}'"),
])  # fmt: skip
def test_an_option_is_whole_where_the_program_knows_the_answer(new, tmp_path, text, option):
    """It was printed with a gap, beside the answer."""
    file = tmp_path / "log.csv"
    file.write_text(text(GOOD.to_csv(index=False)))
    status, _, message = new("a-01", "--recording", str(file))
    assert status == 2 and message.endswith(f" {option}\n") and "…" not in message, message
    assert new_by(pasted(message)) == 0


@pytest.mark.parametrize("option", ["--file={decimal: .}", "--fil"])
def test_the_mend_for_another_layout_is_the_whole_command_as_it_was_typed(new, tmp_path, option):
    """It was options at the end of one very long line, to be put into the command by hand."""
    log = tmp_path / "it's a log.csv"
    log.write_text(GOOD.to_csv(index=False, sep=";"))
    words = [option] if "=" in option else [option, "{decimal: .}"]
    typed = ["--recording", str(log), "--string-id", "spool 3", *words]
    status, _, message = new("a-01", *typed)
    sentence, line = message.splitlines()
    assert status == 2 and sentence.endswith("check it") and len(sentence) < 300, message
    assert "decimal" not in line and shlex.split(line)[-2:] == ["--file", "{delimiter: ;}"], line
    assert new_by(pasted(message)) == 0
    assert read_run(tmp_path / "raw" / "a-01").string.id == "spool 3"


def test_the_whole_command_has_its_options_before_two_dashes(tmp_path):
    (tmp_path / "log.csv").write_text(GOOD.to_csv(index=False, sep=";"))
    words = ["--material", "UHMWPE", *SIZES, "--recording", "log.csv", "--", "a-01"]
    done = programs.run("pipeline.new_run", *words, cwd=tmp_path)
    assert done.returncode == 2 and done.stderr.endswith(" --file '{delimiter: ;}' -- a-01\n"), done.stderr
    assert programs.run("pipeline.new_run", *pasted(done.stderr), cwd=tmp_path).returncode == 0


def test_a_mend_for_the_command_line_keeps_what_was_given(new):
    samples = spoiled("motor_turns", lambda v: v * 360).rename(columns={"motor_turns": "theta"})
    samples["slide"] = samples.pop("displacement_mm")
    channels = "{motor_turns: {column: theta}, displacement_mm: {column: slide}}"
    status, _, message = new("a-01", "--channels", channels, samples=samples)
    mended = "{motor_turns: {column: theta, unit: deg}, displacement_mm: {column: slide}}"
    assert status == 2 and f"here by --channels '{mended}'" in message, message
    status, _, message = new("a-01", "--channels", mended, samples=samples)
    assert status == 0, message


@pytest.mark.parametrize(
    ("name", "factor", "unit", "ends"),
    [
        ("motor_turns", 360.0, "deg", r"\.\n"),
        ("motor_turns", math.tau, "rad", r"\.\n"),
        ("displacement_mm", 1e-3, "m", r"\.\n"),
        ("load_n", 1000.0 / 9.80665, "gf", "; else check radius_mm"),
    ],
)
def test_the_mend_of_a_unit_is_pasted_as_it_stands(new, tmp_path, name, factor, unit, ends):
    """It had a gap behind `unit:` beside the unit's name, and left out how the log is written."""
    samples = GOOD.assign(load_n=20.0).rename(columns={name: "seen"})
    samples["seen"] *= factor
    log = tmp_path / "rig.csv"
    log.write_text("Rig 7\n" + samples.to_csv(index=False, sep=";"))
    layout = ["--file", "{delimiter: ;, skip: 1}"]
    status, _, message = new("a-01", "--recording", str(log), *layout, "--channels", f"{{{name}: seen}}")
    option = re.search(f"here by (--channels .* --file .*'){ends}", message)
    assert status == 2 and option and f"unit: {unit}}}" in option[1] and "…" not in message, message
    status, _, message = new("a-01", "--recording", str(log), *shlex.split(option[1]))
    read = read_samples(tmp_path / "raw" / "a-01")[1]
    assert status == 0 and read[name].to_numpy() == pytest.approx(samples["seen"] / factor, abs=1e-6), message


def test_of_units_of_which_one_alone_is_right_the_option_has_none():
    """Written into one option, both were set."""
    mend = "find out which: set channels.motor_turns.unit to deg, or set channels.displacement_mm.unit to cm"
    mended = by_option(BadInput("log.csv", "motor_turns", "is odd", mend), {"run": "a-01"})
    assert mended.mend.endswith("here by --channels '{motor_turns: {unit: …}, displacement_mm: {unit: …}}'")


def test_every_option_of_new_run_says_what_it_is(monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", ["new_run", "--help"])
    with pytest.raises(SystemExit):
        main()
    words = " ".join(capsys.readouterr().out.split())
    assert "strokes done before its first recording; default: 0" in words
    assert "needed are the columns time_s, motor_turns, displacement_mm" in words and "contract" not in words


@pytest.mark.parametrize("columns", [80, 100])
def test_the_help_is_one_screen(monkeypatch, capsys, columns):
    monkeypatch.setenv("COLUMNS", str(columns))
    monkeypatch.setattr(sys, "argv", ["new_run", "--help"])
    with pytest.raises(SystemExit):
        main()
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) <= 38 and max(map(len, lines)) <= columns


def test_how_well_one_measured_is_said_on_the_command_line_or_asked_for(new, tmp_path):
    status, printed, _ = new("a-01", samples=GOOD)
    assert status == 0 and "How well you measured its dimensions belongs into its run.yaml, as `tolerance`" in printed
    status, printed, _ = new("b-01", "--tolerance", "{radius: 0.01, length_mm: 0.5}", samples=GOOD)
    assert status == 0 and "How well" not in printed
    written = yaml.safe_load((tmp_path / "raw" / "b-01" / "run.yaml").read_text())
    assert written["tolerance"] == {"radius": 0.01, "length_mm": 0.5}
    status, _, printed = new("c-01", "--tolerance", "{radius: much}", samples=GOOD)
    assert status == 2 and "tolerance" in printed and not (tmp_path / "raw" / "c-01").exists()


def test_a_tolerance_is_read_back_in_the_unit_of_what_it_belongs_to(new):
    _, printed, _ = new("a-01", "--tolerance", "{radius: 0.02, length_mm: 0.5}", samples=GOOD)
    assert "\n  radius 0.4 mm ± 0.008 mm (a share: 2 %)\n  separator 8 mm ± 0.5 mm (default)\n" in printed
    assert "\n  length 400 mm ± 0.5 mm\n  scale (gain of the sensor) 1 ± 0.005 (a share: 0.5 %, default)\n" in printed
    assert "\n  angle (zero of the motor) 0 turns ± 0.05 turns (default)\n" in printed, "an angle of what?"


@pytest.mark.parametrize(
    ("tolerance", "field", "mend"),
    [
        ("radius: 0.004", "radius: is 0.004, a share: 0.4 % of 0.4 mm, or ± 0.0016 mm", "0.01 if 0.004 mm was meant"),
        ("radius: 2", "radius: is 2, a share: 200 % of 0.4 mm, or ± 0.8 mm", "as 0.02 if 2 % was meant"),
        ("radius_mm: 0.02", "radius_mm: is not a known key", "write radius: 0.05, which is a share of 0.4 mm"),
        ("separator_mm: 3", "separator_mm: is 3 mm, 38% of 8 mm", "give tolerance.separator_mm in mm"),
        ("scale: 0.5", "scale: is 0.5, a share: 50 % of 1", "as 0.005 if 0.5 % was meant"),
    ],
)
def test_a_tolerance_that_is_likely_a_mistake_is_questioned(new, tmp_path, tolerance, field, mend):
    status, _, message = new("a-01", "--tolerance", f"{{{tolerance}}}")
    path = tmp_path / "raw" / "a-01" / "run.yaml"
    assert status == 2 and message.startswith(f"error: {path}: tolerance.{field}") and not path.exists(), message
    assert mend in message.partition("Mend: ")[2], message
    if "radius_mm" not in tolerance:
        key = tolerance.partition(":")[0]
        assert f"here by --tolerance '{{{key}: …}}'; if it is right as it is, add --sure" in message
        status, _, message = new("a-01", "--sure", "--tolerance", f"{{{tolerance}}}")
        assert status == 0 and "warning: " in message and field in message and path.exists()


def test_the_example_of_a_text_rig_with_other_names_and_units_is_taken_as_the_page_shows_it(tmp_path):
    page = (Path(__file__).parents[1] / "docs" / "record.md").read_text(encoding="utf-8")
    line = re.search(r"^python -m pipeline\.new_run nylon-20261121-03 .*?\}'$", page, re.MULTILINE | re.DOTALL)[0]
    _, option, program, name, *words = shlex.split(line.replace("\\\n", " "))
    assert (option, program) == ("-m", "pipeline.new_run")
    done = programs.run(program, name, *words, "--out", str(tmp_path))
    assert done.returncode == 0, done.stderr
    columns = {name: (channel.column, channel.unit) for name, channel in read_run(tmp_path / name).channels.items()}
    whole = {"time_s": ("t_ms", "ms"), "motor_turns": ("turns", None), "load_n": ("load", None)}
    assert columns == {**whole, "displacement_mm": ("disp", None)} and "`t_ms,turns,load,disp` first" in page


@pytest.mark.parametrize(
    ("channel", "name", "times", "unit"),
    [
        ("time_s", "ms", 1e3, "ms"),
        ("time_s", "millis", 1e3, "ms"),
        ("motor_turns", "deg", 360.0, "deg"),
        ("motor_turns", "rad", 2.0 * np.pi, "rad"),
        ("displacement_mm", "cm", 0.1, "cm"),
        ("load_n", "kgf", 1.0 / 9.80665, "kgf"),
        ("displacement_mm", "mm", 1.0, None),
        ("load_n", "N", 1.0, None),
        ("motor_turns", "u", 1.0, None),
    ],
)
def test_a_column_that_is_called_by_its_unit_alone_is_read_in_it(new, tmp_path, channel, name, times, unit):
    """`time_s: ms` was read in seconds: nothing said so before the end, and then only that it is no rate of a rig."""
    samples = GOOD.assign(load_n=20.0)
    samples[channel] *= times
    channels = f"{{{channel}: {name}}}"
    status, printed, wrong = new("a-01", "--channels", channels, samples=samples.rename(columns={channel: name}))
    assert status == 0 and f"(from {name}{f' in {unit}' if unit else ''})" in printed, wrong
    read = read_samples(tmp_path / "raw" / "a-01")[1]
    assert read[channel].to_numpy() == pytest.approx(samples[channel].to_numpy() / times)


@pytest.mark.parametrize(
    ("scale", "offset", "words"),
    [(-1, 0, "in mm, × -1"), (-1, 12, "in mm, × -1 + 12"), (1, -3, "in mm, - 3"), (1, 0, "")],
)
def test_what_is_done_to_a_columns_numbers_is_said(new, scale, offset, words):
    """Of a column whose sign was turned only `(from slide_mm)` was said."""
    samples = GOOD.assign(displacement_mm=(GOOD["displacement_mm"] - offset) * scale)
    channels = f"{{displacement_mm: {{column: slide_mm, scale: {scale}, offset: {offset}}}}}"
    status, printed, wrong = new(
        "a-01", "--channels", channels, samples=samples.rename(columns={"displacement_mm": "slide_mm"})
    )
    assert status == 0 and f"(from slide_mm{words and ' '}{words})" in printed, printed + wrong


def test_a_recording_that_another_run_has_is_said_to_be_that(new, tmp_path):
    """The same file as a second run of a string was taken without a word: its strokes counted twice."""
    named = ["--string-id", "spool-3"]
    assert "byte by byte" not in new("a-01", *named, samples=GOOD)[2]
    status, _, warned = new("a-02", *named, samples=GOOD)
    assert status == 0 and f"warning: {tmp_path / 'raw' / 'a-02'}: the recording is byte by byte that of a-01" in warned
    assert "of the same string: its strokes count twice there; if it is no second recording, remove" in warned
    warned = new("a-03", "--string-id", "spool-4", samples=GOOD)[2]
    assert "byte by byte that of a-01 and a-02; if it is no second recording" in warned
    assert "byte by byte" not in new("a-04", *named, samples=GOOD.assign(load_n=20.5))[2]
    assert "byte by byte" not in new("a-05", *named, "--file", "{rows: [0, 1500]}", samples=GOOD)[2], "other rows of it"
