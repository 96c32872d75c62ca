"""`pipeline.mend`: the mend that a message names is made by its command, and nothing else in run.yaml changes."""

import json
import re
import shlex

import ready
import yaml
from made_recording import content, recording

GOOD = recording()
TEXT = """# the rig of the cellar
run: run-1
string: {material: UHMWPE, radius_mm: 0.4, length_mm: 400, stiffness_n_per_mm: 15}  # by caliper
rig:
  torsion_zone_mm: 150
  separator_mm: 8

channels:  # as the logger calls them
  time_s: t
  motor_turns: {column: theta, unit: turns}  # the encoder
  displacement_mm: laser
# end
"""
NAMES = {"time_s": "t", "motor_turns": "theta", "displacement_mm": "laser"}


def run_of(tmp_path, samples, text=TEXT):
    folder = tmp_path / "run-1"
    folder.mkdir()
    samples.to_csv(folder / "recording.csv", index=False)
    (folder / "run.yaml").write_text(text, newline="")
    return folder


def told(folder) -> list[str]:
    """The words of the one command that the message of ingest names."""
    done = ready.run("pipeline.stages.ingest", folder, "--out", folder.parent / "samples.parquet")
    assert done.returncode == 2, done
    (command,) = re.findall(r"\(python -m pipeline\.mend ([^()]*)\)", done.stderr)
    return shlex.split(command)


def assert_usable(folder) -> None:
    done = ready.run("pipeline.stages.ingest", folder, "--out", folder.parent / "samples.parquet")
    assert done.returncode == 0 and "3 strokes" in done.stdout and not done.stderr, done


def test_a_wrong_sign_is_mended_by_the_command_of_its_message_and_comments_stay(tmp_path):
    samples = GOOD.assign(displacement_mm=-GOOD["displacement_mm"]).rename(columns=NAMES)
    folder = run_of(tmp_path, samples)
    words = told(folder)
    assert words == [str(folder), "channels.displacement_mm.scale=-1"]
    done = ready.run("pipeline.mend", *words)
    first = f"{folder}/run.yaml: channels.displacement_mm.scale is -1 now and was not there.\n"
    assert done.returncode == 0 and done.stdout.startswith(f"{first}All else in it stays as it was.\n"), done
    assert "It can be used: 2300 samples, 3 strokes.\nNext: diagnose it" in done.stdout
    changed = TEXT.replace("displacement_mm: laser\n", "displacement_mm: {column: laser, scale: -1}\n")
    assert (folder / "run.yaml").read_text() == changed
    assert_usable(folder)
    again = ready.run("pipeline.mend", *words)
    assert again.returncode == 2 and "says that already (channels.displacement_mm.scale: -1)" in again.stderr
    assert (folder / "run.yaml").read_text() == changed


def test_a_wrong_unit_is_mended_where_it_stands(tmp_path):
    samples = GOOD.assign(motor_turns=GOOD["motor_turns"] * 360).rename(columns=NAMES)
    folder = run_of(tmp_path, samples)
    assert ready.run("pipeline.mend", *told(folder)).returncode == 0
    assert (folder / "run.yaml").read_text() == TEXT.replace("unit: turns}", "unit: deg}")
    assert_usable(folder)


def test_exchanged_columns_are_exchanged_in_run_yaml_whether_it_names_them_or_not(tmp_path):
    exchanged = GOOD.assign(motor_turns=GOOD["displacement_mm"] + 5.0, displacement_mm=GOOD["motor_turns"])
    folder = run_of(tmp_path, exchanged.rename(columns=NAMES))
    words = told(folder)
    assert words == [str(folder), "--exchange", "motor_turns", "displacement_mm"]
    assert ready.run("pipeline.mend", *words).returncode == 0
    assert (folder / "run.yaml").read_text() == TEXT.replace("theta, u", "laser, u").replace(": laser\n", ": theta\n")
    assert_usable(folder)
    (tmp_path / "bare").mkdir()
    bare = run_of(tmp_path / "bare", exchanged, yaml.safe_dump(content("run-1")))
    assert ready.run("pipeline.mend", *told(bare)).returncode == 0
    channels = yaml.safe_load((bare / "run.yaml").read_text())["channels"]
    assert channels == {"motor_turns": {"column": "displacement_mm"}, "displacement_mm": {"column": "motor_turns"}}
    assert_usable(bare)


def test_a_channel_that_its_column_s_name_tells_keeps_column_and_unit(tmp_path):
    """The displacement is read from displacement_cm, in cm, without a word in run.yaml."""
    samples = GOOD.assign(displacement_cm=GOOD["displacement_mm"] / -10).drop(columns="displacement_mm")
    folder = run_of(tmp_path, samples, json.dumps(content("run-1")))
    words = re.search(
        r"\(python -m pipeline\.mend (.*)\)",
        ready.run("pipeline.stages.ingest", folder, "--out", tmp_path / "samples.parquet").stderr,
    )[1]
    assert ready.run("pipeline.mend", *shlex.split(words)).returncode == 0
    entry = {"column": "displacement_cm", "unit": "cm", "scale": -1}
    assert json.loads((folder / "run.yaml").read_text()) == content("run-1", channels={"displacement_mm": entry})


def test_a_tare_is_added_and_ends_of_lines_stay(tmp_path):
    text = TEXT.replace("\n", "\r\n")
    folder = run_of(tmp_path, GOOD.rename(columns=NAMES), text)
    done = ready.run("pipeline.mend", folder, "tare=run")
    assert done.returncode == 0 and "tare is run now and was not there" in done.stdout, done
    changed = (folder / "run.yaml").read_bytes().decode()
    assert changed == text.replace("laser\r\n", "laser\r\ntare: run\r\n")


def test_what_run_yaml_may_not_say_is_refused_and_nothing_is_written(tmp_path):
    folder = run_of(tmp_path, GOOD.rename(columns=NAMES))
    for words, says in (
        (["tare=maybe"], "tare: "),
        (["channels.displacement_mm.factor=2"], "channels.displacement_mm.factor"),
        (["channels.displacement_mm.scale=fast"], "channels.displacement_mm.scale"),
        (["run=other"], "run: is nothing that is changed here. Mend: "),
        (["simulation=[]"], "simulation: is nothing that is changed here. Mend: "),
        (["string.radius_mm=-1"], "string.radius_mm"),
        (["tare"], "the command line: tare: says no value of a key"),
        (["--exchange", "motor_turns", "laser"], "--exchange: laser: is not a known channel"),
    ):
        done = ready.run("pipeline.mend", folder, *words)
        assert done.returncode == 2 and says in done.stderr and "Traceback" not in done.stderr, done
    assert (folder / "run.yaml").read_text() == TEXT
    anchored = TEXT.replace("radius_mm: 0.4", "radius_mm: &x 0.4").replace("150", "*x")
    (folder / "run.yaml").write_text(anchored)
    done = ready.run("pipeline.mend", folder, "rig.torsion_zone_mm=140")
    assert done.returncode == 2 and "cannot be changed without changing other text" in done.stderr, done
    assert (folder / "run.yaml").read_text() == anchored


def test_what_is_still_wrong_after_a_mend_is_said_with_its_own(tmp_path):
    samples = GOOD.assign(displacement_mm=-GOOD["displacement_mm"], time_s=GOOD["time_s"] * 1000).rename(columns=NAMES)
    folder = run_of(tmp_path, samples)
    done = ready.run("pipeline.mend", *told(folder))
    assert "channels.time_s.unit is ms now" in done.stdout and done.returncode == 2, done
    assert f"(python -m pipeline.mend {folder} channels.displacement_mm.scale=-1)" in done.stderr, done
