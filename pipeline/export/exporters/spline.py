"""The conditional spline, exported."""

from typing import TYPE_CHECKING

import numpy as np

from ...models.parts.conditions import MEASURED
from ..c_spline import body as body
from ..interface import Source

if TYPE_CHECKING:
    from ..onnx_query import Query

READS: tuple[str, ...] = MEASURED
PRECISION = np.float64


def answer(query: "Query", source: Source) -> str:
    """The model's answer as ONNX nodes; a header needs no onnx, so it is imported here."""
    from ..onnx_curves import spline

    return spline(query, source)
