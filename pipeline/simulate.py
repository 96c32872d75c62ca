"""The improved simulator alone: inputs and a diagnosis → predicted displacement; no measurement but for the tare."""

import sys
from dataclasses import dataclass
from pathlib import Path

import pandas as pd

from .diagnosis import planned_words, recorded_error
from .diagnosis.planned_columns import planned_columns
from .diagnosis.prediction.planned_motion import tied_with
from .diagnosis.recording.recorded_run import RecordedRun
from .diagnosis.residual_columns import black_box
from .diagnosis.simulate_options import SimulateOptions, parsed
from .diagnosis.simulated_plan import simulated_plan
from .diagnosis.simulated_recording import SimulatedRecording
from .diagnosis.simulator import Simulator
from .diagnosis.simulator_words import by, of_another, of_dimensions, of_simulator
from .diagnosis.words.foretold import loop_table
from .diagnosis.words.foretold.corner_table import corners
from .diagnosis.words.foretold.home import of_carried_over, of_home
from .diagnosis.words.foretold.planned_zero import of_zero
from .diagnosis.words.foretold.prediction import AFTER_RECORDING, of_ties
from .diagnosis.words.foretold.residual import RESIDUAL
from .diagnosis.words.language.quantity import listing
from .diagnosis.words.language.sections import numbered
from .diagnosis.words.language.vocabulary import Vocabulary
from .ground.command import START
from .ground.errors import BadInput, program
from .ground.input.outputs import file_to_write
from .ground.stored import schemas
from .ground.stored.files import write_text
from .ground.words.counts import counted
from .ground.words.wrapped_lines import wrapped
from .run.description import Run
from .run.folder import has_recording, read_run
from .run.planned_motion.planned import load_taken, read_plan
from .run.samples import read_strokes


@dataclass(frozen=True)
class Answer:
    """What is given of a simulated motion of a run.

    `table`: what is written. `by`: with what it was simulated. `drawn`: a table that is printed as it stands. `lines`:
    what is said of it, an entry a paragraph.
    """

    run: Run
    table: pd.DataFrame
    by: str
    drawn: list[str]
    lines: list[str]


def of_plan(options: SimulateOptions, motion: Path) -> Answer:
    """The motion that a file plans for a run, alone or after its recording. Raises BadInput."""
    has_samples = has_recording(options.run_dir)
    if options.after_recording and not has_samples:
        mend = f"record the run first, or leave {AFTER_RECORDING} out"
        raise BadInput(options.run_dir, AFTER_RECORDING, "needs a recording, and there is none", mend)
    recorded = RecordedRun(*read_strokes(options.run_dir), options.run_dir) if has_samples else None
    run = recorded.run if recorded else read_run(options.run_dir)
    simulator = Simulator.read(run, options.run_dir, options.simulation)
    planned = read_plan(motion)
    plan = simulated_plan(run, options.run_dir, recorded, simulator, planned, motion, options.after_recording)
    called, channel = Vocabulary.of(run.system), run.system.channel
    warn(of_another(simulator, run, options.run_dir))
    warn(planned_words.of_outside(plan, motion))
    plan_columns = planned_columns(plan, simulator)
    words = [*load_taken(run, planned, plan.samples, recorded and recorded.samples)]
    words += [*planned_words.of_columns(plan, plan_columns, options), *of_simulator(simulator, run, plan.before)]
    columns = plan_columns.columns
    if options.residual:
        recordings = [each for each in (recorded, *plan.beside) if each]
        more, more_words = black_box(plan.problem, run, plan, options.run_dir, simulator, recordings)
        columns, words = columns | more, words + more_words
    table = plan.table(columns)
    begins = simulator.acting if recorded and not plan.after else None
    words += [of_zero(plan, called)] * run.system.free_zero
    words += of_ties(simulator.acting, len(plan.tied), list(table))
    drawn = corners(table, run.system.driver, channel) if plan.drawn else []
    lines = [*loop_table.printed(table, called, channel, begins), *numbered(words)]
    return Answer(run, table, by(simulator, simulator.source), drawn, lines)


def of_recording(options: SimulateOptions) -> Answer:
    """The recorded motion of a run. Raises BadInput."""
    recorded = RecordedRun(*read_strokes(options.run_dir), options.run_dir)
    run, channel = recorded.run, recorded.run.system.channel
    simulated = SimulatedRecording(recorded, Simulator.read(run, options.run_dir, options.simulation), options.home)
    source, carried = simulated.asked.source, simulated.carried
    warn(of_another(simulated.asked, run, options.run_dir))
    if carried:
        unit = simulated.problem.drivers.units.reading
        show([*of_carried_over(carried, run.run, unit), *of_home(carried, unit)])
    simulator, predicted = simulated.simulator, simulated.predicted
    columns = {"time_s": recorded.samples["time_s"].to_numpy(), channel: predicted}
    words = of_simulator(simulator, run, simulated.before)
    if options.residual and carried and not carried.whole:
        learnt = f"was learnt beside all of the diagnosis, of which {run.run} takes a part"
        raise BadInput(source, RESIDUAL, learnt, "leave it out, or diagnose this run itself")
    if options.residual:
        recordings = [recorded, *simulated.before]
        more, more_words = black_box(simulated.problem, run, None, options.run_dir, simulator, recordings)
        columns, words = columns | more, words + more_words
    tied = tied_with(run, simulator.content, simulator.given is None) if not carried or carried.effects else []
    words += of_ties(simulator.acting, len(tied), list(columns))
    own_dimensions = carried is not None and not carried.dimensions
    dimensions = options.run_dir / "run.yaml" if own_dimensions else source
    lines = [*numbered(words), *recorded_error.lines(simulated, options.run_dir)]
    return Answer(run, pd.DataFrame(columns), by(simulator, dimensions), [], lines)


def warn(warnings: list[str]) -> None:
    """Print warnings where errors go."""
    for warning in warnings:
        print(f"warning: {warning}", file=sys.stderr)


def show(lines: list[str]) -> None:
    """Print lines within the width of a page; one that holds a command stays whole, for a person copies that."""
    for line in lines:
        print("\n".join([line] if START in line else wrapped(line, "")))


def write(table: pd.DataFrame, path: Path) -> None:
    """Write what was simulated, whole or not at all: as text where the name ends like that, else as Parquet."""
    if path.suffix.lower() == ".csv":
        write_text(path, table.to_csv(index=False, float_format="%.9g"))
    else:
        schemas.write(table, schemas.samples(list(table.columns)), path)


@program
def main() -> None:
    """Command line."""
    options = parsed(str(__doc__))
    reads = [options.simulation or options.run_dir / "run.yaml", *([options.motion] if options.motion else [])]
    file_to_write(options.out, reads=reads)
    answer = of_plan(options, options.motion) if options.motion else of_recording(options)
    write(answer.table, options.out)
    print(f"{answer.run.run}: {counted(len(answer.table), 'sample')} simulated {answer.by}")
    print(f"{options.out} holds {listing(list(answer.table))}")
    if answer.drawn:
        print("\n".join(answer.drawn))
    show(answer.lines)
    if not options.simulation:
        warn(of_dimensions(answer.run, options.run_dir))


if __name__ == "__main__":
    main()
