"""Programs of the project as a person runs them, in this process: starting an interpreter for each takes 2 to 5 s.

What only a process shows, its environment, signals and pipes, is tested with one.
"""

import contextlib
import io
import runpy
import subprocess
import sys
import warnings
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
Done = subprocess.CompletedProcess[str]


def run(module: str, *words: object, cwd: Path = ROOT) -> Done:
    """What `python -m <module> <words>` in a folder comes to: exit status, stdout, stderr.

    An exception that ends the program ends the test: it would have been a traceback.
    """
    command = [module, *map(str, words)]
    output, complained, before, status = io.StringIO(), io.StringIO(), sys.argv, 0
    sys.argv = command
    try:
        with (
            contextlib.chdir(cwd),
            contextlib.redirect_stdout(output),
            contextlib.redirect_stderr(complained),
            warnings.catch_warnings(),
        ):
            # it may have been imported here already, which a process of its own would not have done
            warnings.filterwarnings("ignore", ".*found in sys.modules after import of package", RuntimeWarning)
            runpy.run_module(module, run_name="__main__", alter_sys=True)
    except SystemExit as end:
        status = int(end.code or 0)
    finally:
        sys.argv = before
    return Done(command, status, output.getvalue(), complained.getvalue())
