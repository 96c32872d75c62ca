"""Series of a MATLAB file, read in a process of its own: a damaged byte can crash the library that reads it."""

import argparse
import io
import json
import os
import sys
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import scipy.io

from ..ground.command import command
from ..ground.errors import program
from ..ground.stored.regular_file import open_regular
from .interface import Columns
from .nested import columns_of

TOLD = 3  # exit status where the library said what is wrong


def _is_object(name: str, value: Any) -> bool:
    """Whether a variable is one of MATLAB's own objects, such as a table, which only MATLAB can read."""
    return name in ("None", "") or type(value).__name__ == "MatlabOpaque"


def pack(columns: Columns, objects: bool) -> bytes:
    """Columns, and whether there are objects of MATLAB's own beside them, as bytes that execute nothing when read."""
    named = {"names": [*columns], "objects": objects}
    plain = [values.astype(str) if values.dtype.kind == "O" else values for values in columns.values()]
    content = io.BytesIO()
    np.savez(content, np.frombuffer(json.dumps(named).encode(), np.uint8), *plain)
    return content.getvalue()


def unpack(content: bytes) -> tuple[Columns, bool]:
    """The inverse of `pack`."""
    with np.load(io.BytesIO(content), allow_pickle=False) as arrays:
        outline = json.loads(arrays["arr_0"].tobytes())
        return {name: arrays[f"arr_{1 + index}"] for index, name in enumerate(outline["names"])}, outline["objects"]


@program
def main() -> None:
    """Write the series of one file to standard output."""
    parser = argparse.ArgumentParser(prog=command("formats.matlab_child"), description=__doc__)
    parser.add_argument("file", type=Path)
    arguments = parser.parse_args()
    with open_regular(arguments.file) as file, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            variables = scipy.io.loadmat(file, simplify_cells=True)
        except Exception as error:  # scipy's reader raises whatever a damaged byte leads it to
            print(f"{type(error).__name__}: {str(error)[:100]}", file=sys.stderr)
            sys.exit(TOLD)
    own = {name: value for name, value in variables.items() if not name.startswith("__")}
    columns = {name: values for name, values in columns_of(own) if len(values) > 1}
    content = pack(columns, any(_is_object(name, value) for name, value in own.items()))
    with os.fdopen(os.dup(1), "wb") as out:
        out.write(content)


if __name__ == "__main__":
    main()
