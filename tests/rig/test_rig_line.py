"""The name of the rig's port: one rig's alone while it runs, and free once it has ended."""

import json
import os
import re
import shlex
import signal
import subprocess
import sys
from pathlib import Path

import pytest
import ready
from first_few import first_few

from pipeline.ground.names import own_material
from pipeline.new_run import main as new_run
from pipeline.rig.options import again, base_of, command, free_name, material_of, number_of, waiting
from pipeline.rig.setup import described as described_as
from pipeline.rig.setup import dimensions, read_setup
from pipeline.run.folder import read_run
from pipeline.wire import read_recording

ROOT = Path(__file__).parents[2]


def start(link, *options, folder=ROOT):
    return ready.start("pipeline.rig", "small", "--link", link, *options, cwd=folder, apart=True)


def run(*words, folder=ROOT):
    """What a program of ours says; it ends well."""
    done = ready.run(*words, cwd=folder)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_a_second_rig_takes_no_link_of_a_live_one_and_a_stale_one_is_replaced(tmp_path):
    link = tmp_path / "port"
    link.symlink_to("/dev/pts/of-a-rig-that-was-killed")
    first = start(link)
    try:
        assert "Ctrl-C ends it" in first.stdout.readline()
        port = os.readlink(link)
        _, message = (second := start(link)).communicate(timeout=300)
        assert second.returncode == 2 and "another rig is there. Mend: end it, or choose another --link" in message
        assert os.readlink(link) == port
        link.unlink()
        link.symlink_to("/dev/null")  # somebody else's by now
        first.send_signal(signal.SIGINT)
        assert first.wait(timeout=300) == 130 and os.readlink(link) == "/dev/null"
    finally:
        first.kill()
        first.communicate()


def test_a_rig_that_is_told_to_end_takes_its_link_with_it(tmp_path):
    link = tmp_path / "port"
    rig = start(link)
    try:
        assert "Ctrl-C ends it" in rig.stdout.readline() and link.is_symlink()
        rig.send_signal(signal.SIGTERM)
        assert rig.wait(timeout=300) == 128 + signal.SIGTERM and not link.is_symlink()
    finally:
        rig.kill()
        rig.communicate()


def test_the_rig_says_its_dimensions_its_pace_and_that_each_recording_is_a_new_string(tmp_path):
    rig = start(tmp_path / "port", "--pace", "inf", "--recordings", "2", "--strokes", "5")
    try:
        first, described, strings, strokes = (rig.stdout.readline() for _ in range(4))
        assert "without any waiting" in first
        assert command(read_setup("small"), free_name(ROOT / "raw"), "small") in described
        assert "every recording is of a new string" in strings and "--string-id of its own" in strings
        assert "every recording has 5 strokes; --strokes N is for another number" in strokes
        for name in ("example-1", "example-2"):
            run(*shlex.split(command(read_setup("small"), name, "small"))[2:], "--out", tmp_path)
            printed = run("pipeline.capture", "--", tmp_path / "port", tmp_path / name)
            assert "Next: this rig's next recording is of another string" in printed and "--like" not in printed
            assert json.loads((tmp_path / name / "capture.json").read_text())["hello"]["strokes"] == 5
        printed, _ = rig.communicate(timeout=300)
        later = f"example-{number_of(free_name(ROOT / 'raw')) + 1}"
        second = (
            f"before recording 2 describe its string, another one, by: {command(read_setup('small'), later, 'small')}"
        )
        assert printed.count(second) == 1 and "recording 3" not in printed
    finally:
        rig.kill()
        rig.communicate()


@pytest.mark.long
def test_a_string_that_stays_is_described_again_by_the_line_that_the_rig_says_and_capture_says_its_zero(tmp_path):
    """A sensor that starts at 0 in each recording: nothing but the main job's log said so."""
    options = ["--pace", "inf", "--recordings", "3", "--standing", "--zeroed", "--strokes", "14"]
    rig = start(tmp_path / "port", *options, folder=tmp_path)

    def called(line):
        return run(*shlex.split(line)[2:], folder=tmp_path)

    try:
        lines = [rig.stdout.readline() for _ in range(5)]
        assert "set to zero at each start, so every run after the first has --tare run" in lines[3]
        called(lines[1].partition("by: ")[2])
        first = called(f"python -m pipeline.capture {tmp_path / 'port'} raw/example-1")
        assert "zero jumps" not in first and "14 of 14 strokes done" in first
        assert "Next: ask how long the string lasts by: python -m pipeline.lifespan raw/example-1 --out" in first
        assert json.loads((tmp_path / "raw/example-1/capture.json").read_text())["hello"]["strokes"] == 14
        called("python -m pipeline.new_run example-2 --like raw/example-1")
        second = called(f"python -m pipeline.capture {tmp_path / 'port'} raw/example-2")
        assert "raw/example-2: The zero jumps between two runs of one string" in second
        assert "write `tare: run` in run.yaml of example-2" in second
        both = "raw/example-1 raw/example-2"
        alone = f"python -m pipeline.diagnose {both} --together --out reports/mine/example-2\n"
        assert f"  or ask only what the simulator leaves out: {alone}Next: ask how long" in second
        assert second.endswith(f"by: python -m pipeline.lifespan {both} --out reports/mine\n")
        assert rig.stdout.readline() == "rig: recording 1 is recorded\n" and "example-2 --like" in rig.stdout.readline()
        assert rig.stdout.readline() == "rig: recording 2 is recorded\n"
        third = rig.stdout.readline().partition("before recording 3 describe it by: ")[2]
        assert shlex.split(third)[3:] == ["example-3", "--like", "raw/example-1", "--tare", "run"]
        called(third)
        assert read_run(tmp_path / "raw" / "example-3").tare == "run"
        third = called(f"python -m pipeline.capture {tmp_path / 'port'} raw/example-3")
        assert "run.yaml of example-3 says `tare: run`: at rest it reads" in third and "that is taken off" in third
    finally:
        rig.kill()
        rig.communicate()


