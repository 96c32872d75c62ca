import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from made_recording import content

from pipeline.ground.errors import BadInput
from pipeline.run.description import Channel, Run, String, TextFile, parse_run
from pipeline.run.folder import find_runs, read_run, recording_path
from pipeline.run.run_yaml import ChannelYaml, FileYaml, RunYaml, StringYaml
from pipeline.run.samples import read_samples

PLACE = Path("raw/a-01/run.yaml")


def without(section, key):
    whole = content("a-01")
    whole[section] = {name: value for name, value in whole[section].items() if name != key}
    return whole


def changed(section, **changes):
    whole = content("a-01")
    return {**whole, section: {**whole.get(section, {}), **changes}}


def test_a_good_run_is_taken_as_written():
    run = parse_run(content("a-01"), PLACE)
    assert (run.actuator, run.string.material, run.rig["separator_mm"]) == ("separator", "UHMWPE", 8.0)
    assert run.string_id == "a-01"
    assert parse_run(changed("string", id="spool-3"), PLACE).string_id == "spool-3"


@pytest.mark.parametrize(
    ("bad", "field", "mend"),
    [
        (changed("string", raduis_mm=1), "string.raduis_mm", "did you mean 'radius_mm'"),
        (changed("string", colour="red"), "string.colour", "known are material"),
        (without("string", "radius_mm"), "string.radius_mm", "radius of one string in mm"),
        (without("string", "material"), "string.material", "add it"),
        (without("rig", "separator_mm"), "rig.separator_mm", "add the length in mm"),
        (without("rig", "torsion_zone_mm"), "rig.torsion_zone_mm", "add the length in mm"),
        (
            {**content("a-01"), "rig": {}},
            "rig.torsion_zone_mm, rig.separator_mm",
            "add the length in mm that you measured",
        ),
        (changed("rig", torsion_zone=150), "rig.torsion_zone", "did you mean 'torsion_zone_mm'"),
        ({**content("a-01"), "rig": {"torsion_zone_mm": 150, "seperator_mm": 8}}, "rig.seperator_mm", "'separator_mm'"),
        (changed("string", radius_mm=True), "string.radius_mm", "radius of one string in mm"),
        (changed("rig", load_n=-3), "rig.load_n", "that was measured"),
        (changed("tolerance", radius_mm=0.1), "tolerance.radius_mm", "write radius: 0.25, which is a share of 0.4 mm"),
        (changed("string", radius_mm="thick"), "string.radius_mm", "radius of one string in mm"),
        (changed("string", radius_mm=0), "string.radius_mm", "correct it"),
        (changed("string", length_mm=float("nan")), "string.length_mm", "correct it"),
        (changed("string", material="../etc"), "string.material", "use letters, digits, _ and -"),
        (changed("string", material="diagnosis"), "string.material", "give another name"),
        (changed("string", material=304), "string.material", "put it in quotes"),
        (changed("string", id="../../x"), "string.id", "write it with letters, digits, spaces"),
        (changed("string", id="/etc/x"), "string.id", "write it with letters, digits, spaces"),
        (changed("string", id="x" * 300), "string.id", "at most 100"),
        (changed("string", strokes_before=10**30), "string.strokes_before", "strokes that the string had done"),
        (changed("string", radius_mm=1e-300), "string.radius_mm", "radius of one string in mm"),
        (changed("string", stiffness_n_per_mm=0), "string.stiffness_n_per_mm", "left out or null"),
        (changed("string", radius_mm="2026-11-22"), "string.radius_mm", "radius of one string in mm"),
        (changed("string", radius_mm="5:00"), "string.radius_mm", "radius of one string in mm"),
        (changed("file", delimiter="\n"), "file.delimiter", "one character"),
        (changed("file", delimiter="\r"), "file.delimiter", "one character"),
        (changed("file", delimiter="§"), "file.delimiter", "one character"),
        (changed("file", delimiter="1"), "file.delimiter", "one character"),
        (changed("file", comment="-"), "file.comment", "such as %"),
        (changed("file", encoding="a\0b"), "file.encoding", "utf-8, or utf-16"),
        (changed("file", encoding="undefined"), "file.encoding", "utf-8, or utf-16"),
        (changed("file", encoding="punycode"), "file.encoding", "utf-8, or utf-16"),
        (changed("file", encoding="base64"), "file.encoding", "utf-8, or utf-16"),
        (content("a-01", simulation=[{"id": [1]}]), "simulation.0.id", "correct it"),
        (content("a-01", simulation=[{"parameters": {}}]), "simulation.0.id", "add it"),
        (
            content("a-01", simulation=[{"id": "x", "parameters": {"a": float("nan")}}]),
            "simulation.0.parameters.a",
            "c",
        ),
        (changed("channels", motor_turns={"column": "a\nb"}), "channels.motor_turns.column", "letters, digits"),
        (changed("channels", motor_turns={"column": True}), "channels.motor_turns.column", "correct it"),
        (changed("channels", motor_turns={"column": [1]}), "channels.motor_turns.column", "correct it"),
        ({**content("a-01"), "x" * 10**6: 1}, "'" + "x" * 27 + "..." + "x" * 28 + "'", "known are"),
        ({**content("a-01"), "a\nerror: b": 1}, r"'a\nerror: b'", "known are"),
        ({**content("a-01"), "rig": {"a: b; c": 1}}, "rig.a", ""),
        (changed("channels", motor_turns={"colum": 1}), "channels.motor_turns.colum", "did you mean 'column'"),
        (changed("string", radius_mm="0300"), "string.radius_mm", "plain number"),
        (changed("string", radius_mm="1_0"), "string.radius_mm", "plain number"),
        (
            changed("string", radius_mm="0,45"),
            "string.radius_mm",
            "a plain number with a point, not a comma, such as 0.45",
        ),
        (changed("string", strokes_before="1_0"), "string.strokes_before", "plain number"),
        (content("a-01", string=None), "string", "add the string's material"),
        (content("a-01", actuator="winch"), "actuator", "use one of cable_drive"),
        (content("a-01", run=None), "run", "add it"),
        (content("a-02"), "run", "make both the same"),
        ({**content("a-01"), "runn": "x"}, "runn", "did you mean 'run'"),
        ("not a mapping", "run.yaml", "as the README shows"),
    ],
)
def test_a_bad_run_names_file_field_and_mend(bad, field, mend):
    with pytest.raises(BadInput) as error:
        parse_run(bad, PLACE)
    assert error.value.field == field
    assert str(error.value).startswith(f"raw/a-01/run.yaml: {field}: ")
    assert mend in str(error.value)


