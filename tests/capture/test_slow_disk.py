"""A disk that is slow for a while keeps no rig waiting, and one that fails is told of."""

import errno
import os
import threading

import pytest

from pipeline.capture import log
from pipeline.capture.log import NAME, Log


def test_bytes_are_taken_while_the_disk_is_busy(tmp_path, monkeypatch):
    monkeypatch.setattr(log, "SYNC_S", 0.0)
    done, begun = threading.Event(), []
    monkeypatch.setattr(os, "fdatasync", lambda file: (begun.append(file), done.wait(60)))
    recording_log = Log(tmp_path / "run-1")
    for byte in b"abc":
        recording_log.append(bytes([byte]))  # would wait a minute for the disk
    assert (tmp_path / "run-1" / NAME).read_bytes() == b"abc" and len(begun) <= 1
    done.set()
    recording_log.sync()
    assert len(begun) == 2, "what came since is put on the disk too"
    recording_log.close()


def test_a_disk_that_fails_ends_the_recording(tmp_path, monkeypatch):
    monkeypatch.setattr(log, "SYNC_S", 0.0)

    def full(file: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fdatasync", full)
    recording_log = Log(tmp_path / "run-1")
    recording_log.append(b"a")
    with pytest.raises(OSError, match="No space"):
        recording_log.sync()
    recording_log.close()
