"""Make one concealed recording: a run folder for the diagnosis, and elsewhere the sealed answer."""

import argparse
import json
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import yaml

from ..ground.errors import BadInput, program
from ..ground.stored.files import whole, write_text
from ..run.description import parse_run
from ..run.run_yaml import RunYaml
from .case import HIDES, STRATA, answer, draw_case, performed
from .draws import NAMED, OPEN_SET
from .size import OutOfReach


def write_run(content: RunYaml, recording: pd.DataFrame, folder: Path) -> None:
    """Write run.yaml and recording.parquet; raises BadInput when run.yaml could not be read again."""
    path = folder / "run.yaml"
    parse_run(content, path.resolve())
    with whole(folder / "recording.parquet") as temporary:
        recording.to_parquet(temporary, index=False)
    write_text(path, yaml.safe_dump(content, sort_keys=False))


def plain(value: Any) -> Any:
    """numpy's numbers and arrays as Python's, for JSON."""
    return value.tolist() if isinstance(value, np.generic | np.ndarray) else str(value)


@program
def main() -> None:
    """Write RAW/RUN/ and the answer."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.proof.conceal", description=__doc__)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--stratum", choices=STRATA, required=True)
    parser.add_argument("--effect", action="append", default=[], choices=(*NAMED, *OPEN_SET), metavar="ID")
    parser.add_argument("--kappa", action="append", default=[], type=float, help="noise floors, for each effect")
    parser.add_argument("--protocol", choices=("rich", "poor"), default="rich")
    parser.add_argument("--run", required=True)
    parser.add_argument("--raw", type=Path, required=True)
    parser.add_argument("--answer", type=Path, required=True)
    arguments = parser.parse_args()
    if len(arguments.effect) > HIDES.get(arguments.stratum, 0):
        parser.error(f"the stratum {arguments.stratum} hides {HIDES.get(arguments.stratum, 0)} effects")
    if arguments.answer.resolve().is_relative_to(arguments.raw.resolve()):
        raise BadInput(arguments.answer, "--answer", "lies where recordings are read", "seal it outside of --raw")
    try:
        case = draw_case(
            arguments.seed, arguments.stratum, arguments.protocol, arguments.effect, arguments.kappa or [1.0]
        )
    except OutOfReach as error:
        raise BadInput(arguments.run, "--kappa", str(error), "choose another seed, effect or protocol") from None
    write_run(
        case.bench.described(arguments.run, not case.load_cell), performed(case).table, arguments.raw / arguments.run
    )
    sealed = answer(case, arguments.run)
    write_text(arguments.answer, json.dumps(sealed, indent=1, default=plain) + "\n")
    hidden = ", ".join(f"{effect['id']} of {effect['kappa']:.2f} noise floors" for effect in sealed["effects"])
    print(f"{arguments.run}: {hidden or 'nothing'} hidden")


if __name__ == "__main__":
    main()
