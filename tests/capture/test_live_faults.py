"""A text rig whose columns cannot be what they are read as: said while it records, and mended by what can be copied."""

import os
import re
import shlex
import signal
import threading
import time
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import ready
import yaml
from capture.test_capture_text import rig
from made_recording import BASE, content, recording

from pipeline.capture.printed.live_faults import LiveFaults
from pipeline.ground.errors import BadInput
from pipeline.ground.stored.rows import rows_of
from pipeline.run.description import parse_run
from pipeline.run.dimensions import geometry
from pipeline.run.doubts.plausible import check_string

__all__ = ["rig"]
COLUMNS = ["time_ms", "motor_turns", "displacement_mm", "load_n"]
NAMED = {"time_s": {"column": "t", "unit": "ms"}, "motor_turns": "theta", "displacement_mm": "disp", "load_n": "cell"}
ROOT = Path(__file__).parents[2]
PACE = 40.0  # times as fast as life
FALLS = "displacement_mm falls while the motor winds; contraction is positive: "
STANDS = "displacement_mm has not changed while the motor turned"
LOAD = "load_n reads as the displacement would: exchange the columns of displacement_mm and load_n"
TWIST = "exchange the columns of motor_turns and displacement_mm"


def printed(strokes: int = 6, **changes: object) -> pd.DataFrame:
    """What a good rig prints: six strokes, some noise, and a load cell that trembles."""
    table = recording(strokes, speed=4.0)
    load_n = 20.0 + 0.1 * np.random.default_rng(1).standard_normal(len(table))
    return table.assign(time_ms=(1000.0 * table["time_s"]).round(), load_n=load_n).assign(**changes)[COLUMNS]


def lines(table: pd.DataFrame) -> list[bytes]:
    return [b"%d,%.3f,%.3f,%.3f\r\n" % tuple(row) for row in table.to_numpy()]


