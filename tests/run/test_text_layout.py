"""A logger's own layout of a text file: read in one command, and every message leads to the next step."""

import re

import numpy as np
import programs
import pytest
from made_recording import recording

from pipeline.run.samples import read_samples

GOOD = recording()
SIZES = ["--radius-mm", "0.4", "--length-mm", "400", "--torsion-zone-mm", "150", "--separator-mm", "8"]
CHANNELS = "time_s: {column: Zeit}, motor_turns: {column: Winkel}, displacement_mm: {column: Weg}"


@pytest.fixture
def log(tmp_path):
    """A German logger's file: two title lines, names, decimal commas, grams, and a last line that was cut off."""
    table = GOOD.rename(columns=dict(zip(GOOD.columns, ("Zeit", "Winkel", "Weg", "Last"), strict=True)))
    table["Last"] = GOOD["load_n"] / 9.80665e-3
    text = "Messung 7; Kanal A\nStart: 22.11.2026 10:15\n" + table.to_csv(None, sep=";", decimal=",", index=False)
    path = tmp_path / "log.csv"
    path.write_text(text + "99,04;0,1")
    return path


def new(log, *more):
    words = ["a-01", "--material", "UHMWPE", *SIZES, "--recording", log, "--out", log.parent / "raw", *more]
    return programs.run("pipeline.new_run", *words)


def test_a_german_loggers_file_takes_one_command(log):
    file = '{delimiter: ";", skip: 2, decimal: ","}'
    done = new(log, "--file", file, "--channels", f"{{{CHANNELS}, load_n: {{column: Last, unit: g}}}}")
    assert done.returncode == 0, done.stderr
    assert "its last line, '99,04;0,1', is cut off and was left out" in done.stderr
    read = read_samples(log.parent / "raw" / "a-01")[1]
    assert read.to_numpy() == pytest.approx(GOOD.to_numpy())


@pytest.mark.parametrize("file", ["{}", "{delimiter: ;}"])
def test_the_message_about_a_layout_gives_all_of_it_at_once(log, file):
    """It gave a key each time: a newcomer ran the program four times, and lost the keys that were given before."""
    channels = f"{{{CHANNELS}, load_n: {{column: Last, unit: gr}}}}"
    done = new(log, "--file", file, "--channels", channels)
    option = re.search(r" --file \"(.*)\"$", done.stderr)
    assert option and option[1] == "{delimiter: ;, skip: 2, decimal: ','}", done.stderr
    done = new(log, "--file", option[1], "--channels", channels)
    assert "gr is not a known unit. Mend: did you mean 'g'" in done.stderr
    assert new(log, "--file", option[1], "--channels", channels.replace("gr}", "g}")).returncode == 0


@pytest.mark.parametrize(
    ("file", "says"),
    [
        ('{delimiter: ";", header: 3}', "file.header: is 3, .* set file.skip to 2"),
        ('{decimal: ","}', "decimal comma as well. Mend: set file.delimiter"),
        ('{delimiter: ";", skip: -1}', "file.skip: is -1"),
    ],
)
def test_a_layout_that_cannot_be_says_which_key(log, file, says):
    done = new(log, "--file", file)
    assert done.returncode == 2 and re.search(says, done.stderr), done.stderr


def test_rows_of_differing_length_are_said_in_a_sentence(log):
    log.write_text("time_s,motor_turns,displacement_mm\n" + "1,2,3\n" * 60 + "1,2,3,4,5\n1,2,3\n")
    done = new(log)
    assert "take the fields that are too many out of line 62" in done.stderr and "tokeniz" not in done.stderr


@pytest.mark.parametrize(("end", "kept_rows"), [("\n9,9", 0), ("\n9,9,", 0), ("\n9,9,9,", 0), ("\n9,9,9,9", 1)])
def test_only_a_last_row_that_was_cut_is_left_out(make_run, capsys, end, kept_rows):
    folder = make_run("a-01", suffix=".csv")
    path = folder / "recording.csv"
    rest = np.flatnonzero(GOOD["time_s"] < 90)
    text = GOOD.iloc[rest].to_csv(index=False).rstrip("\n")
    path.write_text(text + end.replace("9", "95", 1))
    assert len(read_samples(folder)[1]) == len(rest) + kept_rows
    assert ("cut off" in capsys.readouterr().err) == (not kept_rows)
