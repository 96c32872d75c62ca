"""Open the answers and score the verdicts: sealed answers, verdicts and recordings → `reports/proof/`."""

import argparse
from pathlib import Path

import pandas as pd

from ...ground.errors import BadInput, program
from ...ground.stored.files import write_text
from . import baselines_beside
from .authors import by_author, by_law
from .case_table import OWN, gather
from .figures import draw
from .hands import section
from .page import page
from .scores import scores


@program
def main() -> None:
    """Write the tables, the page and the figures."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.proof.score", description=__doc__)
    parser.add_argument("batches", nargs="+")
    parser.add_argument("--place", type=Path, required=True, help="processed/proof")
    parser.add_argument("--twins", type=Path, required=True, help="what the library leaves of the rig's effects")
    parser.add_argument(
        "--out", type=Path, required=True, help="the folder of the tables, the page and the figures; required"
    )
    parser.add_argument("--note", default="", metavar="TEXT", help="which configuration made it, to stand beneath")
    arguments = parser.parse_args()
    if not arguments.twins.is_file():
        raise BadInput(arguments.twins, "--twins", "is not there", "make it with python -m pipeline.proof.twins")
    twins = pd.read_csv(arguments.twins)
    everyone, sizes = gather(arguments.place, arguments.batches)
    cases = everyone[everyone["author"] == OWN].reset_index(drop=True)
    sizes = sizes[sizes["run"].isin(cases["run"])]
    besides = baselines_beside.gather(everyone, arguments.place, arguments.batches)
    scored = pd.concat([scores(cases, sizes), baselines_beside.scores(besides)], ignore_index=True)
    tables = {"cases": everyone, "sizes": sizes, "beside": besides, "scores": scored}
    tables |= {"authors": by_author(everyone), "laws": by_law(everyone)}
    for name, table in tables.items():
        write_text(arguments.out / f"{name}.csv", table.to_csv(index=False, float_format="%.6g"))
    hands = section(tables["authors"], tables["laws"])
    write_text(arguments.out / "proof.md", page(cases, scored, twins, hands) + arguments.note)
    made_cases = cases[cases["skipped"] == ""]
    draw(made_cases, sizes, arguments.out)
    print(made_cases["outcome"].value_counts().to_string())


if __name__ == "__main__":
    main()
