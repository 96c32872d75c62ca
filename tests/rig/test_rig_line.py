"""The name of the rig's port: one rig's alone while it runs, and free once it has ended."""

import os
import signal
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]


def start(link):
    command = [sys.executable, "-m", "pipeline.rig", "small", "--link", str(link)]
    return subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def test_a_second_rig_takes_no_link_of_a_live_one_and_a_stale_one_is_replaced(tmp_path):
    link = tmp_path / "port"
    link.symlink_to("/dev/pts/of-a-rig-that-was-killed")
    first = start(link)
    try:
        assert "Ctrl-C ends it" in first.stdout.readline()
        port = os.readlink(link)
        _, said = (second := start(link)).communicate(timeout=300)
        assert second.returncode == 2 and "another rig is there. Mend: end it, or choose another --link" in said
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
