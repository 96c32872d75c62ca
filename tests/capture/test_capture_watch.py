"""What is wrong is said in a sentence, and what is right is not complained of."""

import random
import struct
from dataclasses import replace

import numpy as np
import pytest
from faults.scripted_device import received

from pipeline.capture.guess import guess
from pipeline.capture.recording_progress import Progress
from pipeline.capture.sample_faults import Watch
from pipeline.rig.recorded_at_once import simulate
from pipeline.rig.setup import read_setup
from pipeline.run.mend_command import MEND
from pipeline.wire import Channel, Event, Frame, Hello, Kind, encode
from pipeline.wire.frames import EVENT

RATE_HZ = 100.0
CHANNELS = (Channel("motor_turns", "turns", "i32", 0.01), Channel("displacement_mm", "mm", "i16", 0.02))
HELLO = Hello("a rig", "1.0", "00000001", RATE_HZ, 2, CHANNELS)


FRAMES = b"".join(encode(Kind.SAMPLE, seq, struct.pack("<IiH", seq * 1000, seq * 41, seq * 3)) for seq in range(300))
TEXT = b"".join(b"%d,%.2f\r\n" % (number, number * 0.1) for number in range(200))
NOISE = random.Random(1).randbytes(3000)
OTHER = b"".join(random.Random(seed).randbytes(24).replace(b"\0", b"\1") + b"\0" for seed in range(100))


@pytest.mark.parametrize(
    ("heard", "faster", "expected_words"),
    [
        (FRAMES, 1, "answers no GREET"),
        (TEXT, 1, "lines of text"),
        (NOISE, 1, "noise"),
        (OTHER, 1, "another protocol"),
        *((data, faster, "lower baud rate") for data in (FRAMES, TEXT) for faster in (2, 4, 8)),
    ],
)
def test_what_a_port_sends_is_guessed(heard, faster, expected_words):
    assert expected_words in guess(heard if faster == 1 else received(heard, faster), 115_200)[0]


def watched(turns, measured_mm, folder=None) -> list[tuple[float, str]]:
    watch, warnings = Watch(HELLO, folder), []
    for number, (turn, mm) in enumerate(zip(turns, measured_mm, strict=True)):
        payload = struct.pack("<Iih", number * 10_000, round(turn / 0.01), round(mm / 0.02))
        warnings.append(watch.look(Frame(Kind.SAMPLE, number, payload)))
    return [(number / RATE_HZ, warning) for number, warning in enumerate(warnings) if warning]


TURNS = np.interp(np.arange(1200) / RATE_HZ, [1, 6, 7, 12], [0, 15, 15, 0])
CONTRACTION_MM = 0.03 * TURNS**2


def test_a_good_recording_is_not_complained_of():
    noise = np.random.default_rng(1).normal(0, 0.05, len(TURNS))
    assert watched(TURNS, CONTRACTION_MM) == watched(TURNS, CONTRACTION_MM + noise) == []


@pytest.mark.parametrize("setup", ["small", "paper"])
def test_the_synthetic_rig_is_not_complained_of(setup):
    simulated = simulate(read_setup(setup), 3)
    watch = Watch(simulated.hello)
    assert not [1 for sample in simulated.samples if watch.look(Frame(Kind.SAMPLE, 0, sample.tobytes()))]


def test_a_frozen_displacement_is_told_once_and_soon():
    ((said_s, sentence),) = watched(TURNS, np.full(len(TURNS), 7.0))
    assert "has not changed" in sentence and said_s < 1 + 3.0


def test_a_displacement_that_goes_the_wrong_way_is_told_once_and_soon():
    ((said_s, sentence),) = watched(TURNS, 30 - CONTRACTION_MM)
    assert "falls while the motor winds" in sentence and said_s < 1 + 3.0


def described(folder, more=""):
    """A run folder with a description of a string, and `more` lines of it."""
    run = folder / "raw" / "run-1"
    run.mkdir(parents=True)
    sizes = "string: {material: nylon, radius_mm: 0.4, length_mm: 400}\n"
    rig = "rig: {torsion_zone_mm: 150, separator_mm: 8, load_n: 20}\n"
    (run / "run.yaml").write_text(f"run: run-1\n{sizes}{rig}{more}")
    return run


def test_a_wrong_direction_is_turned_by_a_command_that_can_be_copied(tmp_path):
    run = described(tmp_path)
    ((_, sentence),) = watched(TURNS, 30 - CONTRACTION_MM, run)
    assert sentence.endswith(f"when the recording has ended: {MEND} {run} channels.displacement_mm.scale=-1")


def test_a_channel_is_looked_at_as_the_runs_description_reads_it(tmp_path):
    run = described(tmp_path, "channels: {displacement_mm: {scale: -1}}\n")
    assert watched(TURNS, 30 - CONTRACTION_MM, run) == []
    ((_, sentence),) = watched(TURNS, CONTRACTION_MM, run)
    assert sentence.endswith("channels.displacement_mm.scale=1")


def test_samples_of_another_size_are_told():
    assert "not of the size" in Watch(HELLO).look(Frame(Kind.SAMPLE, 1, b"123"))


