"""The improved simulator alone: inputs and a diagnosis → predicted displacement; no measurement but for the tare."""

import argparse
import shlex
import sys
from pathlib import Path
from typing import cast

import pandas as pd

from .diagnosis import recorded_error
from .diagnosis.document.content import Simulated, Verdict
from .diagnosis.planned_columns import planned_columns
from .diagnosis.prediction.another_rig import other_dimensions, other_names
from .diagnosis.prediction.carried_over import carried_over
from .diagnosis.prediction.later_run import before_of, predicted_after, said_of, simulated_before
from .diagnosis.prediction.planned_motion import Plan, recorded_beside, tied_with
from .diagnosis.prediction.prediction_band import adopted_diagnosis
from .diagnosis.prediction.simulation import measured_since, of_run, read_diagnosis
from .diagnosis.prediction.without_a_name import said_of_no_name, to_simulate
from .diagnosis.recording.recorded_run import RecordedRun
from .diagnosis.residual_columns import black_box
from .diagnosis.simulate_options import parsed
from .diagnosis.study.engine import make_problem
from .diagnosis.study.own_rate import at_own_rate
from .diagnosis.words.foretold import loop_table
from .diagnosis.words.foretold.another_rig import warning as another_rig
from .diagnosis.words.foretold.corner_table import corners
from .diagnosis.words.foretold.home import of_carried_over, of_home
from .diagnosis.words.foretold.planned_zero import of_zero
from .diagnosis.words.foretold.prediction import AFTER_RECORDING, of_ties
from .diagnosis.words.foretold.residual import RESIDUAL
from .diagnosis.words.language.quantity import listing
from .diagnosis.words.language.sections import numbered, wrapped
from .diagnosis.words.language.vocabulary import Vocabulary
from .diagnosis.words.measured.dimensions import name_of
from .diagnosis.words.pages.advice import contrary
from .ground import schemas
from .ground.command import START, command
from .ground.counts import counted
from .ground.errors import BadInput, program
from .ground.files import write_text
from .ground.outputs import file_to_write
from .run.description import Run
from .run.folder import has_recording, read_run
from .run.planned import planned
from .run.samples import read_strokes


def warn_of_dimensions(run: Run, folder: Path) -> None:
    """Say where a dimension of run.yaml is another than it was when effects were adopted, which fit no more."""
    changed = measured_since(run)
    if changed:
        names = listing([f"the {name_of(name)}" for name in changed])
        print(
            f"warning: {names} in run.yaml changed since the effects were adopted. The dimensions of run.yaml are "
            "taken, and the effects may not fit them. Mend: take the effects out, diagnose again and adopt anew: "
            f"{command('adopt')} --remove {shlex.quote(str(folder))}",
            file=sys.stderr,
        )


def warn_of_another(content: Simulated, run: Run, folder: Path) -> None:
    """Say where a run is of another string or rig than the runs that a diagnosis was made of."""
    runs = content.get("run")
    runs = [str(name) for name in (runs if isinstance(runs, list) else [runs])]
    if run.run not in runs:
        dimensions, names = other_dimensions(content, run), other_names(content, run, folder)
        if warning := another_rig(run.run, runs, dimensions, names, Vocabulary.of(run.system)):
            print(f"warning: {warning}", file=sys.stderr)


def plan_of(arguments: argparse.Namespace) -> Plan:
    """The motion that is planned for a run, and what simulates it. Raises BadInput."""
    source = source_of(arguments)
    has_samples = has_recording(arguments.run_dir)
    if arguments.after_recording and not has_samples:
        mend = f"record the run first, or leave {AFTER_RECORDING} out"
        raise BadInput(arguments.run_dir, AFTER_RECORDING, "needs a recording, and there is none", mend)
    recorded = RecordedRun(*read_strokes(arguments.run_dir), arguments.run_dir) if has_samples else None
    run = recorded.run if recorded else read_run(arguments.run_dir)
    samples, drawn = planned(run, arguments.motion, recorded and recorded.samples)
    content = to_simulate(read_diagnosis(source), run.run) if arguments.simulation else of_run(run)
    tied = tied_with(run, content, arguments.simulation is None)
    beside = recorded_beside(arguments.run_dir, run, content, arguments.simulation is None) if recorded else []
    together = run.adopted[-1].runs if run.adopted and not arguments.simulation else content.get("run")
    before = before_of({**content, "run": together or run.run}, run.run, beside)
    return Plan(run, samples, drawn, recorded, content, source, arguments.after_recording, tied, beside, before)


