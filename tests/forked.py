"""The child process that reads MATLAB files, forked from the tests, which spares it the imports: a fuzz starts many.

It dies alone all the same when a damaged byte crashes the library.
"""

import faulthandler
import os
import subprocess
import sys
import tempfile
import warnings
from types import SimpleNamespace

import pytest

from pipeline.formats import matlab, matlab_child


def _run(command: list[str], **_: object) -> subprocess.CompletedProcess[bytes]:
    """What `subprocess.run` of the reader gives."""
    assert command[1:3] == ["-m", matlab_child.__name__]
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as complained, warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # of a fork beside threads, which the child has no use for
        child = os.fork()
        if child == 0:
            _read(command[2:], output.fileno(), complained.fileno())
        status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        output.seek(0), complained.seek(0)
        return subprocess.CompletedProcess(command, status, output.read(), complained.read())


def _read(words: list[str], output_fd: int, complained: int) -> None:
    """Be the reader, and end."""
    status = 1
    try:
        faulthandler.disable()
        os.dup2(output_fd, 1), os.dup2(complained, 2)
        sys.argv, sys.stderr = words, os.fdopen(2, "w", closefd=False)
        matlab_child.main()
    except SystemExit as end:
        status = int(end.code or 0)
    finally:
        sys.stderr.flush()
        os._exit(status)


def fork_the_reader(monkeypatch: pytest.MonkeyPatch) -> None:
    """From now on a test's MATLAB files are read in forks."""
    monkeypatch.setattr(matlab, "subprocess", SimpleNamespace(run=_run))
