"""The capture program against the rig program, over a real pseudo-terminal."""

import hashlib
import json
import os
import pty
import shutil
import signal
import subprocess
import sys
import threading
import time
import tty
from contextlib import ExitStack
from dataclasses import replace
from datetime import UTC, datetime
from itertools import count
from pathlib import Path

import numpy as np
import programs
import pytest
from ready import run
from scripted_rig import synthetic_rig

from pipeline.capture.commit import Read, account
from pipeline.capture.ended_run import tell_frames
from pipeline.capture.handshake import check_rate
from pipeline.capture.port import Port
from pipeline.capture.session import capture, plain
from pipeline.capture.stream import Outcome
from pipeline.ground.errors import BadInput
from pipeline.rig.device import Device
from pipeline.rig.recorded_at_once import simulate
from pipeline.rig.setup import read_setup
from pipeline.wire import Channel, Decoder, Frame, Hello, Kind, encode, read_recording
from pipeline.wire.frames import END

SEED = 3
SMALL = Hello("a rig", "1", "1", 50.0, 2, (Channel("motor_turns", "turns", "i32", 0.25),))


@pytest.fixture(scope="module")
def simulated():
    return simulate(read_setup("small"), SEED)


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    """A run folder that the real programs have made."""
    folder = tmp_path_factory.mktemp("raw") / "small-01"
    done = run("pipeline.rig.record", "small", folder, "--seed", SEED)
    assert done.returncode == 0, done.stderr
    return folder


