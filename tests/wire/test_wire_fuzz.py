"""A short run of benchmarks/fuzz_decoder.py, where atheris is installed."""

import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

FUZZ = Path(__file__).resolve().parents[2] / "benchmarks" / "fuzz_decoder.py"


@pytest.mark.skipif(find_spec("atheris") is None, reason="atheris, which guides by coverage, is not installed")
def test_what_coverage_leads_to_is_borne_too():
    done = subprocess.run([sys.executable, str(FUZZ), "--seconds", "5"], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0 and "Done " in done.stderr, done.stderr[-3000:]
