"""After the verdicts: what each effect that was named instead of the truth leaves of it, when it copies it."""

import argparse
import json
from pathlib import Path

from ..ground.errors import program
from ..ground.stored.files import write_text
from .conceal_batch import drawn
from .copies import copies, left_over
from .draws import NAMED
from .plan import Planned, read
from .verdict_json import VerdictJson


def named_beside(verdict: VerdictJson, truth: tuple[str, ...]) -> list[str]:
    """Effects that a verdict names or cannot rule out, without the true ones."""
    sets = [[mechanism["id"] for mechanism in verdict.get("mechanisms", [])], *verdict.get("alternatives", [])]
    return sorted({name for ids in sets for name in ids if name in NAMED} - {*truth})


def left(planned: Planned, path: Path) -> dict[str, float]:
    """By effect: the noise floors that its best copy leaves of a single hidden effect, calibration free."""
    if planned.stratum != "single" or planned.author or not path.is_file():  # the rig's effects copy the rig's alone
        return {}
    names = named_beside(json.loads(path.read_text(encoding="utf-8")), planned.effects)
    if not names:
        return {}
    case = drawn(planned)
    return left_over(case, copies(case, names))


@program
def main() -> None:
    """Write one JSON: by run, by effect, noise floors."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.proof.lookalikes", description=__doc__)
    parser.add_argument("--cases", type=read, required=True, help="JSON, as pipeline.proof.plan writes it")
    parser.add_argument("--verdicts", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True, help="the file of what looks alike, JSON; required")
    arguments = parser.parse_args()
    left_by_run = {case.run: left(case, arguments.verdicts / case.run / "diagnosis.json") for case in arguments.cases}
    write_text(arguments.out, json.dumps({run: by for run, by in left_by_run.items() if by}, indent=1) + "\n")


if __name__ == "__main__":
    main()
