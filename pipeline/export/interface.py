"""The interface of an exporter: a file of `exporters/` with the model's name, found by being there."""

import importlib
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, Protocol

from ..ground.code.modules import holding
from ..models.parts.inside.recorded_pairs import Paired
from ..models.parts.inside.recorded_strokes import Under
from .c_text import Body
from .inputs import Inputs

FOLDER = Path(__file__).parent / "exporters"


@dataclass(frozen=True)
class Source:
    """A fitted model, its name and its inputs; `zero_mm` is a calibrated sensor's zero.

    `string` is the one that it was fitted to alone; empty where it was fitted to all.

    As far as the dataset is there, `zeroed` says of each string in which run its zero was taken, `jumped` what that
    zero did later, `values` what was recorded of each column that differs, and `foreseen` how many strokes the longest
    string has, and how many ahead errors are measured. `pairs` are the twists that were recorded around each condition,
    `loads` the loads around each size, `under` the strokes around each load, and `trained` says which recordings these
    are; `on_unseen` tells, when asked, what the model errs on points that it has not seen. `start` is a recorded state,
    by field. Of what is in `deaf` no answer depends. `older` says that the dataset has other points than the model was
    fitted to; then nothing else is of the dataset.
    """

    name: str
    model: Any
    inputs: Inputs
    zero_mm: float = 0.0
    string: str = ""
    zeroed: tuple[str, ...] = ()
    jumped: str = ""
    values: dict[str, str] = field(default_factory=dict)
    foreseen: tuple[int, int] | None = None
    deaf: tuple[str, ...] = ()
    pairs: tuple[Paired, ...] | None = None
    loads: tuple[Paired, ...] = ()
    under: Under | None = None
    trained: str = ""
    start: dict[str, float] = field(default_factory=dict)
    on_unseen: Callable[[], str] = str
    older: str = ""

    @property
    def errors(self) -> str:
        """The errors of the model on unseen points, in a sentence."""
        return self.on_unseen()


class Exporter(Protocol):
    """The content of a file in `exporters/`; for ONNX, also that of `onnx_model.OnnxExporter`."""

    READS: tuple[str, ...]  # the measured columns that the model reads whether or not they vary; conditions come on top

    def body(self, source: Source) -> Body:
        """The text of the C functions `tsa_raw_forward` and `tsa_raw_inverse`, with their helpers."""


@cache
def names() -> tuple[str, ...]:
    """Names of the models that can be exported, sorted."""
    return holding(FOLDER, r"READS\b")


def exporter(name: str) -> Exporter:
    """The exporter of a model of `names()`."""
    module: Any = importlib.import_module(f"{__package__}.exporters.{name}")
    c_exporter: Exporter = module
    return c_exporter
