"""What the best explanation that a diagnosis found foretells of strokes that it has not seen, though it is not named.

    python benchmarks/unnamed_physics.py processed/real/raw/RUN [RUN ...]

repeats the held-out part of a diagnosis and prints a line a run: the error (rms, in the reading's unit) of the
calibrated simulator, of the simulator as diagnosed (where the verdict is `unknown`, with what comes closest if that
predicts), of the best explanation whatever the verdict, and of that one with what boosted trees add to it; and which
driver these follow.
"""

import argparse
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from pipeline.diagnosis.choice.outcome import rms
from pipeline.diagnosis.fit.flexible import foretold
from pipeline.diagnosis.fit.problem import State
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.recording.working_samples import wild
from pipeline.diagnosis.study import engine, own_rate, polish
from pipeline.diagnosis.study.heldout import first_held_out
from pipeline.ground.kinematics import Array
from pipeline.run.samples import read_strokes


def line(folder: Path) -> str:
    """The line of one run."""
    recorded = [RecordedRun(*read_strokes(folder))]
    problem, fine = engine.make_problem(recorded), own_rate.to_score(recorded)
    finer, row = own_rate.to_polish(recorded, fine), first_held_out(problem)
    if row is None:
        return f"{folder.name}: too few strokes"
    begins_s = problem.record.time_s[row]
    unseen = fine.record.time_s >= begins_s
    seen_rows = int(np.argmax(finer.record.time_s >= begins_s))
    studied = polish.polished(engine.study(problem.until(row)), finer.until(seen_rows))

    def error(state: State, added: Array | float = 0.0) -> float:
        left = fine.measured - fine.simulate(state) - added
        return rms(left[unseen & ~wild(left)[0]])

    more = foretold(problem, fine, studied.best, problem.record.time_s >= begins_s)
    errors = [error(studied.base), error(studied.simulator), error(studied.best), error(studied.best, more.added)]
    words = "calibrated {:.4g}, as diagnosed {:.4g}, best explanation {:.4g}, with trees {:.4g}".format(*errors)
    ids = " + ".join(studied.best_ids) or "nothing"
    return f"{folder.name}: {words}; {studied.verdict}; best: {ids}; trees follow {more.driver}"


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run_dir", type=Path, nargs="+")
    for folder in parser.parse_args().run_dir:
        print(line(folder), flush=True)


if __name__ == "__main__":
    main()
