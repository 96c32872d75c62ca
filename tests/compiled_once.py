"""What numba compiles for a diagnosis, 20 CPU s, made once while the tests of a fresh clone are collected.

Otherwise each of their processes, and each program that they start, would compile it at the same time.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

from pipeline.diagnosis import numerics

ROOT = Path(__file__).resolve().parent.parent
# a process of its own: it begins while the others read the tests, and who needs more before it ends compiles that alone
DIAGNOSE = "import sys; sys.path[:0] = [{!r}, {!r}]; import compiled_once; compiled_once.diagnose_once()"


def begin() -> subprocess.Popen[bytes] | None:
    """Begin to compile, where nothing of a diagnosis is compiled."""
    if any((Path(numerics.__path__[0]) / "__pycache__").glob("*.nbc")):
        return None
    code = DIAGNOSE.format(str(ROOT), str(ROOT / "tests"))
    return subprocess.Popen([sys.executable, "-c", code], stderr=subprocess.DEVNULL)


def diagnose_once() -> None:
    """Diagnose a short recording, which calls what is to be compiled."""
    import yaml
    from made_recording import content, recording

    from pipeline.diagnosis.in_memory import diagnosed
    from pipeline.diagnosis.recording.recorded_run import RecordedRun
    from pipeline.run.samples import read_strokes

    with tempfile.TemporaryDirectory() as folder:
        run = Path(folder) / "short"
        run.mkdir()
        (run / "run.yaml").write_text(yaml.safe_dump(content(run.name)))
        recording(strokes=6, rate_hz=10.0).to_csv(run / "recording.csv", index=False)
        diagnosed([RecordedRun(*read_strokes(run), folder=run)])
