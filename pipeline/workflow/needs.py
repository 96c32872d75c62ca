"""The limits for a job of each rule on a machine: memory and minutes, from `config/resources.yaml`."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import yaml

MEASURED = Path(__file__).resolve().parents[1] / "config" / "resources.yaml"
BESIDE_MB = 300  # of memory, beside a job on a node: Snakemake, which starts it there (174 MB), and what waits for it
FURTHER = {"mem_mb": "more_mb", "runtime": "more_min"}


class Needs(dict[str, dict[str, Callable[..., int]]]):
    """By rule, what its `resources:` say; `materials` holds the runs of each material.

    A job that is tried again is given as much again. A job of a material is given more for each further run of it.
    """

    def __init__(self, materials: Mapping[str, Sequence[str]], measured: Path = MEASURED) -> None:
        rules: Mapping[str, Mapping[str, int]] = yaml.safe_load(measured.read_text(encoding="utf-8"))

        def need_of(needs: Mapping[str, int], name: str) -> Callable[..., int]:
            once, further = needs[name] + (BESIDE_MB if name == "mem_mb" else 0), needs.get(FURTHER[name], 0)

            def least(wildcards: Any, attempt: int) -> int:
                runs = len(materials.get(getattr(wildcards, "material", ""), ()))
                return (once + further * max(runs - 1, 0)) * attempt

            return least

        super().__init__({rule: {name: need_of(needs, name) for name in FURTHER} for rule, needs in rules.items()})
