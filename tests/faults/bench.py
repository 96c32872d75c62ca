"""The capture program on one side, scripted rigs on the other, and what came of it as a line of the fault table."""

import hashlib
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import ready
from scripted_device import Rig

from pipeline.wire import Kind, read_recording

ROOT = Path(__file__).resolve().parents[2]
# as another user, but with our modules: the project may lie where that user cannot read
AS_NOBODY = (
    "import os; import pipeline.capture.__main__ as program; "
    "os.setgroups([]); os.setgid(65534); os.setuid(65534); program.main()"
)
# as on a system that has none of these
BARE = (
    "import os, sys; import serial; del os.fdatasync, os.fstatvfs, os.O_DIRECTORY; "
    "sys.modules.update(dict.fromkeys(('fcntl', 'termios', 'pty', 'tty'))); "
    "import pipeline.rig.__main__; import pipeline.capture.__main__ as program; program.main()"
)

# what differs from run to run, or belongs to no fault
UNSAID = "recorded, | passed, |^scripted rig, |^recording; Ctrl-C|^reads |run.yaml: is missing"


@dataclass(frozen=True)
class Row:
    """A line of the fault table; numbers and sentences are the run's, words stand only for what cannot be counted."""

    arrived: str
    reported: str
    lost: str


@dataclass
class Host:
    """A capture program at work."""

    process: ready.Program | subprocess.Popen[str]
    output: Path

    def wait(self, within_s: float = 60.0) -> int:
        """Its exit status, when it ends."""
        return self.process.wait(within_s)

    @property
    def said(self) -> str:
        """What it has printed so far."""
        return self.output.read_text()


@dataclass
class Bench:
    """One test's folder, rigs and hosts."""

    folder: Path
    rigs: list[Rig] = field(default_factory=list)
    hosts: list[Host] = field(default_factory=list)

    def run(self, number: int = 1) -> Path:
        """Folder of a run."""
        return self.folder / "raw" / f"run-{number}"

    def rig(self) -> Rig:
        """Another scripted rig."""
        self.rigs.append(Rig())
        return self.rigs[-1]

    def capture(
        self,
        *arguments: Any,
        nobody: bool = False,
        bare: bool = False,
        limit: Callable[[], None] | None = None,
        cwd: Path = ROOT,
    ) -> Host:
        """Start the program; `bare` on a system without POSIX."""
        what = ["-c", AS_NOBODY] if nobody and os.geteuid() == 0 else ["-m", "pipeline.capture"]
        what = ["-c", BARE] if bare else what
        output = self.folder / f"said-{len(self.hosts)}"
        process: ready.Program | subprocess.Popen[str]
        with output.open("w") as file:
            if limit or what[0] == "-c":
                command = [sys.executable, *what, *map(str, arguments)]
                process = subprocess.Popen(command, stdout=file, stderr=subprocess.STDOUT, cwd=cwd, preexec_fn=limit)
            else:
                process = ready.start("pipeline.capture", *arguments, cwd=cwd, output=file)
        self.hosts.append(Host(process, output))
        return self.hosts[-1]

    def close(self) -> None:
        """End what is left."""
        for host in self.hosts:
            if host.process.poll() is None:
                host.process.kill()
                host.process.wait()
        for rig in self.rigs:
            rig.unplug()

    def recorded(self, number: int = 1) -> bytes:
        """Bytes of a run's recording."""
        return (self.run(number) / "recording.frames").read_bytes()

    def info(self, number: int = 1) -> dict[str, Any]:
        """A run's capture.json."""
        content: dict[str, Any] = json.loads((self.run(number) / "capture.json").read_text())
        return content

    def plain(self, *hosts: Host) -> str:
        """What hosts have said, one sentence a line, without what differs from run to run."""
        text = "\n".join(host.said for host in hosts)
        for rig in self.rigs:
            text = text.replace(rig.name, "PORT")
        text = text.replace(f"{self.folder}/raw", "raw").replace(f"{self.folder}/", "")
        lines = [line for line in text.splitlines() if line and not re.search(UNSAID, line)]
        return " / ".join(line.removeprefix("error: ") for line in lines)


def check(bench: Bench, true_frames: list[bytes], number: int = 1) -> dict[str, Any]:
    """Assert that a committed run accounts for itself, and that each sample is one of `true_frames`."""
    data, info = bench.recorded(number), bench.info(number)
    assert info["sha256"] == hashlib.sha256(data).hexdigest() and info["bytes"] == len(data)
    counts = info["frames"]
    assert counts["sent"] == counts["received"] + counts["lost"]
    assert sum(gap["frames"] for gap in info["gaps"]) == counts["lost"]
    recorded, truth = read_recording(data), read_recording(b"".join(true_frames))
    samples = info["samples"]
    assert len(recorded.time_s) == samples["received"]
    assert samples["sent"] is None or 0 <= samples["sent"] - samples["received"] <= counts["lost"]
    order = np.searchsorted(truth.seq, recorded.seq)
    np.testing.assert_array_equal(truth.seq[order], recorded.seq)
    for name, values in recorded.channels.items():
        np.testing.assert_array_equal(values, truth.channels[name][order])
    if len(recorded.time_s):
        since_s = truth.time_s[order] - truth.time_s[order[0]]
        np.testing.assert_allclose(recorded.time_s, since_s, atol=1e-6)
    return info


def row(bench: Bench, *hosts: Host, number: int = 1, arrived: str = "", lost: str = "") -> Row:
    """The line of a committed run; what is given stands instead of what capture.json says."""
    info = bench.info(number)
    counts = info["frames"]
    came = f"{counts['received']} of {counts['sent']} frames"
    if info["samples"]["sent"] is None:
        came = f"{counts['received']} frames, no END"
    gaps = [_gap(gap) for gap in info["gaps"]]
    return Row(arrived or came, bench.plain(*hosts), lost or "; ".join(gaps) or "nothing")


def refused(bench: Bench, *hosts: Host, arrived: str) -> Row:
    """The line of a run that never began."""
    assert not bench.run().exists()
    return Row(arrived, bench.plain(*hosts), "nothing: no run was begun")


def _gap(gap: dict[str, Any]) -> str:
    strokes = gap["strokes"]
    where = f"in stroke {strokes[0]}" if len(strokes) == 1 else f"in strokes {strokes}" if strokes else "in no stroke"
    frames = f"{gap['frames']} frame{'s' * (gap['frames'] > 1)}"
    return f"{frames} after {gap['after_s']:g} s, {where}" if gap["after_s"] is not None else f"{frames} at the start"


def complete(bench: Bench, rig: Rig, host: Host, true_frames: list[bytes], sent: list[bytes]) -> int:
    """Play a recording on which the rig sends other frames than it means to, END again until ACK; exit status."""
    rig.begin(true_frames)
    rig.say(*sent)
    rig.hear(Kind.ACK)
    return host.wait()
