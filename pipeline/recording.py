"""A recording, in whatever form it lies in a run folder or came from a logger, as a table of channels in our units."""

import gzip
import io
import re
import warnings
import zlib
from pathlib import Path

import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq
import scipy.io
from scipy.io.matlab import MatReadError

from pipeline.captured import check_lines, read_frames
from pipeline.errors import BadInput
from pipeline.run_yaml import STRING_ACTUATORS, Channel, Run, TextFile
from pipeline.runs import recording_path
from pipeline.units import conversion

GZIP = b"\x1f\x8b"  # how such a file begins, whatever its name


def read_text(path: Path, layout: TextFile) -> pd.DataFrame:
    """Text table of numbers as it stands in the file; columns have their header's names or indices from 0.

    Raises BadInput for a file that is empty, is not text, or holds something else than numbers.
    """
    try:
        content = path.read_bytes()
        text = (gzip.decompress(content) if content[:2] == GZIP else content).decode(layout.encoding)
    except (OSError, EOFError, zlib.error) as error:
        raise BadInput(path, "file", f"cannot be read ({error})", "copy it again from the logger") from None
    except (UnicodeDecodeError, LookupError):
        mend = "set file.encoding, latin1 for instance"
        raise BadInput(path, "file.encoding", f"is not {layout.encoding}", mend) from None
    lines = [
        line for line in re.split(r"\r\n|\n|\r", text) if line.strip()
    ]  # splitlines knows breaks that latin1 reuses
    if layout.comment:
        lines = [line for line in lines if not line.lstrip().startswith(layout.comment)]
    if len(lines) <= layout.header:
        raise BadInput(path, "file", "holds no samples", "record again; nothing was written by the logger")
    separator = r"\s+" if layout.delimiter == " " else layout.delimiter
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", pd.errors.ParserWarning)  # a row with a field too many is cut otherwise
            table = pd.read_csv(
                io.StringIO("\n".join(lines)),
                sep=separator,
                header=0 if layout.header else None,
                skipinitialspace=True,
                index_col=False,
                engine="c",
            )
    except (pd.errors.ParserError, pd.errors.EmptyDataError, pd.errors.ParserWarning) as error:
        mend = "check file.delimiter, and the line that it names"
        raise BadInput(path, "file", f"is not a table ({str(error).strip()})", mend) from None
    table.columns = [str(name).strip() if layout.header else name for name in table.columns]
    return table


def read_matlab(path: Path) -> pd.DataFrame:
    """Vectors of a MATLAB file, those as long as its longest, one column each under the variable's name.

    Raises BadInput for a file that is not MATLAB's, is of its version 7.3, or holds no vector of numbers.
    """
    try:
        variables = scipy.io.loadmat(path)
    except NotImplementedError:
        mend = "save it again in MATLAB with save(..., '-v7')"
        raise BadInput(path, "file", "is of MATLAB's version 7.3 (HDF5), which is not read", mend) from None
    except (OSError, ValueError, TypeError, zlib.error, MatReadError) as error:
        raise BadInput(path, "file", f"is not a MATLAB file ({error})", "copy it again") from None
    arrays = {name: np.asarray(value) for name, value in variables.items() if not name.startswith("__")}
    vectors = {
        name: value.ravel() for name, value in arrays.items() if value.dtype.kind in "fiu" and value.size in value.shape
    }
    longest = max((value.size for value in vectors.values()), default=0)
    if longest < 2:
        raise BadInput(path, "file", "holds no vector of numbers", "save each channel as a vector of its own")
    return pd.DataFrame({name: value for name, value in vectors.items() if value.size == longest})


def read_table(path: Path, layout: TextFile) -> pd.DataFrame:
    """Raw table of a foreign recording, text, MATLAB or Parquet, as it stands in the file; raises BadInput."""
    if path.suffix.lower() == ".mat":
        return read_matlab(path)
    if path.suffix != ".parquet":
        return read_text(path, layout)
    try:
        return pq.read_table(path).to_pandas(ignore_metadata=True)  # an index is a column like any other
    except (pa.ArrowException, OSError):
        mend = "copy it again; a Parquet file whose writer was killed cannot be read"
        raise BadInput(path, "file", "is not a readable Parquet file", mend) from None


def _raw(table: pd.DataFrame, name: str, channel: Channel, path: Path, given: bool) -> pd.Series:
    """The raw column of a channel; raises BadInput when the file does not have it or it is not numeric."""
    key = name if channel.column is None else channel.column
    if isinstance(key, int):
        if not 0 <= key < table.shape[1]:
            mend = f"correct channels.{name}.column"
            raise BadInput(path, f"column {key}", f"is not among its {table.shape[1]} columns", mend)
        column = table.iloc[:, key]
    elif key in table.columns:
        column = table[key]
    else:
        there = ", ".join(str(name) for name in table.columns[:12])
        where = f"correct channels.{name}.column" if given else f"name the column under channels.{name}.column"
        raise BadInput(path, name, f"there is no column {key!r}, only {there}", f"{where} in run.yaml")
    numbers = pd.to_numeric(column, errors="coerce")
    if column.dtype == bool or (numbers.isna() & column.notna()).any():
        row = int(np.argmax((numbers.isna() & column.notna()).to_numpy()))
        mend = "write numbers with a decimal point" if "," in str(column.iloc[row]) else "remove that row"
        raise BadInput(path, name, f"row {row + 1} holds {column.iloc[row]!r}, not a number", mend)
    return numbers.astype(float)


def to_samples(run: Run, table: pd.DataFrame, path: Path, mapping: Path) -> pd.DataFrame:
    """A raw table from `path` as `time_s` and the run's channels in our units, by the channels of file `mapping`.

    A string without a `load_n` channel gets `rig.load_n`, or 0 N, as one. Raises BadInput.
    """
    known = run.system.columns
    required = known[:3]
    for name in run.channels:
        if name not in known:
            mend = f"use one of {', '.join(known)}"
            raise BadInput(mapping, f"channels.{name}", "is not a known channel", mend)
    samples = {}
    for name in known:
        given = name in run.channels
        if name not in required and not given and name not in table.columns:
            continue
        channel = run.channels.get(name, Channel.model_validate({}))
        raw = _raw(table, name, channel, path, given)
        try:
            factor, shift = conversion(name, channel.unit, channel.counts_per_turn)
        except ValueError as error:
            problem, _, mend = str(error).partition("; ")
            raise BadInput(mapping, f"channels.{name}.unit", f"{channel.unit} {problem}", mend) from None
        samples[name] = factor * (channel.scale * raw + channel.offset) + shift
    if run.actuator in STRING_ACTUATORS and "load_n" not in samples:
        samples["load_n"] = pd.Series(run.rig.get("load_n", 0.0), index=table.index)
    return pd.DataFrame(samples).astype(float)


def read_recording(run: Run, folder: Path) -> pd.DataFrame:
    """Samples of a run folder, one row a sample: `time_s` and its channels, unchecked but for being numbers."""
    path = recording_path(folder)
    if path.suffix == ".frames":
        table, units = read_frames(path)
        told = {name: Channel.model_validate({"unit": unit}) for name, unit in units.items()}
        run = run.model_copy(update={"channels": {**told, **run.channels}})
    else:
        check_lines(path)
        table = read_table(path, run.file)
    return to_samples(run, table, path, folder / "run.yaml")
