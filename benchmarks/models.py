"""How long models take to be as good as an INN built with FrEIA as the paper says: CPU seconds of one thread.

`python benchmarks/models.py --out docs` trains, for each seed and each in a process of its own, FrEIA's seven GLOW
blocks (3 × 256 ReLU, random permutations, clamp 2, Adam with the paper's four rates in equal quarters, both losses, 40
epochs, the paper's five inputs) on the paper's rig, then our models, without the direction (what FrEIA's five inputs
know) and with it. The target of a seed is FrEIA's error over its last three epochs, plus 2 %, both ways. FrEIA is
given the first epoch that reaches it; ours the whole of the shortest training budget that does. Evaluation is not
counted.
"""

import argparse
import json
import math
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT))

import pipeline  # noqa: E402, F401, I001  (one thread of linear algebra: before numpy)
import matplotlib  # noqa: E402
import numpy as np  # noqa: E402
import pandas as pd  # noqa: E402

matplotlib.use("svg")
SEEDS, EPOCHS, BATCH, SLACK = 5, 40, 125, 1.02
BUDGETS = (2, 3, 4, 6, 8, 12, 16, 24, 32, 45)  # epochs that a network of ours may be trained for
OURS = {
    "cinn, no direction": ("cinn", {"direction": False}, BUDGETS),
    "spline, no direction": ("spline", {"direction": False}, None),
    "cinn": ("cinn", {}, BUDGETS),
    "spline": ("spline", {}, None),
}


def dataset(path: Path) -> pd.DataFrame:
    """The paper's rig, recorded and made into a dataset; 5,000 training points in the split `within`."""
    from pipeline.stages.dataset import make_dataset
    from pipeline.string.from_raw import read

    if not path.is_file():
        folder = path.parent / "synthetic-01"
        command = [sys.executable, "-m", "pipeline.rig.record", "paper", str(folder), "--seed", "1"]
        subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
        make_dataset([read(folder)]).to_parquet(path)
    return pd.read_parquet(path)


def errors(model, test: pd.DataFrame) -> list[float]:
    """Held-out forward RMSE in mm and inverse RMSE in turns."""
    forward = model.forward(test) - test["displacement_mm"]
    inverse = model.inverse(test) - test["motor_turns"]
    return [float(np.sqrt(np.mean(error**2))) for error in (forward, inverse)]