def source_of(arguments: argparse.Namespace) -> Path:
    """The file of what simulates: a diagnosis.json, or the run's own run.yaml."""
    return Path(arguments.simulation or arguments.run_dir / "run.yaml")


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
    arguments = parsed(str(__doc__))
    source = source_of(arguments)
    file_to_write(arguments.out, reads=[source, *([arguments.motion] if arguments.motion else [])])
    plan = plan_of(arguments) if arguments.motion else None
    carried = None
    if plan:
        run, samples, content, before = plan.run, plan.samples, plan.content, plan.before
        problem, predicted = plan.problem, plan.predicted
        all_read = [each for each in (plan.recorded, *plan.beside) if each]
        if arguments.simulation:
            warn_of_another(content, run, arguments.run_dir)
    else:
        recorded = RecordedRun(*read_strokes(arguments.run_dir), arguments.run_dir)
        run, samples = recorded.run, recorded.samples
        content = to_simulate(read_diagnosis(source), run.run) if arguments.simulation else of_run(run)
        problem = at_own_rate([recorded], thin=False, to_fit=False)
        if arguments.simulation:
            warn_of_another(content, run, arguments.run_dir)
        if arguments.home:
            coarse = make_problem([recorded], to_fit=False)
            carried = carried_over(problem, content, source, run.run, coarse)
            content, unit = carried.content, problem.drivers.units.reading
            show([*of_carried_over(carried, run.run, unit), of_home(carried, unit)])
        before = simulated_before(content, run.run, arguments.run_dir)
        predicted = predicted_after(before, recorded, problem, content, source)
        all_read = [recorded, *before]
    called = Vocabulary.of(problem.system)
    columns, words = planned_columns(plan, arguments) if plan else ({}, [])
    words += [*said_of(content, run.run, before, source), *said_of_no_name(content, called.ending)]
    advised = contrary(cast(Verdict, content), called) if arguments.simulation and content["simulation"] else ""
    words += [f"beware: the verdict advises against what is simulated: {advised.rstrip('.')}"] if advised else []
    if arguments.residual and carried and not carried.whole:
        learnt = f"was learnt beside all of the diagnosis, of which {run.run} takes a part"
        raise BadInput(source, RESIDUAL, learnt, "leave it out, or diagnose this run itself")
    if arguments.residual:
        given = source if arguments.simulation else None
        more, more_words = black_box(problem, run, plan, arguments.run_dir, given, all_read)
        columns, words = columns | more, words + more_words
    columns = {"time_s": samples["time_s"].to_numpy(), problem.system.channel: predicted} | columns
    columns |= plan.inputs if plan else {}
    table = pd.DataFrame(columns)
    write(table, arguments.out)
    acting = listing(list(dict.fromkeys(entry["id"] for entry in content["simulation"]))) or "no mechanism"
    fitted = "that fit with them, in" if content["parameters"] and not arguments.simulation else "of"
    held = arguments.run_dir / "run.yaml" if carried and not carried.dimensions else source
    print(f"{run.run}: {counted(len(samples), 'sample')} simulated with {acting} and the dimensions {fitted} {held}")
    print(f"{arguments.out} holds {listing(list(columns))}")
    if plan and plan.drawn:
        print("\n".join(corners(table, problem.system.driver, problem.system.channel)))
    begins = acting if plan and plan.recorded and not plan.after else None
    loops = loop_table.printed(table, called, problem.system.channel, begins) if plan else []
    if plan and problem.system.free_zero:
        words.append(of_zero(plan, called))
    tied = plan.tied if plan else tied_with(run, content, arguments.simulation is None)
    tied = [] if carried and not carried.effects else tied
    words += of_ties(acting, len(tied), list(columns))
    show([*loops, *numbered(words)])
    if plan is None:
        without: Simulated = {**content, "simulation": []}
        bare = predicted_after(before, recorded, problem, without, source) if content["simulation"] else None
        named = None if arguments.simulation else adopted_diagnosis(run)[1]
        diagnosis = cast(Verdict, content) if arguments.simulation else named
        ran_before, place = len(before), arguments.run_dir
        show(
            recorded_error.lines(
                recorded, problem, predicted, bare, content, diagnosis, acting, ran_before, place, carried
            )
        )
    if not arguments.simulation:
        warn_of_dimensions(run, arguments.run_dir)


if __name__ == "__main__":
    main()
