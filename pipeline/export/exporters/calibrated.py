"""The equations with one string's own dimensions, exported."""

from typing import TYPE_CHECKING

import numpy as np

from ..c_physics import body as body
from ..interface import Source

if TYPE_CHECKING:
    from ..onnx_query import Query

READS: tuple[str, ...] = ("load_n",)
PRECISION = np.float64


def answer(query: "Query", source: Source) -> str:
    """The model's answer as ONNX nodes; a header needs no onnx, so it is imported here."""
    from ..onnx_curves import analytic

    return analytic(query, source)
