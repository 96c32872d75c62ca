"""The paper's INN, exported."""

from typing import TYPE_CHECKING

import numpy as np

from ..c_coupling import body as body
from ..interface import Source

if TYPE_CHECKING:
    from ..onnx_query import Query

READS: tuple[str, ...] = ("separator_mm", "length_mm", "radius_mm")
PRECISION = np.float32


def answer(query: "Query", source: Source) -> str:
    """The model's answer as ONNX nodes; a header needs no onnx, so it is imported here."""
    from ..onnx_networks import coupling

    return coupling(query, source)
