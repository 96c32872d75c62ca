"""The command line of the program `diagnose`."""

import argparse
from pathlib import Path

from ..ground.command import command
from ..ground.errors import BadInput
from ..ground.input.outputs import folder_to_write
from ..ground.input.parser import Parser
from ..run.run_arguments import run_dir
from .mechanisms import library


def parsed(description: str) -> argparse.Namespace:
    """The parsed command line; raises BadInput for an unusable output folder and for an unknown mechanism."""
    parser = Parser(prog=command("diagnose"), description=description)
    parser.add_argument("run_dir", type=run_dir, nargs="+")
    parser.add_argument("--out", type=Path, required=True, help="the folder in which each run gets a folder; required")
    parser.add_argument("--together", action="store_true", help="several runs of one rig in one diagnosis")
    parser.add_argument("--jobs", type=int, default=1, help="runs at a time")
    parser.add_argument(
        "--without", action="append", default=[], metavar="ID", help="a mechanism that the library shall lack"
    )
    parser.add_argument(
        "--judge", type=Path, metavar="FILE", help="a judge taught otherwise, in place of the library's"
    )
    parser.add_argument(
        "--note-refusals", action="store_true", help="write why a run is refused as its verdict.txt, and exit with 0"
    )
    parser.add_argument(
        "--processed",
        type=Path,
        metavar="DIR",
        help="DIR/<run>/ holds the samples and strokes that ingest made of each run; default: the recordings are read",
    )
    parser.add_argument(
        "--cpu-seconds",
        type=Path,
        metavar="FILE",
        help="write what each diagnosis took, starting apart, as JSON by run",
    )
    parser.add_argument("--mark", default="", metavar="TEXT", help="a line on the figure: what made the recording")
    arguments = parser.parse_args()
    folder_to_write(arguments.out)
    for id_ in sorted(set(arguments.without) - set(library.mechanisms())):
        raise BadInput("arguments", "--without", f"{id_} is no mechanism", f"use {', '.join(library.mechanisms())}")
    return arguments
