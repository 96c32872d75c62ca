"""The errors by which a job names the model to take: of the page of models, or of its metrics where it made no page."""

from collections.abc import Collection, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from ...ground.model_errors import APART
from ...ground.stored import schemas
from ...ground.stored.files import write_text
from ..shown.stroke_conditions import dataset_from, later_apart


@contextmanager
def models_csv(folder: Path, paths: Collection[Path]) -> Iterator[Path]:
    """The models.csv of the material of a folder: its own if it is among the paths that a job made, or no metrics are.

    Otherwise one of the metrics among them, of the errors on all points, which is gone afterwards.
    """
    own = folder / "models.csv"
    metrics = next((path for path in paths if path.parts[-2:] == (folder.name, "metrics.parquet")), None)
    if own in paths or metrics is None:
        yield own
        return
    read = schemas.read(metrics, schemas.METRICS)
    whole = (read[["stroke", "phase", "angle_band"]] == "all").all(axis=1) & (read["metric"] == "rmse")
    table = read[whole].groupby(["model", "split", "map"])["value"].median().rename("median").reset_index()
    points = metrics.with_name("dataset.parquet")
    is_apart = bool(later_apart(dataset_from(points if points.is_file() else None)))
    table["column"], table[APART] = "all", (table["split"] == "later") & is_apart
    with TemporaryDirectory() as temporary:
        passing = Path(temporary) / own.name
        write_text(passing, table.to_csv(index=False, float_format="%.9g"))
        yield passing
