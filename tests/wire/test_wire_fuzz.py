"""What a device says, good and damaged frames and noise in any order, is borne by all that hears it.

benchmarks/fuzz_decoder.py looks for longer, guided by coverage, where atheris is installed.
"""

import importlib
import json
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"


@pytest.fixture(scope="module")
def target():
    """The fuzzer's target."""
    sys.path.insert(0, str(BENCHMARKS))
    try:
        return importlib.import_module("fuzz_decoder")
    finally:
        sys.path.remove(str(BENCHMARKS))


@given(st.binary(min_size=1, max_size=3000))
def test_whatever_is_said_is_borne(target, data):
    target.one(data)


def test_the_target_says_good_frames_greetings_and_noise(target):
    chunks, _ = target.said(bytes(range(256)) * 8)
    kinds = {heard.frame.kind for chunk in chunks for heard in target.Decoder().feed(chunk)}
    assert {target.Kind.HELLO, target.Kind.SAMPLE} <= kinds and len(chunks) > 50


def test_a_gap_that_is_lost_in_the_account_is_noticed(target, monkeypatch):
    lossy = [target.encode(target.Kind.SAMPLE, number, b"\1" * 10) for number in (1, 9)]
    hello = target.encode(target.Kind.HELLO, 0, json.dumps(json.loads(target.HELLO)).encode())
    monkeypatch.setattr(target, "said", lambda data: ([hello, *lossy], data))
    target.one(b"1")
    real = target.read_recording

    def forgetful(log):
        recording = real(log)
        return replace(recording, account=replace(recording.account, gaps=()))

    monkeypatch.setattr(target, "read_recording", forgetful)
    with pytest.raises(AssertionError):
        target.one(b"1")
