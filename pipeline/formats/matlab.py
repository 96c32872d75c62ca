"""A MATLAB file of a version before 7.3: vectors, matrices and structs of them, as named columns."""

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import scipy.io

from pipeline.errors import BadInput
from pipeline.formats import hdf5
from pipeline.formats.interface import Columns, Format
from pipeline.formats.nested import columns_of
from pipeline.regular_file import open_regular
from pipeline.text_file import TextFile

OBJECT_MEND = "save its columns in MATLAB as a struct: s = table2struct(T, 'ToScalar', true), or s.t = ts.Time"


def _is_object(value: Any) -> bool:
    """Whether a variable is one of MATLAB's own objects, such as a table, which only MATLAB reads."""
    return isinstance(value, scipy.io.matlab.MatlabOpaque) or type(value).__name__ == "MatlabOpaque"


def read_matlab(path: Path, layout: TextFile | None = None) -> Columns:
    """Series of a MATLAB file under their names, fields of structs as `data.time`; a 7.3 file is read as HDF5.

    Raises BadInput for a file that is not MATLAB's, or holds nothing but objects that only MATLAB reads.
    """
    try:
        with open_regular(path) as file, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            variables = scipy.io.loadmat(file, simplify_cells=True)
    except NotImplementedError:
        return hdf5.read_hdf5(path, layout)
    except BadInput:
        raise
    except Exception as error:  # scipy's reader raises whatever a damaged byte leads it to
        said = f"{type(error).__name__}: {str(error)[:100]}"
        raise BadInput(path, "file", f"is not a MATLAB file ({said})", "copy it again") from None
    own = {name: value for name, value in variables.items() if not name.startswith("__")}
    columns = {name: values for name, values in columns_of(own) if len(values) > 1}
    objects = [name or "None" for name, value in variables.items() if _is_object(value) or name in ("None", "")]
    if objects and not any(values.dtype.kind in "fiub" for values in columns.values()):
        problem = "holds a table, a timeseries or another object of MATLAB's own, and no vector"
        raise BadInput(path, "file", problem, OBJECT_MEND)
    return {name: np.asarray(values) for name, values in columns.items()}


FORMAT = Format("a MATLAB file", (".mat",), (b"MATLAB 5.0", b"MATLAB 7.0"), frozenset(), read_matlab)
