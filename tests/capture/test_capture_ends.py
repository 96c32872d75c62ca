"""How a recording ends when its device does not end it, and what one bad stamp costs a run that is read."""

import numpy as np
import pytest
import ready
from faults.scripted_device import SAMPLES, frames, hello

from pipeline.capture import stream
from pipeline.capture.commit import recover
from pipeline.capture.stream import Outcome, record
from pipeline.ground.errors import BadInput
from pipeline.rig.device import Device
from pipeline.rig.record import describe
from pipeline.rig.recorded_at_once import simulate
from pipeline.rig.setup import read_setup
from pipeline.run.samples import read_samples
from pipeline.run.table.captured import read_frames
from pipeline.wire import Decoder, Kind, encode


class Line:
    """A port in our hands: hands out chunks, the last of them for ever, and keeps what the host says."""

    def __init__(self, chunks: list[bytes]) -> None:
        self.chunks, self.written = chunks, b""

    def read(self) -> bytes:
        return self.chunks.pop(0) if len(self.chunks) > 1 else self.chunks[0]

    def write(self, data: bytes) -> None:
        self.written += data

    @property
    def heard(self) -> list[int]:
        return [decoded.frame.kind for decoded in Decoder().feed(self.written)]


class Kept:
    """A log that only keeps."""

    free_bytes = 10**9

    def __init__(self) -> None:
        self.data = b""

    def append(self, data: bytes) -> None:
        self.data += data

    def sync(self) -> None:
        pass


@pytest.mark.parametrize(
    "again", [frames()[0], b"x", encode(99, 3, b"1"), b"\0"], ids=["HELLO", "byte", "kind", "zero"]
)
def test_bytes_without_a_new_frame_are_not_recorded_for_ever(monkeypatch, again):
    monkeypatch.setattr(stream, "IDLE_S", 0.3)
    port, log = Line([b"".join(frames()[1:9]), again]), Kept()
    outcome = record(port, log, hello(), lambda: 0)
    assert outcome.status == "fault" and "no new frame for" in outcome.fault
    assert port.heard == [Kind.START] and log.data.startswith(b"".join(frames()[1:9]))


def test_a_device_that_does_not_stop_is_left(monkeypatch):
    monkeypatch.setattr(stream, "STOP_S", 0.2)
    encoded_frames = frames(100_000)
    outcome = record(Line([b"", *encoded_frames[1:-1]]), Kept(), hello(), lambda: 0, longest_s=0.1)
    assert outcome == Outcome("fault", "the device went on though it was told to stop", "--longest after 0.1 s")


def test_a_word_of_stop_that_is_obeyed_is_no_fault():
    encoded_frames = frames()
    stop_flags = iter([0, 0, 1, 1, 1, 1, 1, 1])
    port = Line([*encoded_frames[1:6], b"".join(encoded_frames[6:])])
    assert record(port, Kept(), hello(), lambda: next(stop_flags, 1)) == Outcome("aborted", None, "person")
    assert port.heard == [Kind.START, Kind.STOP, Kind.ACK]


@pytest.fixture(scope="module")
def small():
    """Frames of the small synthetic rig."""
    device = Device(simulate(read_setup("small"), 3))
    device.hear(encode(Kind.GREET, 0))
    sent = device.speak()
    device.hear(encode(Kind.START, 0))
    while device.recording:
        sent += device.speak()
    return [decoded.frame for decoded in Decoder().feed(sent)]


def recorded(small, folder, stamps: dict[int, int]):
    """A committed run folder of these frames; `stamps` has us that are added to those of some."""
    describe(read_setup("small"), folder)
    encoded_frames = []
    for number, frame in enumerate(small):
        payload = frame.payload
        if number in stamps:
            t_us = (int.from_bytes(payload[:4], "little") + stamps[number]) % 2**32
            payload = t_us.to_bytes(4, "little") + payload[4:]
        encoded_frames.append(encode(frame.kind, frame.seq, payload))
    (folder / "recording.frames").write_bytes(b"".join(encoded_frames))
    return recover(folder)


def test_one_bad_stamp_does_not_cost_the_run(small, tmp_path):
    good, bad = tmp_path / "good-1", tmp_path / "bad-1"
    samples = [number for number, frame in enumerate(small) if frame.kind == Kind.SAMPLE]
    recorded(small, good, {})
    info = recorded(small, bad, {samples[600]: -65_536, samples[900]: -50_000})
    assert info["exit_status"] == "complete" and info["recovered"]
    assert (info["samples"]["backward_time_stamps"], info["samples"]["repeated_time_stamps"]) == (1, 1)
    out = tmp_path / "samples.parquet"
    done = ready.run("pipeline.stages.ingest", bad, "--out", out)
    assert done.returncode == 0, done.stderr
    assert "recording.frames: mended 1 backward time stamps, 1 repeated time stamps" in done.stderr
    (_, right), (_, mended) = read_samples(good), read_samples(bad)
    np.testing.assert_allclose(mended["time_s"], right["time_s"], atol=1e-5)
    assert mended.drop(columns="time_s").equals(right.drop(columns="time_s"))


def test_a_run_without_a_clock_is_refused_with_the_mend(small, tmp_path):
    first = next(frame for frame in small if frame.kind == Kind.SAMPLE).payload[:4]
    folder = tmp_path / "run-1"
    folder.mkdir()
    stands = [frame.payload if frame.kind != Kind.SAMPLE else first + frame.payload[4:] for frame in small]
    encoded_frames = [encode(frame.kind, frame.seq, payload) for frame, payload in zip(small, stands, strict=True)]
    (folder / "recording.frames").write_bytes(b"".join(encoded_frames))
    info = recover(folder)
    assert info["exit_status"] == "fault" and "clock stands or runs backwards" in info["fault"]
    with pytest.raises(BadInput, match=r"t_us: stands or runs backwards .* Mend: correct the clock in the firmware"):
        read_frames(folder / "recording.frames")


def test_a_complete_recording_without_a_sample_is_a_fault(tmp_path):
    (tmp_path / "recording.frames").write_bytes(b"".join(frames(0)))
    info = recover(tmp_path)
    assert (info["exit_status"], info["fault"]) == ("fault", "it holds no sample")


def test_an_unreadable_capture_json_is_made_again(tmp_path):
    (tmp_path / "recording.frames").write_bytes(b"".join(frames()))
    (tmp_path / "capture.json").write_text('{"schema": 1, "exit_st')
    assert recover(tmp_path)["samples"]["received"] == SAMPLES
    with pytest.raises(BadInput, match="is finished"):
        recover(tmp_path)
