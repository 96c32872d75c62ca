"""Faults of the host: its program, its disk, its port, its files."""

import os
import resource
import shutil
import signal
import time
from pathlib import Path

import pytest
from bench import Bench, Row, check, complete, refused, row
from scripted_device import MARKS, frames, link

from pipeline.ground.errors import BadInput
from pipeline.run.table.recorded_table import read_frames
from pipeline.wire import Kind

DAY_S = 86_400


def _until_written(bench: Bench, size: int, number: int = 1) -> None:
    until_s = time.monotonic() + 30
    path = bench.run(number) / "recording.frames"
    while not path.exists() or path.stat().st_size < size:
        assert time.monotonic() < until_s, "the host wrote less than it got"
        time.sleep(0.01)


def killed(bench: Bench) -> Row:
    """The program is killed with SIGKILL; --recover finds all that it had read."""
    true_frames = frames()
    came = b"".join(true_frames[:41]) + true_frames[41][:5]
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.begin(true_frames)
    rig.say(came[len(true_frames[0]) :])
    _until_written(bench, len(came))
    host.process.kill()
    host.wait()
    assert bench.recorded() == came and not (bench.run() / "capture.json").exists()
    recovery = bench.capture("--recover", bench.run())
    assert recovery.wait() == 0 and bench.recorded() == came
    info = check(bench, true_frames)
    assert info["exit_status"] == "recovered" and info["frames"]["tail_bytes"] == 5
    return row(bench, host, recovery, lost="nothing that had been read")


def unplugged(bench: Bench) -> Row:
    """The cable is pulled and plugged in again: the run is a fault, the next one is whole."""
    true_frames, again = frames(), frames(nonce="00000002")
    rig = bench.rig()
    port = link(rig, bench.folder / "PORT")
    first = bench.capture(port, bench.run(1))
    rig.begin(true_frames)
    rig.say(*true_frames[1:41])
    _until_written(bench, len(b"".join(true_frames[:41])))
    rig.unplug()
    assert first.wait() == 1
    rig = bench.rig()
    link(rig, port)
    second = bench.capture(port, bench.run(2))
    assert complete(bench, rig, second, again, again[1:]) == 0
    info = check(bench, true_frames, 1)
    assert bench.recorded(1) == b"".join(true_frames[:41]) and info["exit_status"] == "fault"
    check(bench, again, 2)
    assert bench.recorded(2) == b"".join(again)
    return row(bench, first, second, lost="what was sent while unplugged; how much, nobody said")


def stalled(bench: Bench) -> Row:
    """The host stands still for 2 s while a device with a small buffer goes on."""
    true_frames = frames(20_000)
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.begin(true_frames)
    rig.say(*true_frames[1:100])
    _until_written(bench, len(b"".join(true_frames[:100])))
    host.process.send_signal(signal.SIGSTOP)
    began_s = time.monotonic()
    sent, rest = rig.say_what_fits(true_frames[100:-1])
    dropped = len(true_frames) - 101 - len(sent)
    assert dropped > 0  # or the stall was none
    time.sleep(max(0.0, 2.0 - (time.monotonic() - began_s)))
    host.process.send_signal(signal.SIGCONT)
    rig.say(rest, true_frames[-1])
    rig.hear(Kind.ACK)
    assert host.wait() == 0
    info = check(bench, true_frames)
    assert bench.recorded() == b"".join([*true_frames[:100], *sent, true_frames[-1]])
    assert info["frames"]["lost"] == dropped and info["frames"]["bad"] == 0
    reported = f"{info['exit_status']}; lost: as many frames as the device dropped"
    return Row("all that the line's buffer held", reported, "what the device dropped, counted and located")


def second_capture(bench: Bench) -> Row:
    """Another capture is started on the port in use: it is refused, the first goes on."""
    true_frames = frames()
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.begin(true_frames)
    rig.say(*true_frames[1:31])
    second = bench.capture(rig.name, bench.run(2))
    rest = b"".join(true_frames[31:])
    while second.process.poll() is None:  # the first goes on: it must not think the rig silent
        rig.say(rest[:1])
        rest = rest[1:]
        time.sleep(0.1)
    assert second.wait() == 2 and not bench.run(2).exists()
    rig.say(rest)
    rig.hear(Kind.ACK)
    assert host.wait() == 0
    check(bench, true_frames)
    assert bench.recorded() == b"".join(true_frames)
    return row(bench, host, second)


def disk_full(bench: Bench) -> Row:
    """The disk is full in the middle of the run."""
    true_frames = frames()
    size = len(b"".join(true_frames[:41])) + 7
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run(), limit=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
    rig.begin(true_frames)
    rig.say(*true_frames[1:])
    assert host.wait() == 2 and "Traceback" not in host.said
    assert bench.recorded() == b"".join(true_frames)[:size] and not (bench.run() / "capture.json").exists()
    recovery = bench.capture("--recover", bench.run())
    assert recovery.wait() == 0
    info = check(bench, true_frames)
    assert info["exit_status"] == "recovered" and info["frames"]["tail_bytes"] == 7
    return row(bench, host, recovery, lost="what came after the disk was full; the END, so its number too, among it")


def disk_full_at_the_end(bench: Bench) -> Row:
    """The disk is full when capture.json is to be written."""
    true_frames = frames(12)
    size = len(b"".join(true_frames))
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run(), limit=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
    assert complete(bench, rig, host, true_frames, true_frames[1:]) == 2 and "Traceback" not in host.said
    assert bench.recorded() == b"".join(true_frames) and not (bench.run() / "capture.json").exists()
    recovery = bench.capture("--recover", bench.run())
    assert recovery.wait() == 0
    check(bench, true_frames)
    return row(bench, host, recovery)


