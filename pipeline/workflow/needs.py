"""What a job of each rule may take on a machine: memory, minutes and threads, from `config/resources.yaml`."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import yaml

MEASURED = Path(__file__).resolve().parents[1] / "config" / "resources.yaml"


class Needs(dict[str, dict[str, Any]]):
    """By rule, what its `resources:` say; a job that is tried again is given as much again."""

    def __init__(self, measured: Path = MEASURED) -> None:
        rules: Mapping[str, Mapping[str, int]] = yaml.safe_load(measured.read_text(encoding="utf-8"))
        super().__init__({rule: {name: _more(value) for name, value in needs.items()} for rule, needs in rules.items()})


def _more(value: int) -> Callable[..., int]:
    """A resource that grows with the attempt."""

    def given(wildcards: Any, attempt: int) -> int:
        return value * attempt

    return given