class Freia:
    """FrEIA's blocks, trained as the paper says; `history` holds CPU seconds and errors after each epoch."""

    def __init__(self, test: pd.DataFrame) -> None:
        self.test, self.history = test, []

    def fit(self, points: pd.DataFrame, seed: int) -> None:
        """Train, evaluating after each epoch off the clock."""
        import torch
        from freia import papers_inn
        from torch.nn.functional import mse_loss

        from pipeline.models.parts.condition_columns import contraction_and_conditions, twist_and_conditions
        from pipeline.models.parts.scaling import Scaling

        torch.set_num_threads(1)
        torch.manual_seed(seed)
        self.net = papers_inn()
        inputs, outputs = twist_and_conditions(points), contraction_and_conditions(points)
        self.inputs, self.outputs = Scaling.of(inputs), Scaling.of(outputs)
        x = torch.tensor(self.inputs.scaled(inputs), dtype=torch.float32)
        y = torch.tensor(self.outputs.scaled(outputs), dtype=torch.float32)
        optimiser = torch.optim.Adam(self.net.parameters(), lr=8e-4)
        spent_s = 0.0
        for epoch in range(EPOCHS):
            began_s = time.process_time()
            optimiser.param_groups[0]["lr"] = (8e-4, 4e-4, 1e-4, 5e-5)[epoch * 4 // EPOCHS]
            for rows in torch.randperm(len(x)).split(BATCH):
                optimiser.zero_grad()
                loss = mse_loss(self.net(x[rows], jac=False)[0], y[rows])
                loss = loss + mse_loss(self.net(y[rows], rev=True, jac=False)[0], x[rows])
                loss.backward()
                optimiser.step()
            spent_s += time.process_time() - began_s
            self.history.append([spent_s, *errors(self, self.test)])

    def _mapped(self, table, scale_in, scale_out, rev: bool):
        import torch

        with torch.no_grad():
            scaled = torch.tensor(scale_in.scaled(table), dtype=torch.float32)
            return scale_out.restored(self.net(scaled, rev=rev, jac=False)[0].double().numpy())[:, 0]

    def forward(self, points: pd.DataFrame):
        """Contraction in mm."""
        from pipeline.models.parts.condition_columns import twist_and_conditions

        return self._mapped(twist_and_conditions(points), self.inputs, self.outputs, rev=False)

    def inverse(self, points: pd.DataFrame):
        """Twist in turns."""
        from pipeline.models.parts.condition_columns import contraction_and_conditions

        return self._mapped(contraction_and_conditions(points), self.outputs, self.inputs, rev=True)


def one(name: str, seed: int, data: Path, target: list[float]) -> dict[str, object]:
    """One model and seed: CPU seconds to the target, errors, and peak memory of the process."""
    points = dataset(data)
    train, test = points[points["within"] == "train"], points[points["within"] == "test"]
    if name == "FrEIA":
        model = Freia(test)
        model.fit(train, seed)
        last = np.median(np.array(model.history)[-3:, 1:], axis=0) * SLACK
        reached = next((row[0] for row in model.history if row[1] <= last[0] and row[2] <= last[1]), math.nan)
        result = {"target": last.tolist(), "to_target_s": reached, "errors": model.history[-1][1:]}
        result["whole_s"] = model.history[-1][0]
    else:
        from pipeline.models.interface import make_model

        kind, settings, budgets = OURS[name]
        if kind != "spline":
            make_model(kind, **settings, epochs=1).fit(train.iloc[:500], seed)  # imports and first calls, for all alike
        for epochs in budgets or (None,):
            model = make_model(kind, **settings, **({"epochs": epochs} if epochs else {}))
            began_s = time.process_time()
            model.fit(train, seed)
            spent_s = time.process_time() - began_s
            found = errors(model, test)
            reached = all(error <= goal for error, goal in zip(found, target, strict=True))
            if reached:
                break
        result = {"to_target_s": spent_s if reached else math.nan, "errors": found, "epochs": epochs}
    return {**result, "peak_mb": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024}


def ask(name: str, seed: int, data: Path, target: list[float]) -> dict[str, object]:
    """`one` in a process of its own."""
    command = [sys.executable, __file__, "--one", name, "--seed", str(seed), "--data", str(data)]
    done = subprocess.run(
        [*command, "--target", json.dumps(target)], cwd=ROOT, check=True, capture_output=True, text=True
    )
    return json.loads(done.stdout.splitlines()[-1])


def report(rows: pd.DataFrame, out: Path) -> str:
    """The table, and a figure of CPU seconds by model and seed."""
    from matplotlib import pyplot as plt

    theirs = rows[rows["model"] == "FrEIA"].set_index("seed")["to_target_s"]
    heads = ["model", "forward (mm)", "inverse (turns)", "CPU s to FrEIA's errors", "times faster (lowest)"]
    lines = [" | ".join(["", *heads, "peak memory (MB)", ""]).strip(), "| --- " * (len(heads) + 1) + "|"]
    figure, axes = plt.subplots(figsize=(6.4, 3.0), layout="constrained")
    names = list(dict.fromkeys(rows["model"]))
    for place, name in enumerate(reversed(names)):
        mine = rows[rows["model"] == name]
        axes.plot(mine["to_target_s"], np.full(len(mine), place), "o", ms=5, alpha=0.7, color="#0072b2")
    for name in names:
        mine = rows[rows["model"] == name].set_index("seed")
        ratio = theirs / mine["to_target_s"]
        missed = int(mine["to_target_s"].isna().sum())
        spent = f"{mine['to_target_s'].median():.3g}" + (f" ({missed} of {len(mine)} seeds never)" if missed else "")
        faster = "1" if name == "FrEIA" else f"{ratio.median():.3g} ({ratio.min():.3g})"
        cells = [name, f"{mine['forward'].median():.4f}", f"{mine['inverse'].median():.4f}", spent, faster]
        lines.append(" | ".join(["", *cells, f"{mine['peak_mb'].median():.0f}", ""]).strip())
    axes.set_yticks(range(len(names)), list(reversed(names)))
    axes.set_xscale("log")
    axes.set_xlabel("CPU seconds of one thread to FrEIA's held-out errors, forward and inverse")
    axes.grid(axis="x", alpha=0.3)
    out.mkdir(parents=True, exist_ok=True)
    figure.savefig(out / "speed.svg", metadata={"Date": None})
    return "\n".join(lines) + "\n"


def main() -> None:
    """All models, seed by seed, one after the other."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("docs"))
    parser.add_argument("--seeds", type=int, default=SEEDS)
    parser.add_argument("--one", help="used by the program itself")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--data", type=Path)
    parser.add_argument("--target", type=json.loads, default=[0.0, 0.0])
    asked = parser.parse_args()
    if asked.one:
        print(json.dumps(one(asked.one, asked.seed, asked.data, asked.target)))
        return
    rows = []
    with tempfile.TemporaryDirectory() as place:
        data = Path(place) / "dataset.parquet"
        dataset(data)
        for seed in range(asked.seeds):
            target: list[float] = [0.0, 0.0]
            for name in ("FrEIA", *OURS):
                found = ask(name, seed, data, target)
                target = found.get("target", target)
                row = {"model": name, "seed": seed, "forward": found["errors"][0], "inverse": found["errors"][1]}
                rows.append({**row, **{key: found.get(key) for key in ("to_target_s", "whole_s", "epochs", "peak_mb")}})
                print(json.dumps(rows[-1]), flush=True)
    print(report(pd.DataFrame(rows), asked.out))


if __name__ == "__main__":
    main()
