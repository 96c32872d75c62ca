"""What the programs that try models on a campaign are asked: its points, a model, a seed, and where to write."""

import argparse
from pathlib import Path

import pandas as pd

from ..ground.outputs import file_to_write
from ..ground.tables import opened
from ..stages.train import configured, seed
from .points import SCHEMA


def parser(doc: str | None) -> argparse.ArgumentParser:
    """The command line of a program with this docstring; a program may add to it."""
    found = argparse.ArgumentParser(description=doc)
    found.add_argument("points", type=Path)
    found.add_argument("--model", required=True)
    found.add_argument("--settings", default="{}", metavar="JSON")
    found.add_argument("--seed", type=seed, default=0)
    found.add_argument("--out", type=Path, required=True, help="the file to write; required")
    return found


def points_of(asked: argparse.Namespace) -> pd.DataFrame:
    """The campaign's points (`points.SCHEMA`); raises BadInput for these or the model before anything is fitted."""
    configured(asked.model, asked.settings)
    file_to_write(asked.out, reads=[asked.points])
    return opened(asked.points, SCHEMA, "make it: python -m pipeline.campaign.points")
