"""Make a batch of concealed recordings in one process, and seal their answers in one file elsewhere."""

import argparse
import json
from dataclasses import asdict
from pathlib import Path
from typing import Any, cast

from ..ground.errors import BadInput, program
from ..ground.stored.files import write_text
from . import authored
from .case import Case, Stratum, answer, draw_case, performed
from .conceal import plain, write_run
from .plan import Planned, read
from .protocol import Kind
from .sealed import Answer
from .size import OutOfReach


def drawn(planned: Planned) -> Case:
    """The case that a plan asks for; raises OutOfReach when its bench or protocol cannot have it."""
    stratum, protocol = cast(Stratum, planned.stratum), cast(Kind, planned.protocol)
    return draw_case(planned.seed, stratum, protocol, planned.effects, planned.kappas or (1.0,))


def concealed(planned: Planned, runs: Path) -> Answer:
    """Write one case's run folder and return its answer; if the case cannot be made, the answer says why."""
    wanted: Any = asdict(planned)
    question: Answer = {"run": planned.run, "asked": wanted}
    try:
        if planned.author:
            authored_case = authored.made(planned)
            content = authored.described(planned.run, authored_case)
            write_run(content, authored_case.table, runs / planned.run)
            return {**question, **authored.answer(planned, authored_case)}
        case = drawn(planned)
    except (OutOfReach, authored.OutOfReach) as error:
        return {**question, "skipped": str(error)}
    recorded = performed(case)
    write_run(case.bench.described(planned.run, not case.load_cell), recorded.table, runs / planned.run)
    return {**question, **answer(case, planned.run)}


@program
def main() -> None:
    """Write RUNS/<run>/ for every case, and the answers of all of them."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.proof.conceal_batch", description=__doc__)
    parser.add_argument("--cases", type=read, required=True, help="JSON, as pipeline.proof.plan writes it")
    parser.add_argument("--runs", type=Path, required=True)
    parser.add_argument("--answers", type=Path, required=True)
    arguments = parser.parse_args()
    if arguments.answers.resolve().is_relative_to(arguments.runs.resolve()):
        raise BadInput(arguments.answers, "--answers", "lies where recordings are read", "seal it outside of --runs")
    arguments.runs.mkdir(parents=True, exist_ok=True)
    answers = [concealed(planned, arguments.runs) for planned in arguments.cases]
    write_text(arguments.answers, json.dumps(answers, indent=1, default=plain) + "\n")
    skipped = [f"{skip['run']}: {skip['skipped']}" for skip in answers if "skipped" in skip]
    print("\n".join([f"{len(answers) - len(skipped)} recordings concealed", *skipped]))


if __name__ == "__main__":
    main()