@pytest.mark.parametrize(
    ("radius_mm", "says"),
    [
        (0, "is 0: must be more than 0. Mend: correct it (radius"),
        ("-0.4", "is '-0.4': must be more than 0. Mend: correct it (radius"),
        (1e-12, "is 1e-12: must be 1e-09 or more. "),
        (2e9, "is 2000000000.0: must be 1e+09 or less. "),
        (float("nan"), "is nan: must be a finite number. "),
        (-int("9" * 400), "is -999"),
    ],
)
def test_a_dimension_beyond_its_limit_is_refused_in_the_words_of_a_lab(radius_mm, says):
    """It said `Input should be greater than or equal to 0.000000001`."""
    with pytest.raises(BadInput) as error:
        parse_run(changed("string", radius_mm=radius_mm), PLACE)
    assert f"string.radius_mm: {says}" in str(error.value)


def test_a_count_may_be_0_but_no_less():
    with pytest.raises(BadInput, match="must be 0 or more"):
        parse_run(changed("string", strokes_before=-1), PLACE)


def test_a_stiffness_that_nobody_measured_is_the_usual_one():
    for run in (without("string", "stiffness_n_per_mm"), changed("string", stiffness_n_per_mm=None)):
        string = parse_run(run, PLACE).string
        assert string.stiffness_n_per_mm is None
        assert string.nominal_stiffness_n_per_mm == pytest.approx(7000 * 3.14159 * 0.4**2 / 400, rel=1e-3)
    assert parse_run(content("a-01"), PLACE).string.nominal_stiffness_n_per_mm == 15


def test_aliases_in_known_keys_are_no_hang():
    nested = ["x"]
    for _ in range(60):
        nested = [nested] * 9
    with pytest.raises(BadInput) as error:
        parse_run(changed("string", radius_mm=nested), PLACE)
    assert error.value.field == "string.radius_mm" and len(str(error.value)) < 500


def test_a_key_of_a_run_stands_once(make_run):
    folder = make_run("a-01")
    with open(folder / "run.yaml", "a") as file:
        file.write("rig: {}\n")
    with pytest.raises(BadInput, match="says 'rig' a second time"):
        read_run(folder)


def test_the_synthetic_rigs_material_is_refused_for_other_recordings(make_run):
    folder = make_run("a-01", string={"material": "synthetic", "radius_mm": 0.4, "length_mm": 400})
    with pytest.raises(BadInput, match=r"string.material: .* kept for the synthetic rig's own runs"):
        read_run(folder)
    (folder / "recording.parquet").unlink()
    assert read_run(folder).string.material == "synthetic"  # the rig describes the run first, then records
    (folder / "capture.json").write_text('{"hello": {"device": "twistbench synthetic rig"}}')
    assert read_run(folder).string.material == "synthetic"
    (folder / "capture.json").write_text('{"hello": {"device": "mine"}}')
    with pytest.raises(BadInput, match="synthetic"):
        read_run(folder)