def test_a_rig_that_stays_powered_keeps_its_zero_and_asks_for_no_tare(tmp_path):
    rig = start(tmp_path / "port", "--pace", "inf", "--recordings", "2", "--standing", "--strokes", "4", "--seed", "0")
    try:
        lines = [rig.stdout.readline() for _ in range(4)]
        assert "its displacement sensor keeps its zero from recording to recording, so no run needs --tare" in lines[3]
        for name in ("a-1", "a-2"):
            run("pipeline.capture", tmp_path / "port", tmp_path / name)
        later, _ = rig.communicate(timeout=300)
        assert " --like raw/" in later and "--tare" not in later
    finally:
        rig.kill()
        rig.communicate()
    first_mm, two = (
        read_recording((tmp_path / name / "recording.frames").read_bytes()).channels["displacement_mm"]
        for name in ("a-1", "a-2")
    )
    ends, begins = float(first_mm[-20:].mean()), float(two[:20].mean())
    assert abs(begins - ends) < 0.2 * abs(ends), "it goes on where it was"


def test_a_rig_whose_string_is_always_new_has_no_zero_to_keep(tmp_path):
    rig = start(tmp_path / "port", "--zeroed")
    message = rig.communicate(timeout=300)[1]
    assert rig.returncode == 2 and "--zeroed is for --standing" in message


def test_at_a_pace_the_rig_says_how_many_samples_a_second_come(tmp_path):
    rig = start(tmp_path / "port")
    try:
        line = rig.stdout.readline()
        assert "at 5 times real time, so its 20 samples a second come as 100; Ctrl-C ends it" in line
    finally:
        rig.kill()
        rig.communicate()


@pytest.mark.parametrize("which", ["paper", "small"])
def test_the_command_that_the_rig_says_describes_its_very_string(tmp_path, monkeypatch, which):
    setup = read_setup(which)
    words = shlex.split(command(setup, "example-1", which))
    assert words[:3] == ["python", "-m", "pipeline.new_run"]
    monkeypatch.setattr(sys, "argv", [*words[2:], "--out", str(tmp_path)])
    with pytest.raises(SystemExit) as ended:
        new_run()
    assert not ended.value.code
    run = read_run(tmp_path / "example-1")
    own = described_as(setup, tmp_path / "synthetic-1" / "run.yaml")
    assert dimensions(run) == dimensions(own) and run.rig == own.rig and run.string_id == "example-1"


def test_the_line_that_the_rig_says_names_a_run_that_is_not_there_yet_and_works_as_it_stands(tmp_path, monkeypatch):
    """The line named example-1 although that run was there, and was refused."""
    for name in ("example-1", "example-3"):
        (tmp_path / "raw" / name).mkdir(parents=True)
        (tmp_path / "raw" / name / "run.yaml").write_text("kept")
    rig = start(tmp_path / "port", folder=tmp_path)
    try:
        assert "Ctrl-C ends it" in rig.stdout.readline()
        line = rig.stdout.readline().rstrip("\n")
    finally:
        rig.kill()
        rig.communicate()
    assert (
        line == f"rig: before recording 1 describe its string by: {command(read_setup('small'), 'example-2', 'small')}"
    )
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", shlex.split(line.partition("by: ")[2])[2:])
    with pytest.raises(SystemExit) as ended:
        new_run()
    assert not ended.value.code and read_run(tmp_path / "raw" / "example-2").string_id == "example-2"
    assert free_name(tmp_path / "raw") == "example-4" and free_name(tmp_path / "nowhere") == "example-1"


