"""The interface of a format: the first bytes or names of its files, and the function that reads one."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd

from ..ground.input.text_file import TextFile

Columns = dict[str, np.ndarray]  # named columns of a file that need not be of one length
Reader = Callable[[Path, TextFile], pd.DataFrame | Columns]


@dataclass(frozen=True)
class Format:
    """A kind of file; a new one is one module of this folder with one of these as `FORMAT`.

    `name` as in "is a MATLAB file"; `suffixes` in lower case; `signs` are what its first bytes are, where they tell.
    `keys` are those of `file:` in run.yaml that say how such a file is written. The reader raises BadInput.
    """

    name: str
    suffixes: tuple[str, ...]
    signs: tuple[bytes, ...]
    keys: frozenset[str]
    read: Reader