class Recorded:
    """A recording of what a rig prints, by the real program, that is ended by Ctrl-C: its words, live and all."""

    def __init__(self, rig, folder: Path, table: pd.DataFrame, header=COLUMNS, channels=None) -> None:
        ours, start = rig
        folder.mkdir()
        (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1", channels=channels), sort_keys=False))
        process, printed_lines = start(), []
        reading = threading.Thread(target=lambda: printed_lines.extend(iter(process.stdout.readline, "")), daemon=True)
        reading.start()
        while not (folder / "recording.lines").exists():
            assert process.poll() is None, printed_lines
            os.write(ours, (",".join(header) + "\r\n").encode())
            time.sleep(0.1)
        began_s = time.monotonic()
        for time_ms, line in zip(table["time_ms"], lines(table), strict=True):
            time.sleep(max(0.0, began_s + time_ms / 1000.0 / PACE - time.monotonic()))
            os.write(ours, line)
        time.sleep(1.0)
        self.live = "".join(printed_lines)
        process.send_signal(signal.SIGINT)
        self.status = process.wait(60)
        reading.join(60)
        self.said = "".join(printed_lines)

    @property
    def next(self) -> list[str]:
        """The commands that come next."""
        return [line for line in self.said.splitlines() if line.startswith(("Next:", "Then:", "  "))]


def assert_mended(folder: Path) -> None:
    """The finished run can be used now, and `--recover` says so."""
    done = ready.run("pipeline.capture", "--recover", folder)
    assert done.returncode == 0 and "there is nothing to recover" in done.stdout and "Next:" in done.stdout, done


def assert_mended_by(command: str, folder: Path) -> None:
    """The command makes the finished run usable."""
    done = ready.run("pipeline.mend", *shlex.split(command)[3:])
    assert done.returncode == 0 and "It can be used: " in done.stdout, done
    assert_mended(folder)


def test_a_good_recording_is_not_complained_of(rig, tmp_path):
    done = Recorded(rig, tmp_path / "run-1", printed())
    assert done.status == 0 and "warning" not in done.said, done.said
    assert "pipeline.diagnose" in done.next[0]
    assert "the columns are" not in done.said, "all are channels of run.yaml, and were shown"


def test_a_wrong_sign_is_said_while_it_records_and_mended_by_a_command(rig, tmp_path):
    """26 s went by without a word, and the end sent the person to a diagnosis."""
    folder, table = tmp_path / "run-1", printed()
    done = Recorded(rig, folder, table.assign(displacement_mm=-table["displacement_mm"]))
    assert done.live.count(f"warning: {FALLS}set channels.displacement_mm.scale to -1") == 1, done.live
    command = f"python -m pipeline.mend {folder} channels.displacement_mm.scale=-1"
    assert f"When the recording has ended: {command}\n" in done.live
    assert done.status == 0 and "Until then nothing can use this run." in done.said
    assert done.next[0] == f"Next: mend it, and record nothing anew: {command}"
    then = "Then: see that it can be used, and what comes next: python -m pipeline.capture --recover"
    assert done.next[1:] == [f"{then} {folder}"], "it says how many strokes there are, and which command fits them"
    end = done.said[len(done.live) :]
    assert end.index("Next: mend it") < end.index("run-1: ended,"), "the mend stands before all else"
    again = ready.run("pipeline.capture", "--recover", folder)
    assert again.returncode == 2 and f"anew: {command}\n" in again.stdout, "said again, not only that it is finished"
    assert_mended_by(command, folder)


def test_the_sign_of_a_run_with_channels_is_changed_in_them(rig, tmp_path):
    folder, table = tmp_path / "run-1", printed(2)
    turned = table.assign(displacement_mm=-table["displacement_mm"])
    done = Recorded(rig, folder, turned, ["t", "theta", "disp", "cell"], NAMED)
    command = re.search(r"(python -m pipeline\.mend .*)\n", done.live)[1]
    assert command in done.next[0]
    assert_mended_by(command, folder)


@pytest.mark.parametrize("noise_mm", [0.0, 0.03])
def test_a_displacement_that_stands_is_said_while_it_records(rig, tmp_path, noise_mm):
    noise = noise_mm * np.random.default_rng(2).standard_normal(len(printed()))
    done = Recorded(rig, tmp_path / "run-1", printed(displacement_mm=7.0 + noise))
    assert done.live.count(f"warning: {STANDS}") == 1 and ": check the sensor and its cable\n" in done.live, done.live
    assert "nothing can use this run" in done.said and not done.next, "nobody is sent to a diagnosis of it"


@pytest.mark.parametrize(
    ("header", "sentence", "mended"),
    [
        (["time_ms", "motor_turns", "load_n", "displacement_mm"], LOAD, COLUMNS),
        (["time_ms", "displacement_mm", "motor_turns", "load_n"], TWIST, COLUMNS),
    ],
    ids=["load", "twist"],
)
def test_exchanged_columns_are_said_while_it_records_with_the_whole_command(rig, tmp_path, header, sentence, mended):
    folder = tmp_path / "run-1"
    done = Recorded(rig, folder, printed(), header)
    command = f"python -m pipeline.capture --recover {folder} --columns {','.join(mended)}"
    assert done.live.count(sentence) == 1 and f"{sentence}. When the recording has ended: {command}\n" in done.live
    assert "check the sensor" not in done.said and done.status == 0, done.said
    assert done.next == [f"Next: mend it, and record nothing anew: {command}"], "no diagnosis of exchanged columns"
    again = ready.run("pipeline.capture", "--recover", folder, "--columns", ",".join(header))
    assert again.returncode == 2 and f"anew: {command}\n" in again.stdout and "warning: " in again.stdout
    right = ready.run("pipeline.capture", *shlex.split(command)[3:])
    assert right.returncode == 0 and "pipeline.diagnose" in right.stdout and "warning" not in right.stdout


IN_OTHER_UNITS = {
    "time_s": {"column": "time_ms", "unit": "ms"},
    "motor_turns": {"column": "motor_turns", "unit": "deg"},
    "displacement_mm": "displacement_mm",
    "load_n": {"column": "load_n", "unit": "gf"},
}


@pytest.mark.parametrize("pair", [("motor_turns", "displacement_mm"), ("displacement_mm", "load_n")])
def test_exchanged_columns_are_seen_in_whatever_unit_they_are(tmp_path, pair):
    """A laser in mm that is read as degrees never winds, and one that is read as grams hardly pulls."""
    first, second = pair
    table = printed(3).assign(motor_turns=lambda read: 360.0 * read["motor_turns"], load_n=lambda read: 2000.0)
    swapped = table.assign(**{first: table[second], second: table[first]})
    sentence = f"exchange the columns of {first} and {second}"
    channels = {**IN_OTHER_UNITS}
    warnings = said_of(tmp_path / "run-1", swapped.assign(time_s=swapped["time_ms"] / 1000.0), channels=channels)
    assert sum(sentence in each for each in warnings) == 1 and sentence in warnings[0], warnings
    run, samples = parse_run(content("run-1", channels=channels), tmp_path / "run-1" / "run.yaml"), swapped
    samples = samples.assign(motor_turns=swapped["motor_turns"] / 360.0, load_n=swapped["load_n"] * 0.00980665)
    with pytest.raises(BadInput, match=sentence):
        check_string(run, rows_of(samples), geometry(run), tmp_path / "recording.csv")


GOOD = recording(3, noise_mm=0.0)
TURNS, TIME_S = GOOD["motor_turns"].to_numpy(), GOOD["time_s"].to_numpy()
NOISE = 0.02 * np.random.default_rng(0).standard_normal(len(GOOD))


def contracts(turns):
    return BASE.contraction_mm(turns, 20.0)


def with_play(width: float):
    """The twist behind a play of so many turns."""
    behind = [0.0]
    for turn in TURNS[1:]:
        behind.append(min(max(behind[-1], turn - width / 2), turn + width / 2))
    return np.array(behind)


def said_of(folder: Path, table: pd.DataFrame, form: str = "%.3f", channels=None) -> list[str]:
    """What is said while the samples of a table come, asked every second for exchanged columns."""
    folder.mkdir()
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1", channels=channels)))
    faults, sentences = LiveFaults(folder, COLUMNS), []
    for at, row in enumerate(table[["time_s", *COLUMNS[1:]]].to_numpy()):
        sentences.append(faults.look([f"{1000 * row[0]:.0f}", *(form % value for value in row[1:])]))
        sentences += [faults.exchange()] if at % 25 == 24 else []
    return [sentence for sentence in [*sentences, faults.exchange(last=True)] if sentence]


@pytest.mark.parametrize(
    ("turns", "measured_mm"),
    [
        *((TURNS, contracts(with_play(width))) for width in (1.0, 6.0)),
        *((TURNS, np.maximum(contracts(TURNS) - contracts(0.0) - slack, 0.0)) for slack in (0.4, 2.5)),
        (TURNS, contracts(np.maximum(TURNS - 5.0, 0.0)) - 0.02 * TIME_S),  # hangs slack, and creeps
        (TURNS, contracts(TURNS) - 3.0 * TIME_S / 60.0),
        (TURNS, contracts(TURNS) + 0.6 * np.sin(2.0 * np.pi * TURNS)),
        (TURNS, contracts(TURNS) - 4.0 * (TIME_S > 12.0)),  # the clamp slips
        (TURNS, np.minimum(contracts(TURNS), 15.0)),  # a stop
        (TURNS + 8.0, contracts(TURNS + 8.0)),
        (TURNS - 5.0, contracts(TURNS)),  # 0 is not the untwisted string, and it unwinds first
        (TURNS, contracts(TURNS) + 20.0 * NOISE),
    ],
)
@pytest.mark.parametrize("noise", [0.0, NOISE], ids=["still", "noise"])
def test_what_a_good_string_does_is_not_complained_of(tmp_path, turns, measured_mm, noise):
    table = GOOD.assign(motor_turns=turns, displacement_mm=measured_mm + noise)
    assert said_of(tmp_path / "run-1", table) == []


@pytest.mark.parametrize("begin", ["wound", "at its top"])
def test_a_recording_that_begins_in_the_middle_of_a_stroke_is_not_complained_of(tmp_path, begin):
    first = int(np.argmax(TURNS > 8.0) if begin == "wound" else np.argmax(TURNS > 26.9))
    assert said_of(tmp_path / "run-1", GOOD.iloc[first:]) == []


@pytest.mark.parametrize("form", ["%.3f", "%.1f", "%.0f"])
@pytest.mark.parametrize(("top", "speed"), [(5.0, 2.0), (12.0, 10.0), (27.0, 0.5)])
def test_few_strokes_of_any_height_pace_and_resolution_are_not_complained_of(tmp_path, form, top, speed):
    assert said_of(tmp_path / "run-1", recording(1, top=top, speed=speed), form) == []


@pytest.mark.parametrize("wrong", ["sign", "columns"])
def test_a_time_in_a_wrong_unit_hides_no_other_fault_at_the_end(rig, tmp_path, wrong):
    """The end said that a sample every 25 s is no rate, and left out the mend that was shown while it recorded."""
    folder, table, header = tmp_path / "run-1", printed(), ["t", "theta", "disp", "cell"]
    if wrong == "sign":
        table = table.assign(displacement_mm=-table["displacement_mm"])
    else:
        header = ["t", "theta", "cell", "disp"]
    done = Recorded(rig, folder, table, header, {**NAMED, "time_s": "t"})
    end, live = done.said[len(done.live) :], done.live.splitlines()
    reads = next(at for at, line in enumerate(live) if line.startswith("reads "))
    unit_warning = (
        "warning: time_s is read in s: a sample every 40 s is no rate of a rig; set channels.time_s.unit to 'ms'"
    )
    assert live[reads + 1].startswith(
        f"{unit_warning}. When the recording has ended: python -m pipeline.mend {folder} "
    ), live
    if wrong == "sign":
        both = re.findall(r"pipeline\.mend \S+ (.*)", done.live)[-1].split()
        assert {*both} == {"channels.time_s.unit=ms", "channels.displacement_mm.scale=-1"}, "one command makes both"
    assert "is no rate of a rig. Mend: set channels.time_s.unit to 'ms', or record" in end, end
    assert f"\nwarning: {FALLS if wrong == 'sign' else LOAD}" in end, end
    command = re.search(r"pipeline\.mend (.*)", done.next[0])[1]
    ready.run("pipeline.mend", *shlex.split(command))
    if wrong == "columns":
        assert done.next[1].startswith("Then: mend it further: ")
        again = ready.run("pipeline.capture", *shlex.split(done.next[1].partition("pipeline.capture ")[2]))
        assert again.returncode == 0 and "warning" not in again.stdout, again.stdout
    assert_mended(folder)
