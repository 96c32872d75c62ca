"""A saved model fitted once more, with its own settings, to all points of its dataset: none is left to test it on."""

import json
from pathlib import Path

from ..ground import schemas
from ..ground.given_table import opened as opened_table
from ..models.interface import settings_of
from ..models.parts.configured import configured, fitting
from ..models.parts.settings import values
from ..models.parts.thinned import thinned
from .source import Beside, dataset_of, opened

STEM = "all-0"  # of the file that is written beside the saved model


def fitted_to_all(file: Path, name: str | None, beside: Beside) -> Path:
    """The file of the model that was fitted to all points; raises BadInput as the export of the saved one does."""
    source = opened(file, name, beside)
    points = thinned(opened_table(dataset_of(file, beside), schemas.DATASET, "say --dataset FILE"))
    settings = values(source.model.settings) if settings_of(source.name) else {}
    model = configured(source.name, json.dumps(settings))
    with fitting(source.name):
        model.fit(points, 0)
    out = file.with_name(f"{STEM}{file.suffix}")
    model.save(out)
    return out
