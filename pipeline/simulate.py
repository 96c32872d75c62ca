"""The improved simulator alone: inputs and a diagnosis → predicted displacement; no measurement but for the tare."""

import argparse
import json
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from pipeline import schemas
from pipeline.diagnosis.adopt import acts_from
from pipeline.diagnosis.engine import at_own_rate
from pipeline.diagnosis.problem import Problem, State
from pipeline.errors import BadInput, program
from pipeline.ingest import read_samples
from pipeline.kinematics import Array

TARE_S = 1.0


def state_of(content: dict[str, Any], problem: Problem, path: Path) -> State:
    """The simulator that a diagnosis describes; its zero is left at 0 when the diagnosis has none."""
    given = content.get("parameters", {})
    values = [float(given.get(one.name, {}).get("value", one.nominal)) for one in problem.parameters]
    acts = acts_from(content.get("simulation", []), problem.drivers, str(path))
    return State(np.array(values), np.zeros(problem.runs), acts)


def tare(predicted: Array, measured: Array, time_s: Array) -> float:
    """What to add so that prediction and measurement agree on the first second."""
    start = time_s - time_s[0] <= TARE_S
    return float(np.median((measured - predicted)[start]))


@program
def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("run_dir", type=Path)
    parser.add_argument("--simulation", type=Path, required=True, help="a diagnosis.json")
    parser.add_argument("--out", type=Path, required=True)
    arguments = parser.parse_args()
    run, samples = read_samples(arguments.run_dir)
    try:
        content = json.loads(arguments.simulation.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise BadInput(arguments.simulation, "file", f"cannot be read ({error})", "give a diagnosis.json") from None
    problem = at_own_rate([run], [samples])
    predicted = problem.simulate(state_of(content, problem, arguments.simulation))
    unit = problem.system.channel.rpartition("_")[2]
    zero = content.get("parameters", {}).get(f"zero_{unit}", {}).get("value")
    same = content.get("run") == run.run and zero is not None
    predicted = predicted + (float(zero) if same else tare(predicted, problem.measured, problem.record.time_s))
    table = pd.DataFrame({"time_s": samples["time_s"].to_numpy(), problem.system.channel: predicted})
    schemas.write(table, schemas.samples(list(table.columns)), arguments.out)
    print(f"{run.run}: {len(table)} samples simulated")


if __name__ == "__main__":
    main()
