"""What the programs that try models on a campaign are asked: its points, a model, a seed, and where to write."""

import argparse
from pathlib import Path

import pandas as pd

from ...ground.input.outputs import file_to_write
from ...ground.input.parser import Parser
from ...ground.stored.given_table import opened
from ...models.parts.configured import configured
from ..train import seed
from .points import SCHEMA


def parser(doc: str | None) -> Parser:
    """The command line of a program with this docstring; a program may add to it."""
    parser_made = Parser(description=doc)
    parser_made.add_argument("points", type=Path)
    parser_made.add_argument("--model", required=True)
    parser_made.add_argument("--settings", default="{}", metavar="JSON")
    parser_made.add_argument("--seed", type=seed, default=0)
    parser_made.add_argument("--out", type=Path, required=True, help="the file to write; required")
    return parser_made


def points_of(arguments: argparse.Namespace) -> pd.DataFrame:
    """The campaign's points (`points.SCHEMA`); raises BadInput for these or the model before anything is fitted."""
    configured(arguments.model, arguments.settings)
    file_to_write(arguments.out, reads=[arguments.points])
    return opened(arguments.points, SCHEMA, "make it: python -m pipeline.stages.campaign.points")
