"""Run every baseline on recordings: whom it names, and its error on strokes that it has not seen."""

import argparse
import importlib
import json
import time
from functools import cache
from pathlib import Path

from threadpoolctl import threadpool_limits

from ...diagnosis.recording.recorded_run import RecordedRun
from ...diagnosis.study import engine, own_rate
from ...ground.code.modules import holding
from ...ground.errors import program
from ...ground.stored.files import write_text
from ...run.folder import read_run
from ...run.samples import read_strokes
from .learnt import Method, Said, calibrated, held_out_mm


@cache
def names() -> tuple[str, ...]:
    """Names of all methods, sorted: of the files beside this one that hold a function `learn`."""
    return holding(Path(__file__).parent, r"def learn\(")


def method(name: str) -> Method:
    """A method by the name of its module."""
    learn: Method = importlib.import_module(f"{__package__}.{name}").learn
    return learn


def baselines(folder: Path) -> dict[str, Said]:
    """What every method says of one run folder; names come from the whole recording. Raises BadInput."""
    recorded = [RecordedRun(*read_strokes(folder), folder)]
    problem, fine = engine.make_problem(recorded), own_rate.at_own_rate(recorded)
    whole = calibrated(problem)
    answers: dict[str, Said] = {}
    for name in names():
        began_s = time.process_time()
        with threadpool_limits(1):  # so that seconds compare, and runs may go side by side
            named = method(name)(whole).named
            error_mm = held_out_mm(method(name), problem, fine)
        error_mm = None if error_mm is None else float(f"{error_mm:.6g}")
        seconds = round(time.process_time() - began_s, 2)  # CPU, as of a diagnosis
        answers[name] = {"named": named, "heldout_mm": error_mm, "seconds": seconds}
    return answers


@program
def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.proof.baselines", description=__doc__)
    parser.add_argument("run_dir", type=Path, nargs="+")
    parser.add_argument("--out", type=Path, required=True, help="the folder in which each run gets a folder; required")
    arguments = parser.parse_args()
    for folder in arguments.run_dir:
        answers = baselines(folder)
        run = read_run(folder).run
        text = json.dumps({"run": run, **answers}, indent=1) + "\n"
        write_text(arguments.out / folder.resolve().name / "baselines.json", text)
        errors = (f"{name} {answers[name]['named']} {answers[name]['heldout_mm']} mm" for name in names())
        print(f"{run}: {'; '.join(errors)}", flush=True)


if __name__ == "__main__":
    main()
