"""The reference firmware: compiled for the Arduino, run in simavr, and its protocol on this computer."""

import json
import os
import re
import select
import signal
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest
import yaml
from firmware.builds import FIRMWARE, SMALL, for_the_uno, for_this_computer, running, simulator
from ready import start

from pipeline.ground.stored import schemas
from pipeline.wire import Decoder, Event, Frame, Kind, Reason, Recording, encode, read_recording
from pipeline.wire.frames import END, EVENT

FLASH_BYTES = 32 * 1024 - 512  # the boot loader takes the rest
RAM_BYTES = 2048 - 256  # so much for the stack
TOP_TURNS = 5.0
RADIUS_MM, LENGTH_MM = 1.0, 300.0  # of bench.h


@pytest.fixture(scope="module")
def board(tmp_path_factory) -> Path:
    return for_this_computer(tmp_path_factory.mktemp("firmware") / "board")


def capture(port: str, folder: Path) -> tuple[int, str, Recording, dict]:
    """Exit status, what was said, what was recorded, and capture.json."""
    program = start("pipeline.capture", port, folder)
    printed, _ = program.communicate(timeout=120)
    recorded = (folder / "recording.frames").read_bytes()
    return program.returncode, printed, read_recording(recorded), json.loads((folder / "capture.json").read_text())


def assert_whole(recording: Recording, info: dict) -> None:
    """All that was sent is there, and it is what motor, string and load cell did."""
    assert info["exit_status"] == "complete"
    assert info["frames"]["lost"] == info["frames"]["bad"] == 0 and info["frames"]["tail_bytes"] == 0
    assert info["samples"]["sent"] == info["samples"]["received"] == len(recording.time_s)
    events = [(event.code, event.value) for event in recording.events]
    assert events == [(code, number) for number in (1, 2) for code in (Event.STROKE_START, Event.STROKE_END)]
    turns, measured_mm = recording.channels["motor_turns"], recording.channels["displacement_mm"]
    assert (turns.min(), turns.max()) == (0.0, TOP_TURNS)
    expected_mm = LENGTH_MM - np.sqrt(LENGTH_MM**2 - (2 * np.pi * turns * RADIUS_MM) ** 2)
    np.testing.assert_allclose(measured_mm, expected_mm, atol=0.015)
    np.testing.assert_allclose(recording.channels["load_n"], 20.02, atol=0.1)
    np.testing.assert_allclose(np.diff(recording.time_s), 1e-3, atol=1e-4)


def test_it_compiles_for_the_uno_without_a_warning_and_fits(tmp_path):
    elf = for_the_uno(tmp_path / "rig.elf")
    listing = subprocess.run(["avr-size", "-A", str(elf)], capture_output=True, text=True, check=True).stdout
    sizes = {name: int(size) for name, size in re.findall(r"^\.(\w+)\s+(\d+)", listing, re.M)}
    flash, ram = sizes["text"] + sizes["data"], sizes["data"] + sizes["bss"]
    assert 0 < flash <= FLASH_BYTES and 0 < ram <= RAM_BYTES, f"{flash} bytes of flash, {ram} of RAM"


@pytest.mark.long
def test_on_the_simulated_uno_it_is_recorded_without_a_loss_and_cut_into_strokes(tmp_path):
    elf, uno = for_the_uno(tmp_path / "rig.elf", *SMALL), simulator(tmp_path / "uno")
    folder, processed = tmp_path / "raw" / "uno-1", tmp_path / "processed"
    with running(uno, elf, PACE=2) as port:
        status, printed, recording, info = capture(port, folder)
    assert status == 0, printed
    assert_whole(recording, info)
    assert info["hello"]["nonce"] == "00000001"  # counted in the EEPROM
    string = {"material": "UHMWPE", "radius_mm": RADIUS_MM, "length_mm": LENGTH_MM, "stiffness_n_per_mm": 30}
    (folder / "run.yaml").write_text(yaml.safe_dump({"run": "uno-1", "actuator": "twisted_pair", "string": string}))
    samples, strokes = processed / "samples.parquet", processed / "strokes.parquet"
    program = start("pipeline.stages.ingest", folder, "--out", samples, "--out-strokes", strokes)
    printed, _ = program.communicate(timeout=120)
    assert program.returncode == 0, printed
    stroke_table = schemas.read(strokes, schemas.STROKES)
    assert stroke_table.loc[stroke_table["phase"] == "winding", "stroke"].tolist() == [1, 2]
    assert stroke_table.loc[stroke_table["phase"] == "unwinding", "stroke"].tolist() == [1, 2]


