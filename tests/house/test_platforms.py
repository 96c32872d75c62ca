"""Where a system has no fcntl, terminals, prctl, fdatasync, signal PIPE or /proc, all runs but the serial line."""

import json
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
# what needs a serial port or a pseudo-terminal by its nature
SERIAL = ("pipeline.capture", "pipeline.rig.serial_line", "pipeline.rig.__main__", "pipeline.rig.record")
# takes them from our own code, and /proc from everybody
POOR = """
import builtins, errno, os, signal, sys
TAKEN = {"fcntl", "pty", "tty", "termios", "resource", "pwd", "grp", "ctypes"}
given = builtins.__import__

def poor_import(name, globals=None, *rest, **more):
    importer = (globals or {}).get("__name__", "")
    if name.split(".")[0] in TAKEN and importer.split(".")[0] in ("pipeline", "__main__"):
        raise ImportError(f"{importer} imports {name}")
    return given(name, globals, *rest, **more)

def no_proc(event, arguments):
    if event == "open" and str(arguments[0]).startswith("/proc/"):
        raise FileNotFoundError(errno.ENOENT, "no such file", arguments[0])

builtins.__import__ = poor_import
sys.addaudithook(no_proc)
if hasattr(os, "fdatasync"):
    del os.fdatasync
del signal.SIGPIPE
"""


def poorly(code, *arguments, **variables):
    """Run code on such a system."""
    command = [sys.executable, "-c", POOR + code, *map(str, arguments)]
    environment = {**os.environ, "PYTHONPATH": str(ROOT), **variables}
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, env=environment)


def modules():
    paths = [path.relative_to(ROOT).with_suffix("").parts for path in sorted((ROOT / "pipeline").rglob("*.py"))]
    names = [".".join(parts).removesuffix(".__init__") for parts in paths]
    return [name for name in names if not name.startswith(SERIAL)]


def test_the_poor_system_refuses_what_it_should():
    code = "exec(compile('import fcntl', 'x', 'exec'), {'__name__': 'pipeline.x'})"
    done = poorly(code)
    assert done.returncode == 1 and "pipeline.x imports fcntl" in done.stderr
    assert "no such file" in poorly("open('/proc/self/status')").stderr


@pytest.mark.long
def test_every_module_without_a_serial_line_imports_and_every_program_explains_itself():
    assert len(modules()) > 150
    code = """
import contextlib, importlib, io, json
failed = []
for name in json.loads(sys.argv[1]):
    try:
        module = importlib.import_module(name)
        path = module.__file__ or ""
        with open(path, encoding="utf-8") as file:
            is_program = 'if __name__ == "__main__"' in file.read()
        if is_program:
            said = io.StringIO()
            sys.argv = [name, "--help"]
            with contextlib.redirect_stdout(said):
                try:
                    module.main()
                    failed.append(f"{name}: no --help")
                except SystemExit as end:
                    assert end.code == 0 and "usage" in said.getvalue(), name
    except BaseException as error:
        failed.append(f"{name}: {error!r}")
print(json.dumps(failed))
"""
    done = poorly(code, json.dumps(modules()))
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout.splitlines()[-1]) == []


def test_a_run_goes_through_the_stages_there(make_run, tmp_path):
    run = make_run("nylon-1")
    code = "import runpy; module = sys.argv.pop(1); runpy.run_module(module, run_name='__main__', alter_sys=True)"
    processed = tmp_path / "processed"
    samples, strokes = (processed / run.name / f"{table}.parquet" for table in ("samples", "strokes"))
    for module, *arguments in (
        ("pipeline.stages.ingest", run, "--out", samples, "--out-strokes", strokes),
        ("pipeline.stages.dataset", run, "--processed", processed, "--out", processed / "dataset.parquet"),
    ):
        done = poorly(code, module, *arguments, TWISTBENCH_PARENT=str(os.getpid()))
        assert done.returncode == 0 and arguments[-1].exists(), done.stderr


@pytest.mark.parametrize("rich", [True, False])
def test_a_program_whose_reader_left_ends_quietly_with_and_without_the_signal(rich):
    code = "from pipeline.ground.errors import program\n"
    code += "@program\ndef main():\n    while True:\n        print('more')\nmain()\n"
    command = [sys.executable, "-c", code if rich else POOR + code]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    started = subprocess.Popen(command, cwd=ROOT, text=True, env=environment, **pipes)
    started.stdout.readline()
    started.stdout.close()
    with started.stderr:
        assert started.stderr.read() == ""
    assert started.wait() == 128 + 13


@pytest.mark.skipif(os.name == "nt", reason="Windows says nothing of a parent's death")
@pytest.mark.parametrize("rich", [True, False])
def test_a_program_ends_with_its_parent_with_and_without_prctl(tmp_path, rich):
    """The parent is killed; the program writes its place in a file for as long as it lives."""
    child = "import os, time\nfrom pipeline.ground.errors import program\n"
    child += "@program\ndef main():\n    while True:\n"
    child += "        print(os.getpid(), flush=True)\n        time.sleep(0.05)\nmain()\n"
    parent = "import os, subprocess, sys, time; "
    parent += "subprocess.Popen([sys.executable, '-c', sys.argv[1]], env={**os.environ, "
    parent += "'TWISTBENCH_PARENT': str(os.getpid())}); time.sleep(600)"
    command = [sys.executable, "-c", parent, child if rich else POOR + child]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    started = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True, env=environment)
    program = int(started.stdout.readline())
    started.kill()
    started.wait()
    started.stdout.read()  # ends when the program does, which holds the other end
    started.stdout.close()
    end_s = time.monotonic() + 60
    while alive(program):
        assert time.monotonic() < end_s
        time.sleep(0.02)


def alive(process):
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    return True
