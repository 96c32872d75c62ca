"""Runs that were left out → a line beneath a table, a part of the page, and the end of the main job, which fails."""

import argparse
from collections.abc import Iterable, Sequence
from pathlib import Path

from markupsafe import Markup

from ..ground.errors import BadInput, program
from ..ground.input.words_by_file import SIGN
from ..ground.stored import schemas
from ..ground.stored.files import write_text
from ..ground.words.left_out import LeftOut, from_json, read_left_out, to_json
from .layout.plain_markdown import plain
from .web.page import paragraph, together
from .web.sortable_table import table

HEAD = ("Run", "Material", "Why, and how to mend it")


def arguments(parser: argparse.ArgumentParser) -> None:
    """Add the option for the left-out runs to a command line."""
    more = "what the stages left out: JSON, or a run's table"
    parser.add_argument("--left-out", type=Path, nargs="*", default=[], metavar="FILE", help=more)
    parser.add_argument("--planned", default="[]", metavar="JSON", help="what the plan left out, as JSON")


def noted_in(paths: Iterable[Path]) -> list[LeftOut]:
    """Runs that the stages left out, by what they wrote: JSON of a material, or in place of a run's table."""
    runs = []
    for path in paths:
        if path.suffix == ".json":
            runs += read_left_out(path)
            continue
        try:
            schemas.read(path, schemas.STROKES)
        except schemas.Refused as error:
            runs.append(LeftOut.of(path.parent.name, error))
    return runs


def told(arguments: argparse.Namespace) -> list[LeftOut]:
    """Runs that such a command line names, in order of name."""
    runs = from_json(arguments.planned) + noted_in(arguments.left_out)
    return sorted(dict.fromkeys(runs), key=lambda left_out: left_out.run)


def beneath(suffix: str, runs: Sequence[LeftOut]) -> list[str]:
    """The lines beneath a table in Markdown (`md`) or LaTeX (`tex`) on left-out runs; csv stays unchanged."""
    if suffix == "md":
        return [plain(f"Left out: run {quoted(left_out.run)}: {left_out.why}") for left_out in runs]
    return [f"Left out: {', '.join(quoted(left_out.run) for left_out in runs)}."] if runs else []


def quoted(run: str) -> str:
    """A run's name as it stands, in quotes where a blank would hide where it ends."""
    return f'"{run}"' if " " in run else run


def section(runs: list[LeftOut]) -> Markup:
    """A part of the page; it is not folded, so that nobody overlooks it."""
    rows = [
        (left_out.run if left_out.run.isprintable() else ascii(left_out.run), left_out.material, left_out.why)
        for left_out in runs
    ]
    words = paragraph("These tables, figures and verdicts were made without them.")
    return together([Markup('<h2 id="left-out">Left out</h2>'), words, table(HEAD, rows, texts=(0, 1, 2), paged=True)])


@program
def main() -> None:
    """Say which runs were left out: exit 0 and write that there are none, or exit 2."""
    parser = argparse.ArgumentParser(description=main.__doc__, fromfile_prefix_chars=SIGN)
    arguments(parser)
    parser.add_argument("--out", type=Path, required=True, help="the file of the runs left out, JSON; required")
    options = parser.parse_args()
    runs = told(options)
    if runs:
        for left_out in runs[:-1]:
            print(f"left out: {left_out.why}", flush=True)
        last = runs[-1]
        raise BadInput(last.file, last.field, last.problem, last.mend)
    write_text(options.out, to_json(runs) + "\n")


if __name__ == "__main__":
    main()
