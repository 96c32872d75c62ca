"""An HDF5 file, MATLAB's version 7.3 among them: its data sets as named columns, groups as structs."""

import contextlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from ..ground.errors import BadInput
from ..ground.input.text_file import TextFile
from ..ground.stored.regular_file import open_regular
from .interface import Columns, Format
from .nested import DEEPEST, MOST_PARTS, columns_of
from .unpacked import IS_IT, NO_READINGS, is_bomb

MOST_BYTES = 8_000_000_000  # of all data sets, unpacked: a day of ten channels at 10 kHz
OBJECTS = "#subsystem#"  # where MATLAB puts its tables and timeseries
OBJECT_MEND = "save its columns in MATLAB as a struct: s = table2struct(T, 'ToScalar', true), or s.t = ts.Time"


class _Elements(list[Any]):
    """One field of all structs of a list, as MATLAB stores it."""


class _Reader:
    """Values of one open file; it counts the values read, so that no file exceeds the size of a recording."""

    def __init__(self, path: Path, file: Any) -> None:
        self.path, self.file, self.bytes = path, file, 0
        self.packed = path.stat().st_size
        self.matlab = path.suffix.lower() == ".mat"

    def dataset(self, item: Any, depth: int) -> Any:
        """Content of a data set: an array, a list of its references' targets, or None if it holds no numbers."""
        import h5py

        if item.is_virtual or item.external or item.shape is None or item.attrs.get("MATLAB_empty"):
            return None  # its numbers lie in other files, or there are none
        if "MATLAB_object_decode" in item.attrs:
            return None  # one of MATLAB's own objects, whose numbers lie elsewhere in a form that nobody documents
        if h5py.check_ref_dtype(item.dtype) is not None:
            cells = item.attrs.get("MATLAB_class") in (b"cell", "cell")
            return (list if cells else _Elements)(self.referred(item, depth))
        if item.attrs.get("MATLAB_class") in (b"char", "char") or item.dtype.kind not in "fiuV":
            return None
        self.bytes += item.nbytes
        if is_bomb(self.bytes, self.packed):
            raise BadInput(self.path, "file", NO_READINGS, IS_IT)
        if self.bytes > MOST_BYTES:
            problem = f"says that it holds more than {MOST_BYTES / 1e9:g} GB"
            raise BadInput(self.path, "file", problem, "cut it into runs of a day or less")
        values = np.asarray(item[()])
        return values.T if self.matlab and values.ndim == 2 else values  # MATLAB stores columns first

    def referred(self, item: Any, depth: int) -> Iterator[Any]:
        """What the references of a data set lead to, as cells and lists of structs have them; None for a broken one."""
        if item.size > MOST_PARTS:
            problem = f"refers to {item.size} others, where {MOST_PARTS} runs are the most"
            raise BadInput(self.path, item.name, problem, "save each channel as a vector of its own")
        for reference in np.asarray(item[()]).ravel():
            with contextlib.suppress(ValueError, KeyError):  # h5py's for a reference to nothing
                yield self.value(self.file[reference], depth + 1)
                continue
            yield None

    def value(self, item: Any, depth: int = 0) -> Any:
        """A group as a dict, a data set as its content; links that lead out of the file or round in it are left out."""
        import h5py

        if depth > DEEPEST:
            return None
        if isinstance(item, h5py.Dataset):
            return self.dataset(item, depth)
        if not isinstance(item, h5py.Group):
            return None
        inside = [name for name in item if not name.startswith("#")]
        hard = [name for name in inside if isinstance(item.get(name, getlink=True), h5py.HardLink)]
        return _structs({name: self.value(item[name], depth + 1) for name in hard})


def _structs(fields: dict[str, Any]) -> Any:
    """Fields of a group; where they are those of a list of structs, that list."""
    lengths = {len(value) if isinstance(value, _Elements) else -1 for value in fields.values()}
    if len(lengths) != 1 or lengths == {-1}:
        return fields
    return [{name: value[index] for name, value in fields.items()} for index in range(lengths.pop())]


def read_hdf5(path: Path, _: TextFile | None = None) -> Columns:
    """Series of an HDF5 file under the paths to them, such as `data.time`; raises BadInput for a damaged one."""
    import h5py

    open_regular(path).close()
    try:
        with h5py.File(path, "r") as file:
            columns = dict(columns_of(_Reader(path, file).value(file)))
            objects = OBJECTS in file
    except BadInput:
        raise
    except Exception as error:  # h5py raises whatever a damaged byte leads it to
        reason = f"{type(error).__name__}: {str(error)[:100]}"
        raise BadInput(path, "file", f"is not a readable HDF5 file ({reason})", "copy it again") from None
    if objects and not columns:
        problem = "holds a table, a timeseries or another object of MATLAB's own, and no vector"
        raise BadInput(path, "file", problem, OBJECT_MEND)
    return columns


FORMAT = Format(
    "an HDF5 file",
    (".h5", ".hdf5", ".hdf"),
    (b"\x89HDF\r\n\x1a\n", b"MATLAB 7.3"),
    frozenset(),
    read_hdf5,
)
