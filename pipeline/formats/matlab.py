"""A MATLAB file of a version before 7.3: vectors, matrices and structs of them, as named columns."""

import subprocess
import sys
from pathlib import Path

from ..ground.errors import BadInput
from ..ground.input.text_file import TextFile
from ..ground.stored.regular_file import open_regular
from .hdf5 import OBJECT_MEND
from .interface import Columns, Format
from .matlab_child import TOLD, unpack

ROOT = Path(__file__).resolve().parents[2]


def read_matlab(path: Path, _: TextFile | None = None) -> Columns:
    """Series of a MATLAB file under their names, fields of structs as `data.time`.

    Raises BadInput for a file that is not MATLAB's, or holds nothing but objects that only MATLAB reads.
    """
    open_regular(path).close()
    command = [sys.executable, "-m", f"{__package__}.matlab_child", str(path.resolve())]
    done = subprocess.run(command, cwd=ROOT, capture_output=True)
    if done.returncode == TOLD:
        reason = done.stderr.decode("utf-8", "replace").strip()
        raise BadInput(path, "file", f"is not a MATLAB file ({reason})", "copy it again")
    if done.returncode:
        raise BadInput(path, "file", "is not a MATLAB file: what reads such files fails on it", "copy it again")
    columns, objects = unpack(done.stdout)
    if objects and not any(values.dtype.kind in "fiub" for values in columns.values()):
        problem = "holds a table, a timeseries or another object of MATLAB's own, and no vector"
        raise BadInput(path, "file", problem, OBJECT_MEND)
    return columns


FORMAT = Format("a MATLAB file", (".mat",), (b"MATLAB 5.0", b"MATLAB 7.0"), frozenset(), read_matlab)
