"""What needs no table starts without the libraries of tables: a person waits for capture at the rig, cable in hand."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
TABLES = {"pandas", "pyarrow"}
# The effects of the rig are compiled, and the compiler imports scipy by itself.
COMPILED = {"scipy"}
HEAVY = {*TABLES, *COMPILED, "torch", "matplotlib", "sklearn"}


def loaded(modules: list[str], code: str) -> set[str]:
    """Heavy libraries that a process has loaded after it ran the code."""
    code = f"import contextlib, io, json, sys\n{code}\nprint(json.dumps(sorted(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", code, *modules], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return HEAVY & set(json.loads(done.stdout.splitlines()[-1]))


def after_help(program: str) -> set[str]:
    """Heavy libraries that a program has loaded once it has printed its help."""
    return loaded(
        [program],
        "import runpy\n"
        "program, sys.argv = sys.argv[1], [sys.argv[1], '--help']\n"
        "printed = io.StringIO()\n"
        "with contextlib.redirect_stdout(printed), contextlib.suppress(SystemExit):\n"
        "    runpy.run_module(program, run_name='__main__', alter_sys=True)\n"
        "assert 'usage' in printed.getvalue()",
    )


@pytest.mark.parametrize("program", ["pipeline", "pipeline.capture", "pipeline.watch"])
def test_a_program_without_tables_starts_without_their_libraries(program: str) -> None:
    assert after_help(program) == set()


@pytest.mark.parametrize("program", ["pipeline.rig"])
def test_the_synthetic_rig_starts_without_the_libraries_of_tables(program: str) -> None:
    assert after_help(program) <= COMPILED


def test_the_device_of_the_rig_loads_no_table() -> None:
    assert loaded([], "import pipeline.rig.device, pipeline.rig.serial_line") <= COMPILED


def test_a_program_with_tables_loads_them() -> None:
    assert after_help("pipeline.predict") >= TABLES