def test_a_run_that_is_described_and_waits_is_proposed_before_a_new_one(tmp_path, monkeypatch):
    """example-2 was described and not recorded, and the rig asked for example-3."""
    setup, raw = read_setup("small"), tmp_path / "raw"

    def describe(name, *more, which="small"):
        run(*shlex.split(command(setup, name, which))[2:], *more, "--out", raw)

    describe("example-1")
    (raw / "example-1" / "recording.csv").write_text("")
    describe("example-2")
    rig = start(tmp_path / "port", "--pace", "inf", "--recordings", "2", "--strokes", "5", folder=tmp_path)
    try:
        first = [rig.stdout.readline().rstrip("\n") for _ in range(4)][1]
        capture = f"python -m pipeline.capture {tmp_path / 'port'} raw/example-2"
        assert first == f"rig: recording 1 goes into raw/example-2, which is described and waits: {capture}"
        describe("example-4")
        run(*shlex.split(capture)[2:], folder=tmp_path)
        assert rig.stdout.readline() == "rig: recording 1 is recorded\n"
        assert rig.stdout.readline().startswith(
            "rig: recording 2 goes into raw/example-4, which is described and waits: python -m"
        )
    finally:
        rig.kill()
        rig.communicate()
    material = material_of("small")
    assert waiting(raw, "example", 3, material) == "example-4" and waiting(raw, "example", 5, material) == ""
    assert waiting(raw, "example", 1, "example") == "", "one of another string's material is not this rig's"
    assert waiting(raw, "example", 1, material, "example-1") == "", "it is of another string"
    describe("example-9", "--string-id", "example-1")
    assert waiting(raw, "example", 1, material, "example-1") == "example-9"
    (raw / "example-4" / "recording.lines").write_text("")
    assert waiting(raw, "example", 1, material) == "example-9", "one that is being recorded does not wait"


def test_each_set_up_has_a_material_of_its_own():
    """The page of `example` mixed the string of `paper` with one in which another effect was concealed."""
    names = [material_of(which) for which in ("paper", "small", "/tmp/my rig.yaml", "concealed.yaml", ".yaml", "/")]
    assert names == ["example", "example-small", "example-my-rig", "example-concealed", "example-yaml", "example"]
    assert all(own_material(name) for name in names)


def test_the_page_of_the_protocol_has_the_command_that_the_rig_says():
    text = (ROOT / "docs" / "protocol.md").read_text()
    assert f"\n{command(read_setup('paper'), 'example-1')}\n" in text and "of a new string" in text


def test_the_readme_has_the_command_that_the_rig_says():
    text = (ROOT / "README.md").read_text().replace("\\\n    ", "")
    assert f"\n{command(read_setup('paper'), 'example-1')}\n" in text


def test_two_rigs_at_once_have_two_strings_and_one_that_is_started_again_has_its_own(tmp_path):
    """The first recordings of two rigs were the same, byte by byte."""
    hashes, seeds = [], []
    for name, port, options in (
        ("a-1", "port", ()), ("a-2", "port", ()), ("a-3", "rig2", ()), ("a-4", "port", ("--seed", "7")),
    ):  # fmt: skip
        rig = start(tmp_path / port, "--pace", "inf", "--recordings", "1", "--strokes", "2", *options)
        try:
            words = [rig.stdout.readline() for _ in range(3)][-1]
            run("pipeline.capture", "--", tmp_path / port, tmp_path / name)
            rig.communicate(timeout=300)
        finally:
            rig.kill()
        hashes.append(json.loads((tmp_path / name / "capture.json").read_text())["sha256"])
        seeds += re.findall(r"; seed (\d+): another --seed gives other strings$", words)
    assert hashes[0] == hashes[1] and len(set(hashes)) == 3
    assert seeds[:2] == ["0", "0"] and int(seeds[2]) >= 1000 and len(seeds) == 3


@pytest.mark.parametrize("number", first_few([signal.SIGINT, signal.SIGTERM]))
def test_a_rig_in_the_background_of_a_shell_ends_by_either_signal_and_takes_its_link_with_it(tmp_path, number):
    """A shell starts such a job deaf to SIGINT, and a Python that is started so has no handler of its own."""
    link = tmp_path / "port"
    words = [sys.executable, "-m", "pipeline.rig", "small", "--link", str(link)]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    rig = subprocess.Popen(words, cwd=ROOT, **pipes, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
    try:
        assert "in the background kill" in rig.stdout.readline() and link.is_symlink()
        rig.send_signal(number)
        assert rig.wait(timeout=60) == 128 + number and not link.is_symlink()
    finally:
        rig.kill()
        rig.communicate()


@pytest.mark.parametrize(
    ("link", "base"),
    [
        ("/tmp/rig", "example"),
        ("port", "example"),
        ("/tmp/rig2", "rig2"),
        ("/tmp/rig_B", "rig-b"),
        ("ttyS0", "example"),
    ],
)
def test_two_rigs_at_once_name_runs_of_their_own(link: str, base: str, tmp_path: Path) -> None:
    """Both printed the same new_run line, and the second one was refused: that run was there already."""
    assert base_of(Path(link)) == base
    assert free_name(tmp_path, base) == f"{base}-1" and number_of(f"{base}-12") == 12
    (tmp_path / f"{base}-1").mkdir()
    assert f"new_run {base}-2 --like" in again(tmp_path, f"{base}-1", zeroed=False)
