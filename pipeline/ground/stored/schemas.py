"""The schema of every checked table: its columns, types, units and check sum, checked on writing and reading."""

import json
from collections.abc import Iterable, Iterator
from pathlib import Path

import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq

from ..command import REMAKE
from ..errors import BadInput
from ..units import unit_of
from . import seal
from .files import whole
from .regular_file import open_regular

MEND = f"delete it and {REMAKE}"
REFUSED = b"refused"  # the key under which a file tells why there is no table in it


class Refused(BadInput):
    """The refusal of an earlier stage, with its reason."""


class Damaged(BadInput):
    """A file that was changed since it was written; making it again mends it."""


def _schema(**columns: pa.DataType) -> pa.Schema:
    return pa.schema(
        pa.field(name, kind, nullable=False, metadata={"unit": unit_of(name)}) for name, kind in columns.items()
    )


F, N, S, B = pa.float64(), pa.int32(), pa.string(), pa.bool_()


def samples(columns: list[str]) -> pa.Schema:
    """Schema of `processed/<run>/samples.parquet`: one row a sample, `time_s` and the run's channels."""
    return _schema(**{name: F for name in columns})


# One row for each stretch of a run in which the motor keeps doing one thing.
STROKES = _schema(
    stroke=N, phase=S, first_sample=N, last_sample=N, start_s=F, end_s=F, start_turns=F, end_turns=F,
    missing_samples=N, complete=B,
)  # fmt: skip
# One row a point of a material; `within` and `later` hold "train", "test" or "" (not used); the tolerances are one
# sigma of how well each dimension was measured, the radius's relative.
DATASET = _schema(
    run=S, string=S, stroke=N, phase=S, direction=N, block=N, within=S, later=S, time_s=F,
    motor_turns=F, displacement_mm=F, load_n=F, actuator=S, radius_mm=F, length_mm=F, stiffness_n_per_mm=F,
    torsion_zone_mm=F, separator_mm=F,
    radius_tolerance=F, length_tolerance_mm=F, torsion_zone_tolerance_mm=F, separator_tolerance_mm=F,
)  # fmt: skip
# One row a held-out point; `point` is its row in the dataset.
PREDICTIONS = _schema(point=N, displacement_mm=F, motor_turns=F)
METRICS = _schema(
    material=S, model=S, split=S, map=S, stroke=S, phase=S, angle_band=S, seed=N, metric=S, unit=S, value=F
)


ROW_GROUP = 1 << 20  # rows that are turned into Parquet together


def write(table: pd.DataFrame, schema: pa.Schema, path: Path | str) -> None:
    """Write a table as Parquet under its schema, with its units and a check sum of it all, whole or not at all."""
    with whole(path) as temporary:
        put([table], schema, temporary)


def put(pieces: Iterable[pd.DataFrame], schema: pa.Schema, temporary: Path) -> None:
    """Write a table that comes in pieces into a temporary file, as `write` does, whatever the pieces' lengths."""
    with pq.ParquetWriter(temporary, schema) as to_temporary:
        for part in _row_groups(pieces):  # a table as Parquet is as large as the table
            columns = [pa.array(part[field.name].to_numpy(), field.type, from_pandas=False) for field in schema]
            to_temporary.write_table(pa.Table.from_arrays(columns, schema=schema))
    seal.seal_parquet(temporary)


def _row_groups(pieces: Iterable[pd.DataFrame]) -> Iterator[pd.DataFrame]:
    """Pieces of a table cut and joined to one length, except the last; one without rows if there is none."""
    waiting, rows, written = list[pd.DataFrame](), 0, False
    for piece in pieces:
        waiting.append(piece)
        rows += len(piece)
        while rows > ROW_GROUP:
            joined = waiting[0] if len(waiting) == 1 else pd.concat(waiting, ignore_index=True)
            yield joined.iloc[:ROW_GROUP]
            waiting, rows, written = [joined.iloc[ROW_GROUP:]], rows - ROW_GROUP, True
    if rows or not written:
        yield waiting[0] if len(waiting) == 1 else pd.concat(waiting, ignore_index=True)


def write_refusal(error: BadInput, path: Path | str) -> None:
    """Write a refusal in place of a table, with its reason."""
    refusal = json.dumps([error.file, error.field, error.problem, error.mend])
    with whole(path) as temporary:
        pq.write_table(pa.schema([], metadata={REFUSED: refusal.encode()}).empty_table(), temporary)
        seal.seal_parquet(temporary)


def read(path: Path | str, schema: pa.Schema | None = None) -> pd.DataFrame:
    """Read a Parquet table and refuse it unless its columns, types and units are the schema's.

    Without a schema the columns' names, types and units must agree with each other (samples).
    Raises BadInput when they do not, and for a file whose content is not what was written; Refused for a refusal.
    """
    content = seal.content_of(path)
    try:
        seal.check_parquet(content)
    except seal.Damaged as error:
        raise damaged(path, error) from None
    arrow = pq.read_table(pa.BufferReader(content))
    _check(path, arrow.schema, schema)
    return arrow.to_pandas()


def opened(path: Path | str, schema: pa.Schema | None = None) -> pq.ParquetFile:
    """A Parquet table that is read by row groups, with the refusals of `read`; raises BadInput and Refused."""
    file = open_regular(Path(path))
    try:
        seal.check_parquet_file(file)
        file.seek(0)
        parquet = pq.ParquetFile(file)
        _check(path, parquet.schema_arrow, schema)
    except Exception as error:
        file.close()
        if isinstance(error, seal.Damaged):
            raise damaged(path, error) from None
        raise
    return parquet


def damaged(path: Path | str, error: seal.Damaged) -> Damaged:
    """What is said of a stored file that is not what was written."""
    return Damaged(path, "content", f"is damaged, or not this version's: {error}", MEND)


def _check(path: Path | str, of_file: pa.Schema, schema: pa.Schema | None) -> None:
    """Raise BadInput unless a file's schema is the one that is asked for, and Refused where it holds a refusal."""
    if REFUSED in (of_file.metadata or {}):
        raise Refused(*json.loads(of_file.metadata[REFUSED]))
    expected = schema if schema is not None else samples(of_file.names)
    if not of_file.equals(expected, check_metadata=True):
        raise BadInput(path, "schema", "columns, types or units are not this version's", MEND)