def test_a_reset_of_the_simulated_uno_is_told_by_its_second_hello(tmp_path):
    elf, uno = for_the_uno(tmp_path / "rig.elf", *SMALL), simulator(tmp_path / "uno")
    with running(uno, elf, PACE=2, RESET_AFTER_STEPS=1000) as port:
        status, printed, recording, info = capture(port, tmp_path / "uno-1")
    assert status == 1 and "the device was reset" in printed
    assert info["hello"]["nonce"] == "00000001" and info["frames"]["resets"] == 1
    assert len(recording.time_s) > 500 and info["frames"]["lost"] == 0


def test_the_protocols_code_is_recorded_without_a_loss_here_too(board, tmp_path):
    first_us = 2**32 - 3_000_000  # so that its clock wraps
    with running(board, PACE=8, FIRST_US=first_us) as port:
        status, printed, recording, info = capture(port, tmp_path / "pc-1")
    assert status == 0, printed
    assert_whole(recording, info)
    assert [channel["name"] for channel in info["hello"]["channels"]] == ["motor_turns", "displacement_mm", "load_n"]


def test_its_frames_are_those_of_our_encoder(board, tmp_path):
    with running(board, PACE=20) as port:
        capture(port, tmp_path / "pc-1")
    data = (tmp_path / "pc-1" / "recording.frames").read_bytes()
    heard = Decoder().feed(data)
    assert len(heard[0].raw) > 255  # so that stuffing goes over a full group
    assert b"".join(encode(decoded.frame.kind, decoded.frame.seq, decoded.frame.payload) for decoded in heard) == data


@pytest.mark.parametrize(
    ("setting", "value"), [({"STALL_TURNS": 3.0}, 1), ({"SKIPPED_AT": 900}, 2)], ids=["motor stalls", "encoder skips"]
)
def test_what_it_cannot_trust_ends_the_run_as_a_fault(board, tmp_path, setting, value):
    with running(board, PACE=8, **setting) as port:
        status, printed, recording, info = capture(port, tmp_path / "pc-1")
    assert status == 1 and "reported a fault" in printed
    assert info["exit_status"] == "fault" and recording.account.end.reason == Reason.FAULT
    assert (recording.events[-1].code, recording.events[-1].value) == (Event.FAULT, value)


@pytest.mark.parametrize(("setting", "lost"), [("NO_ROOM_AT", 1), ("MISSED_AT", 3)])
def test_what_it_cannot_send_is_counted_and_located(board, tmp_path, setting, lost):
    with running(board, PACE=8, **{setting: 900}) as port:
        status, printed, recording, info = capture(port, tmp_path / "pc-1")
    assert status == 0 and info["exit_status"] == "complete", printed
    assert info["frames"]["lost"] == lost == info["samples"]["sent"] - len(recording.time_s)
    (gap,) = info["gaps"]
    assert gap["frames"] == lost and gap["strokes"] == [1]


