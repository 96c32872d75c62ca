"""What `simulate` prints of a recorded motion: its error, what that is to be set beside, and what it says."""

import shlex
from pathlib import Path

from ..ground.command import command
from ..run.folder import read_run
from .one_rig import to_take_out
from .prediction.another_rig import of_same_string
from .prediction.errors_to_compare import ToCompare
from .prediction.simulation import compared, has_zero, off
from .simulated_recording import SimulatedRecording
from .words.foretold.recorded_error import A_PART, SWITCHED_OFF, beside, computed_of, means
from .words.language.quantity import number, size


def lines(simulated: SimulatedRecording, folder: Path) -> list[str]:
    """The lines, the error first, of a recorded motion that was simulated; `folder` is where its run lies."""
    recorded, problem, carried = simulated.recorded, simulated.problem, simulated.carried
    run, system, unit = recorded.run, problem.system, problem.drivers.units.reading
    content, diagnosis = simulated.simulator.content, simulated.simulator.diagnosis(run)[1]
    measured, shown = compared(run, problem, simulated.predicted)
    error, at_best_zero = off(measured, shown)
    own_zero = has_zero(content, system, run.run, 1 + len(simulated.before))
    zero = f", its zero {'as it was fitted' if own_zero else 'set in the first second'}" * system.free_zero
    every_s = problem.drivers.step_s * round(len(simulated.predicted) / len(shown))
    of_means = f", of averages of {number(every_s)} s" * (len(shown) < len(simulated.predicted))
    set_at_first = system.free_zero and not own_zero
    errors = ToCompare.of(diagnosis, system.channel.rpartition("_")[2]) if diagnosis else None
    bare = simulated.without_effects
    without = None if bare is None else off(*compared(run, problem, bare))[0]
    taken = carried is None or carried.effects or carried.dimensions
    hint = "" if carried else SWITCHED_OFF if system.homed else A_PART
    same = of_same_string(content, run, folder)
    folders = [shlex.quote(str(place)) for place in [*same, folder]]
    diagnosed = [f"{command('diagnose')} {' '.join(folders)} --together --out DIR"]
    adopting = to_take_out([*((read_run(place), place) for place in same), (run, folder)])
    return [
        computed_of(system, recorded.samples, set_at_first, carried is not None),
        f"rms error against the recording{zero}: {size(error, unit)}{of_means}",
        *beside(at_best_zero if set_at_first else None, without, simulated.simulator.acting, errors, unit),
        *means(
            at_best_zero if set_at_first else error,
            run.run,
            errors,
            diagnosis,
            hint,
            unit,
            taken,
            set_at_first,
            [*adopting, *diagnosed] if same else [],
        ),
    ]