def start(module: str, *arguments) -> subprocess.Popen:
    command = [sys.executable, "-m", module, *map(str, arguments)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def info(folder: Path) -> dict:
    return json.loads((folder / "capture.json").read_text())


@pytest.fixture
def rig(tmp_path):
    """Start rigs by their options; each returns its port."""
    numbers = count()
    with ExitStack() as rigs:
        yield lambda *options: rigs.enter_context(
            synthetic_rig(tmp_path / f"port{next(numbers)}", "small", "--seed", SEED, *options)
        )


@pytest.fixture
def line():
    """A serial port in our hands: our end, and the name of the host's."""
    ours, theirs = pty.openpty()
    tty.setraw(theirs)
    yield ours, os.ttyname(theirs)
    os.close(theirs)
    os.close(ours)


def exact(simulated) -> bytes:
    """Every byte of a recording as the device sends it."""
    device = Device(simulated)
    device.hear(encode(Kind.GREET, 0))
    sent = device.speak()
    device.hear(encode(Kind.START, 0))
    while device.recording:
        sent += device.speak()
    return sent


def test_a_recording_holds_exactly_the_bytes_that_were_sent(recorded, simulated):
    data = (recorded / "recording.frames").read_bytes()
    assert data == exact(simulated)
    recording = read_recording(data)
    np.testing.assert_allclose(recording.time_s, simulated.time_s, atol=1e-6)
    quanta = {channel.name: channel.scale for channel in simulated.hello.channels}
    for name, values in recording.channels.items():
        np.testing.assert_array_equal(np.rint(values / quanta[name]), simulated.samples[name])


def test_capture_json_accounts_for_every_frame(recorded, simulated):
    capture_info = info(recorded)
    data = (recorded / "recording.frames").read_bytes()
    assert capture_info["exit_status"] == "complete" and capture_info["fault"] is None
    assert capture_info["bytes"] == len(data) and capture_info["sha256"] == hashlib.sha256(data).hexdigest()
    frames = capture_info["frames"]
    assert frames["sent"] == frames["received"] == len(simulated.samples) + len(simulated.events) + 2
    assert frames["lost"] == frames["bad"] == 0
    count = len(simulated.samples)
    nothing_wrong = {"out_of_order": 0, "backward_time_stamps": 0, "repeated_time_stamps": 0}
    assert capture_info["samples"] == {"sent": count, "received": count, **nothing_wrong}
    assert capture_info["hello"]["device"] == "twistbench synthetic rig"
    assert capture_info["started_utc"] <= capture_info["ended_utc"]


@pytest.mark.long
def test_the_same_seed_gives_the_same_bytes_and_another_one_does_not(recorded, tmp_path):
    for name, seed in (("again", SEED), ("other", SEED + 1)):
        assert run("pipeline.rig.record", "small", tmp_path / name, "--seed", seed).returncode == 0
    first, again, other = (info(folder)["sha256"] for folder in (recorded, tmp_path / "again", tmp_path / "other"))
    assert first == again != other


def test_a_silent_port_is_given_up_with_a_sentence(line, tmp_path):
    done = run("pipeline.capture", line[1], tmp_path / "run-1")
    assert done.returncode == 2
    assert "said nothing for 3 s" in done.stderr and "Traceback" not in done.stderr
    assert not (tmp_path / "run-1").exists()


@pytest.mark.parametrize("existing_name", ["recording.frames", "recording.csv", "capture.json"])
def test_a_recording_is_never_overwritten(existing_name, tmp_path):
    folder = tmp_path / "run-1"
    folder.mkdir()
    (folder / existing_name).write_text("precious")
    done = run("pipeline.capture", "/dev/null", folder)
    assert done.returncode == 2 and "never overwritten" in done.stderr
    assert (folder / existing_name).read_text() == "precious"


@pytest.mark.parametrize(
    ("port", "name", "message"),
    [
        ("/dev/null", "Run_1", "no name of a run"),
        ("/nowhere/port", "run-1", "is not there"),
        ("/dev/null", "run-1", "cannot be opened"),
    ],
)
def test_bad_input_is_one_line_that_names_the_mend(port, name, message, tmp_path, monkeypatch):
    monkeypatch.setattr(Port.__init__, "__defaults__", (0.3,))  # s, in which a port may still come
    done = programs.run("pipeline.capture", port, tmp_path / name)
    assert done.returncode == 2
    assert message in done.stderr and "Mend:" in done.stderr and done.stderr.count("\n") == 1
    assert not (tmp_path / name).exists()


def answering(end: int, hello: bytes) -> threading.Thread:
    """A device that answers GREET with these bytes and says nothing more."""

    def answer() -> None:
        os.read(end, 100)
        os.write(end, hello)

    thread = threading.Thread(target=answer)
    thread.start()
    return thread


@pytest.mark.parametrize(
    ("payload", "message"),
    [
        (b'{"protocol":3}', "HELLO.protocol: is version 3"),
        (b"hello", "HELLO: is not JSON"),
        (replace(SMALL, protocol=1).pack(), "HELLO.protocol: is version 1, under the check of version 2"),
    ],
)
def test_another_protocol_is_refused(payload, message, line, tmp_path):
    thread = answering(line[0], encode(Kind.HELLO, 0, payload))
    done = run("pipeline.capture", line[1], tmp_path / "run-1")
    thread.join()
    assert done.returncode == 2 and message in done.stderr
    assert not (tmp_path / "run-1").exists()


def test_a_device_that_falls_silent_leaves_a_fault_and_all_that_came(line, tmp_path, simulated):
    beginning = exact(simulated)[:2000]
    hello = beginning[: beginning.index(0) + 1]

    def answer() -> None:
        os.read(line[0], 100)
        os.write(line[0], hello)
        os.read(line[0], 100)
        os.write(line[0], beginning[len(hello) :])

    thread = threading.Thread(target=answer)
    thread.start()
    done = run("pipeline.capture", line[1], tmp_path / "run-1")
    thread.join()
    assert done.returncode == 1 and "said nothing" in done.stdout
    assert (tmp_path / "run-1" / "recording.frames").read_bytes() == beginning
    capture_info = info(tmp_path / "run-1")
    assert capture_info["exit_status"] == "fault" and capture_info["samples"]["sent"] is None
    assert capture_info["frames"]["sent"] == capture_info["frames"]["received"] + capture_info["frames"]["lost"]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_ctrl_c_or_kill_ends_a_recording_in_good_order(rig, tmp_path, number):
    folder = tmp_path / "run-1"
    capture = start("pipeline.capture", rig("--pace", "2"), folder)
    while not (folder / "recording.frames").exists() or (folder / "recording.frames").stat().st_size < 1500:
        assert capture.poll() is None, capture.stdout.read()
        time.sleep(0.02)
    capture.send_signal(number)
    printed, _ = capture.communicate(timeout=20)
    assert capture.returncode == 0, printed
    assert f"recording; Ctrl-C or kill {capture.pid} ends it, and what came is kept" in printed
    assert "samples/s" in printed and "aborted" not in printed
    assert printed.count("run.yaml: is missing") == 2, "at the start, and at the end with the mend"
    assert printed.count("python -m pipeline.new_run") == 1
    recording = read_recording((folder / "recording.frames").read_bytes())
    assert (info(folder)["exit_status"], info(folder)["ended_by"]) == ("aborted", "person")
    assert f"{folder}: ended by Ctrl-C or kill, {info(folder)['samples']['received']} samples; frames: " in printed
    used = "what had come is kept, and its whole strokes are used like any run's"
    assert f"{folder}: the rig was not done; {used}" in printed
    assert info(folder)["samples"]["sent"] == info(folder)["samples"]["received"] == len(recording.time_s) > 10
    assert recording.account.end.reason == 1


def test_a_folder_that_nobody_described_is_named_at_the_start_and_recorded_all_the_same(rig, tmp_path):
    """A slip of the hand, raw/ for raw/example-2: 48 s were recorded before a word was said of it."""
    raw = tmp_path / "raw"
    for name, has_recording in (("example-1", True), ("example-2", False)):
        (raw / name).mkdir(parents=True)
        (raw / name / "run.yaml").write_text("run: it\n")
        if has_recording:
            (raw / name / "recording.frames").touch()
    done = run("pipeline.capture", rig("--pace", "10"), raw)
    first = done.stdout.splitlines()[0]
    meant = f"Did you mean {raw / 'example-2'}?"
    assert first == f"warning: {raw}: run.yaml: is missing. It can be recorded all the same. {meant}", done.stdout
    assert done.returncode == 0 and info(raw)["samples"]["received"] > 0


def test_after_a_recording_signals_do_what_they_did_before(rig, tmp_path):
    numbers = (signal.SIGINT, signal.SIGTERM)
    before = [signal.getsignal(number) for number in numbers]
    try:
        assert capture(str(rig("--pace", "inf")), tmp_path / "run-1", 1_000_000)["exit_status"] == "complete"
        assert [signal.getsignal(number) for number in numbers] == before
    finally:
        for number, done in zip(numbers, before, strict=True):
            signal.signal(number, done)


def test_a_killed_capture_loses_nothing_and_can_be_recovered(rig, tmp_path):
    port, folder = rig("--pace", "2"), tmp_path / "run-1"
    capture = start("pipeline.capture", port, folder)
    while not (folder / "recording.frames").exists() or (folder / "recording.frames").stat().st_size < 1500:
        assert capture.poll() is None, capture.stdout.read()
        time.sleep(0.02)
    assert "still being captured" in run("pipeline.capture", "--recover", folder).stderr
    assert "in use by another program" in run("pipeline.capture", port, tmp_path / "run-2").stderr
    capture.kill()
    capture.communicate()
    before = (folder / "recording.frames").read_bytes()
    assert run("pipeline.capture", "--recover", folder).returncode == 0
    assert (folder / "recording.frames").read_bytes() == before
    assert info(folder)["exit_status"] == "recovered" and info(folder)["samples"]["received"] > 10
    assert run("pipeline.capture", "--recover", folder).returncode == 2
    shutil.rmtree(folder)


def test_a_line_that_is_too_slow_is_refused(simulated):
    fast = Hello(**{**vars(simulated.hello), "rate_hz": 1000.0})
    check_rate(simulated.hello, 115_200, "port")
    with pytest.raises(BadInput, match="115200"):
        check_rate(fast, 115_200, "port")


@pytest.mark.parametrize("counted", [-1, 1])
def test_a_device_that_counts_wrongly_is_told(simulated, tmp_path, capsys, counted):
    heard = [decoded.frame for decoded in Decoder().feed(exact(simulated))]
    samples, reason = END.unpack(heard[-1].payload)
    for end, is_told in ((samples, False), (samples + counted, True)):
        frames = [*heard[:-1], Frame(Kind.END, heard[-1].seq, END.pack(end, reason))]
        path = tmp_path / "recording.frames"
        path.write_bytes(b"".join(encode(frame.kind, frame.seq, frame.payload) for frame in frames))
        now = datetime.now(UTC)
        tell_frames(account(Read.of(path), now, now, Outcome("complete")), tmp_path)
        assert ("lost frames do not explain it" in capsys.readouterr().out) == is_told


def test_a_devices_text_cannot_command_the_terminal():
    assert plain("rig \x1b]0;x\x07\x1b[2J\nµm\u202e") == "rig ?]0;x??[2J?µm?"