@pytest.mark.parametrize(
    ("numbers", "lost"),
    [
        ([1, 2, 3], 0),
        ([1, 2, 5], 2),
        ([1, 3, 2, 4], 0),
        ([1, 5, 3, 3, 2], 1),
        ([2, 1, 1], 0),
        ([*range(1, 2000, 2), *range(2, 2000, 2)], 0),
    ],
)
def test_a_frame_that_comes_late_is_not_shown_as_lost(numbers, lost):
    progress = Progress(HELLO)
    for number in numbers:
        progress.count(Frame(Kind.EVENT, number))
    assert progress.lost == lost


@pytest.mark.parametrize(("passed_s", "other"), [(10.0, False), (2.0, False), (50.0, True)])
def test_every_time_but_the_rigs_own_is_the_persons(monkeypatch, passed_s, other):
    """A line of a rig at five times real time said "5:06 recorded in 1:01, about 0:05 left": whose seconds?"""
    shown = Progress(HELLO)
    shown.samples = round(10 * RATE_HZ)
    shown._began_s -= passed_s
    parts = shown.parts()
    assert parts[0] == f"0:{passed_s:02.0f} passed", "its clock changed from the rig's to the person's after 5 s"
    assert ("0:10 by the rig's clock" in parts) is other
    assert ("0:10 by the rig's clock" in shown.parts(last=True)) is (passed_s != 10.0), "a fast rig ends sooner"


def test_of_a_program_the_time_that_is_left_is_that_of_its_legs(monkeypatch):
    """Foretold from strokes alone it stood at 0:05 for 8 s, and said nothing within a first stroke with a hold."""
    shown, counted_s = Progress(HELLO, 60.0), []
    for recorded_s in (0.5, 20.0, 40.0, 55.0, 60.0):
        shown.samples = round(recorded_s * RATE_HZ)
        now_s = shown._began_s + recorded_s / 5.0  # the rig goes at five times real time
        monkeypatch.setattr("pipeline.capture.recording_progress.time.monotonic", lambda at_s=now_s: at_s)
        counted_s.append(next((part for part in shown.parts() if part.endswith(" left")), None))
        shown.left.starts(recorded_s / 5.0)
        shown.left.ends(recorded_s / 5.0)
    assert counted_s == [None, *(f"about 0:{left_s:02d} left" for left_s in (8, 4, 1, 0))]


def test_the_last_line_foretells_no_time():
    shown = Progress(HELLO)
    shown.left.starts(1.0)
    shown.left.ends(9.0)
    assert [any(part.endswith(" left") for part in shown.parts(last=last)) for last in (False, True)] == [True, False]


@pytest.mark.parametrize(
    ("ends_at_turns", "words"), [(0.0, "1 of 1 strokes done"), (20.0, "stroke 1 of 1")], ids=["unwound", "wound"]
)
def test_the_last_line_counts_a_stroke_that_was_unwound_though_nothing_told_of_its_end(ends_at_turns, words):
    """A run that ended with its unwinding, without a rest, ended with `stroke 1 of 1` beside `complete`."""
    hello = replace(HELLO, rate_hz=20.0, strokes=1, channels=(Channel("motor_turns", "turns", "i32", 0.001),))
    shown, motion = Progress(hello), np.interp(np.arange(200), [0, 100, 199], [0.0, 20.0, ends_at_turns])
    shown.count(Frame(Kind.EVENT, 1, EVENT.pack(50_000, Event.STROKE_START, 1)))
    for at, turns in enumerate(motion.tolist(), 2):
        shown.count(Frame(Kind.SAMPLE, at, struct.pack("<Ii", at * 50_000, round(1000 * turns))))
    assert shown.parts()[1] == "stroke 1 of 1", "while it may go on, what the rig told counts"
    assert shown.parts(last=True)[1] == words


def test_a_stroke_that_was_cut_off_while_it_unwound_is_not_done():
    """Ctrl-C at 22 of 27 turns was told as `2 of 9 strokes done`."""
    hello = replace(HELLO, rate_hz=20.0, strokes=9, channels=(Channel("motor_turns", "turns", "i32", 0.001),))
    shown, motion = Progress(hello), np.interp(np.arange(200), [0, 100, 199], [0.0, 27.2, 22.1])
    shown.count(Frame(Kind.EVENT, 1, EVENT.pack(50_000, Event.STROKE_START, 1)))
    for at, turns in enumerate(motion.tolist(), 2):
        shown.count(Frame(Kind.SAMPLE, at, struct.pack("<Ii", at * 50_000, round(1000 * turns))))
    words = ["0 of 9 strokes done", "stroke 1 was cut off at 22.1 turns while it unwound"]
    assert shown.parts(last=True, cut=True)[1:3] == words
    assert shown.parts(last=True)[1] == "1 of 9 strokes done", "a rig that was done ends where it likes"


@pytest.mark.parametrize(("lost", "place"), [(0, -1), (3, 0)])
def test_readings_come_before_frames_of_which_none_was_lost(lost, place):
    """On a terminal of 80 columns what a person wants to see live was cut off for a 0."""
    shown = Progress(HELLO)
    shown.lost, shown.watch.now["motor_turns"] = lost, 12.5
    parts = shown.parts()
    order = [part for part in parts if part in ("12.50 turns", f"{lost} frames lost")]
    assert len(order) == 2 and order[place] == f"{lost} frames lost"