def test_a_run_that_is_stopped_ends_in_good_order_and_the_next_one_winds_back_first(board, tmp_path):
    folder = tmp_path / "pc-1"
    with running(board, PACE=4) as port:
        program = start("pipeline.capture", port, folder)
        until_s = time.monotonic() + 30
        while not (folder / "recording.frames").exists() or (folder / "recording.frames").stat().st_size < 40_000:
            assert program.poll() is None and time.monotonic() < until_s
            time.sleep(0.02)
        program.send_signal(signal.SIGINT)
        printed, _ = program.communicate(timeout=30)
        info = json.loads((folder / "capture.json").read_text())
        assert program.returncode == 0 and info["exit_status"] == "aborted" and info["frames"]["lost"] == 0, printed
        stopped_at = read_recording((folder / "recording.frames").read_bytes()).channels["motor_turns"][-1]
        assert stopped_at > 0.5
        status, printed, recording, info = capture(port, tmp_path / "pc-2")
    assert status == 0, printed
    assert info["frames"]["lost"] == 0 and recording.channels["motor_turns"][0] == pytest.approx(stopped_at, abs=0.2)
    assert [event.value for event in recording.events] == [1, 1, 2, 2]
    first = int(np.searchsorted(recording.time_s, recording.events[0].time_s))
    assert recording.channels["motor_turns"][first] == 0


class Talk:
    """A host that says what a test wants."""

    def __init__(self, port: str) -> None:
        self.end = os.open(port, os.O_RDWR | os.O_NOCTTY)
        self.decoder = Decoder()
        self.came: list[Frame] = []
        self.passed: list[Frame] = []

    def say(self, data: bytes) -> None:
        os.write(self.end, data)

    def hear(self, within_s: float) -> list[bytes]:
        """Frames that come within a time."""
        raw_frames, until_s = [], time.monotonic() + within_s
        while (left_s := until_s - time.monotonic()) > 0:
            if select.select([self.end], [], [], left_s)[0]:
                raw_frames += [decoded.raw for decoded in self.decoder.feed(os.read(self.end, 4096))]
        return raw_frames

    def until(self, kind: int, within_s: float = 120.0) -> list[Frame]:
        """Frames up to the first of a kind; a simulated board may be far slower than life."""
        until_s = time.monotonic() + within_s
        while time.monotonic() < until_s:
            while self.came:
                self.passed.append(self.came.pop(0))
                if self.passed[-1].kind == kind:
                    passed, self.passed = self.passed, []
                    return passed
            if select.select([self.end], [], [], 0.1)[0]:
                self.came += [decoded.frame for decoded in self.decoder.feed(os.read(self.end, 4096))]
        raise AssertionError(f"no frame of kind {kind:#x} came")


def kinds(frames: list[bytes]) -> list[int]:
    return [decoded.frame.kind for decoded in Decoder().feed(b"".join(frames))]


def test_it_obeys_good_frames_only_and_says_end_until_it_is_acknowledged(board):
    broken = bytearray(encode(Kind.START, 1))
    broken[2] ^= 0x20
    with running(board, PACE=1) as port:
        host = Talk(port)
        host.say(bytes(range(1, 256)) * 3 + b"\0\0\1\0" + encode(Kind.GREET, 0) + bytes(broken))
        frames = host.hear(0.7)
        assert set(kinds(frames)) == {Kind.HELLO} and len(set(frames)) == 1  # at boot, and when it was greeted
        host.say(encode(Kind.START, 1))
        recorded = host.hear(0.5)
        assert kinds(recorded)[0] == Kind.SAMPLE and Kind.END not in kinds(recorded)
        host.say(encode(Kind.STOP, 2))
        recorded += host.hear(1.0)
        heard = [frame for frame in recorded if kinds([frame]) == [Kind.END]]
        assert len(heard) >= 3 and len(set(heard)) == 1
        (end,) = [decoded.frame for decoded in Decoder().feed(heard[0])]
        assert END.unpack(end.payload) == (kinds(recorded).count(Kind.SAMPLE), Reason.STOPPED)
        host.say(encode(Kind.ACK, end.seq + 1))
        assert set(kinds(host.hear(0.5))) == {Kind.END}
        host.say(encode(Kind.ACK, end.seq))
        host.hear(0.3)
        assert host.hear(0.7) == []
        os.close(host.end)


def test_it_sends_what_the_page_says():
    page = (FIRMWARE.parent / "docs" / "protocol.md").read_text()
    code = (FIRMWARE / "wire.h").read_text()
    for kind in Kind:
        assert f"{kind.name} = 0x{kind.value:02X}" in code and f"`0x{kind.value:02X}` {kind.name}" in page
    assert EVENT.size == 9
