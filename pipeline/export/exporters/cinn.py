"""The conditional INN, exported."""

from typing import TYPE_CHECKING

import numpy as np

from ...models.parts.conditions import MEASURED
from ..c_cinn import body as body
from ..interface import Source

if TYPE_CHECKING:
    from ..onnx_query import Query

READS: tuple[str, ...] = MEASURED
PRECISION = np.float32


def answer(query: "Query", source: Source) -> str:
    """The model's answer as ONNX nodes; a header needs no onnx, so it is imported here."""
    from ..onnx_networks import conditional

    return conditional(query, source)
