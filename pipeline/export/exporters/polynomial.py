"""The ridge regression, exported."""

from typing import TYPE_CHECKING

import numpy as np

from ..c_polynomial import body as body
from ..interface import Source

if TYPE_CHECKING:
    from ..onnx_query import Query

READS: tuple[str, ...] = ()
PRECISION = np.float64


def answer(query: "Query", source: Source) -> str:
    """The model's answer as ONNX nodes; a header needs no onnx, so it is imported here."""
    from ..onnx_curves import polynomial

    return polynomial(query, source)