def killed_after_ack(bench: Bench) -> Row:
    """The program is killed when it has acknowledged the END and not yet written capture.json."""
    true_frames = frames()
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.begin(true_frames)
    rig.say(*true_frames[1:])
    rig.hear(Kind.ACK)
    host.process.kill()
    host.wait()
    (bench.run() / "capture.json").unlink(missing_ok=True)  # if it was as quick as that
    recovery = bench.capture("--recover", bench.run())
    assert recovery.wait() == 0
    info = check(bench, true_frames)
    assert info["exit_status"] == "complete" and info["recovered"] and bench.recorded() == b"".join(true_frames)
    return row(bench, recovery)


def into_the_parent(bench: Bench) -> Row:
    """RUN_DIR is `..`, whose real name would do."""
    bench.run().mkdir(parents=True)
    host = bench.capture(bench.rig().name, f"{bench.run()}/..")
    assert host.wait() == 2 and "Traceback" not in host.said
    assert not list(bench.folder.glob("**/recording.*"))
    bench.run().rmdir()
    return refused(bench, host, arrived="nothing")


def bare_system(bench: Bench) -> Row:
    """The system has no fcntl, no termios, no pseudo-terminals of its own, no fdatasync."""
    true_frames = frames()
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run(), bare=True)
    assert complete(bench, rig, host, true_frames, true_frames[1:]) == 0
    check(bench, true_frames)
    assert bench.recorded() == b"".join(true_frames)
    return row(bench, host)


def port_forbidden(bench: Bench) -> Row:
    """The port may not be opened."""
    rig = bench.rig()
    os.chmod(rig.name, 0o000)
    host = bench.capture(rig.name, bench.run(), nobody=True)
    assert host.wait() == 2 and "Traceback" not in host.said
    return refused(bench, host, arrived="nothing")


def folder_forbidden(bench: Bench) -> Row:
    """The folder may not be written."""
    rig = bench.rig()
    true_frames = frames()
    os.chmod(rig.name, 0o666)
    bench.run().parent.mkdir()
    bench.run().parent.chmod(0o555)
    host = bench.capture(rig.name, bench.run(), nobody=True)
    rig.hear(Kind.GREET)
    rig.say(true_frames[0])
    assert host.wait() == 2 and "Traceback" not in host.said
    bench.run().parent.chmod(0o755)
    return refused(bench, host, arrived="a HELLO; the device was not started")


def truncated(bench: Bench) -> Row:
    """A finished recording is cut off."""
    return _spoiled(bench, lambda data: data[:-100])


def tampered(bench: Bench) -> Row:
    """A sample of a finished recording is replaced by another good frame."""
    true_frames = frames()
    return _spoiled(bench, lambda data: data.replace(true_frames[20], true_frames[21]))


def _spoiled(bench: Bench, spoil) -> Row:
    true_frames = frames()
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    assert complete(bench, rig, host, true_frames, true_frames[1:]) == 0
    check(bench, true_frames)
    path = bench.run() / "recording.frames"
    assert path.stat().st_mode & 0o222 == 0  # nobody does it by mistake
    read_frames(path)
    spoilt = spoil(path.read_bytes())
    assert spoilt != path.read_bytes()
    path.unlink()
    path.write_bytes(spoilt)
    with pytest.raises(BadInput) as refusal:
        read_frames(path)
    again = bench.capture("--recover", bench.run())
    assert again.wait() == 2
    reported = str(refusal.value).replace(f"{bench.folder}/raw", "raw")
    return Row("66 of 66 frames, then changed", f"{reported} / {bench.plain(again)}", "the run: nothing uses it")


def a_day(bench: Bench) -> Row:
    """A day's frames at 10 Hz, as fast as they go; the device's clock wraps 20 times."""
    count = DAY_S * 10
    true_frames = frames(count, step_us=100_000)
    rig = bench.rig()
    host = bench.capture(rig.name, bench.run())
    rig.begin(true_frames)
    body = b"".join(true_frames[1:])
    rig.say(body[: len(body) // 8])
    early = _memory_kb(host.process.pid)
    rig.say(body[len(body) // 8 : -len(true_frames[-1])])
    late = _memory_kb(host.process.pid)
    assert late - early < 4000, (early, late)
    rig.say(true_frames[-1])
    rig.hear(Kind.ACK)
    assert host.wait(120) == 0
    info = check(bench, true_frames)
    assert (info["samples"]["sent"], info["samples"]["received"]) == (count, count)
    assert info["frames"]["received"] == count + len(MARKS) + 2 and info["bytes"] == len(true_frames[0]) + len(body)
    shutil.rmtree(bench.run())
    return Row(f"{info['frames']['received']} of {info['frames']['sent']} frames", "complete", "nothing")


def _memory_kb(process: int) -> int:
    lines = Path(f"/proc/{process}/status").read_text().splitlines()
    return int(next(line.split()[1] for line in lines if line.startswith("VmRSS")))


FAULTS = {
    "host program killed (SIGKILL)": killed,
    "unplugged and plugged in again": unplugged,
    "host stands still for 2 s": stalled,
    "second capture on the same port": second_capture,
    "disk full in the run": disk_full,
    "disk full at the end": disk_full_at_the_end,
    "killed when END was acknowledged": killed_after_ack,
    "RUN_DIR is `..`": into_the_parent,
    "a system without fcntl, termios and fdatasync": bare_system,
    "port without permission": port_forbidden,
    "folder without permission": folder_forbidden,
    "recording truncated": truncated,
    "recording tampered with": tampered,
    "24 hours of frames (10 Hz, accelerated)": a_day,
}