def test_a_twisted_pair_needs_no_separator():
    run = parse_run(content("a-01", actuator="twisted_pair", rig=None), PLACE)
    assert run.rig == {}


def test_a_rig_without_string():
    run = parse_run({"run": "a-01", "actuator": "moving_mass", "rig": {"mass_kg": 95.0}}, PLACE)
    assert run.string is None


@pytest.mark.parametrize(
    ("text", "says"), [("a: [1", "is not YAML"), (b"\xff\xfe", "is not UTF-8"), (None, "is missing")]
)
def test_an_unreadable_run(tmp_path, text, says):
    if text is not None:
        (tmp_path / "run.yaml").write_bytes(text.encode() if isinstance(text, str) else text)
    with pytest.raises(BadInput, match=says):
        read_run(tmp_path)


def test_recording_must_be_one_and_finished(make_run):
    folder = make_run("a-01")
    assert recording_path(folder).name == "recording.parquet"
    (folder / "recording.csv").write_text("x")
    with pytest.raises(BadInput, match="more than once"):
        recording_path(folder)
    (folder / "recording.csv").unlink()
    (folder / "recording.parquet").rename(folder / "recording.frames")
    with pytest.raises(BadInput, match=r"capture\.json: is missing, so the recording is unfinished"):
        recording_path(folder)
    (folder / "recording.frames").rename(folder / "recording.lines")
    for present_files in ((), ("recording.csv",)):  # killed before, and while, the lines became a table
        for name in present_files:
            (folder / name).write_text("x")
        with pytest.raises(BadInput, match=r"is unfinished. Mend: wait .* python -m pipeline.capture --recover .*a-01"):
            recording_path(folder)
        assert list(find_runs(folder.parent)) == [folder]
    (folder / "capture.json").write_text("{}")
    assert recording_path(folder).name == "recording.csv"
    for name in ("recording.lines", "recording.csv", "capture.json"):
        (folder / name).unlink()
    with pytest.raises(BadInput, match="recording: is missing"):
        recording_path(folder)


def test_runs_are_found_sorted_and_hidden_ones_left_out(make_run, tmp_path):
    for name in ("b-01", "a-01", ".half"):
        make_run(name)
    (tmp_path / "raw" / "empty").mkdir()
    assert [folder.name for folder in find_runs(tmp_path / "raw")] == ["a-01", "b-01"]


def test_a_key_that_stands_twice_is_named_with_its_line(tmp_path):
    folder = tmp_path / "a-01"
    folder.mkdir()
    (folder / "run.yaml").write_text("run: a-01\nstring: {material: x}\nrig:\n  load_n: 20\n  load_n: 30\n")
    with pytest.raises(BadInput, match=r"line 5: says 'load_n' a second time"):
        read_run(folder)


@pytest.mark.parametrize(
    ("written", "checked"), [(RunYaml, Run), (StringYaml, String), (ChannelYaml, Channel), (FileYaml, TextFile)]
)
def test_the_types_of_run_yaml_have_the_keys_that_are_checked(written, checked):
    assert set(written.__annotations__) == set(checked.model_fields)


@pytest.mark.parametrize("field", ["gaps", "holes"])
@pytest.mark.parametrize(
    "edited", ["null", "[null]", "[{}]", '"x"', "5", '[{"after_samples": "3"}]', '[{"after_samples": 1e99}]']
)
def test_losses_that_were_edited_are_refused(make_run, tmp_path, field, edited):
    folder = make_run("a-01")
    (folder / "capture.json").write_text(f'{{"{field}": {edited}}}')
    with pytest.raises(BadInput) as refused:
        read_samples(folder)
    assert refused.value.file == str(folder / "capture.json") and refused.value.field == field


def test_a_program_whose_reader_left_ends_quietly(make_run):
    folder = make_run("a-01")
    words = ["pipeline.stages.ingest", str(folder), "--out", str(folder.parent / "samples.parquet")]
    reads, writes = os.pipe()
    os.close(reads)  # as `| true` does
    done = subprocess.run([sys.executable, "-m", *words], stdout=writes, stderr=subprocess.PIPE, text=True)
    os.close(writes)
    assert done.returncode == 128 + signal.SIGPIPE and done.stderr == "", done.stderr
