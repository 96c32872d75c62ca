"""Time of one query: the exported C header beside ONNX Runtime, Python and FrEIA, one process, one thread.

    python benchmarks/latency.py processed/<material>

prints a Markdown table of microseconds: medians over rounds, of one query and, where a way takes tables, of one in a
table of 1000. The folder holds fitted models as the workflow puts them. Another way is another function in `WAYS`.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"  # before numpy, torch and the runtime start their threads

import argparse
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from pipeline.export.c_header import header
from pipeline.export.interface import Source
from pipeline.export.onnx_model import GIVEN, graphs
from pipeline.export.source import Beside, opened
from pipeline.ground.errors import BadInput

MODELS = ("spline", "cinn", "inn")
ROUNDS, C_ROUNDS, TABLE = 61, 501, 1000
C_FLAGS = ("-std=gnu99", "-O3", "-march=native")


@dataclass(frozen=True)
class Row:
    """One line of the table, times in µs a query; NaN where there is none."""

    model: str
    way: str
    map: str
    single_us: float
    table_us: float = float("nan")

    def __str__(self) -> str:
        times = ["" if np.isnan(us) else f"{us:.3g}" for us in (self.single_us, self.table_us)]
        return f"| {self.model} | {self.way} | {self.map} | {times[0]} | {times[1]} |"


def timed_us(query: Callable[..., Any], *given: Any, queries: int = 1, **options: Any) -> float:
    """Median time of a call in µs, shared among its queries; calls are repeated to last a ms at least."""
    query(*given, **options)
    began_s = time.perf_counter()
    query(*given, **options)
    repeats = max(1, int(1e-3 / max(time.perf_counter() - began_s, 1e-9)))
    rounds = []
    for _ in range(ROUNDS):
        began_s = time.perf_counter()
        for _ in range(repeats):
            query(*given, **options)
        rounds.append((time.perf_counter() - began_s) / repeats)
    return float(np.median(rounds)) * 1e6 / queries


def in_c(name: str, source: Source) -> Iterator[Row]:
    """The header, compiled."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        (folder / "model.h").write_text(header(source, "tsa"))
        fields = "".join(
            f"states[i].{f.name} = (int)TSA_{f.name.upper()}_MIN;"
            if f.whole
            else f"states[i].{f.name} = between(TSA_{f.name.upper()}_MIN, TSA_{f.name.upper()}_MAX);"
            for f in source.inputs.fields
            if f.name not in ("stroke", "direction")
        )
        rounds = C_ROUNDS if name != "inn" else C_ROUNDS // 10
        defined = ["-include", folder / "model.h", f"-DFIELDS={fields}", f"-DROUNDS={rounds}"]
        code = Path(__file__).with_suffix(".c")
        subprocess.run(["gcc", *C_FLAGS, *defined, code, "-o", folder / "latency", "-lm"], check=True)
        said = subprocess.run([folder / "latency"], capture_output=True, text=True, check=True).stdout
    for line in said.splitlines():
        way, _, ns = line.partition(" ")
        map_, _, prepared = way.partition("_")
        yield Row(name, "C header, prepared" if prepared else "C header", map_, float(ns) / 1e3)


def in_python(name: str, source: Source) -> Iterator[Row]:
    """The model itself."""
    rng = np.random.default_rng(0)
    for map_, given in GIVEN.items():
        many = source.inputs.points(given, source.inputs.drawn(given, TABLE, rng))
        one, ask = many.iloc[[0]], getattr(source.model, map_)
        yield Row(name, "Python", map_, timed_us(ask, one), timed_us(ask, many, queries=TABLE))


def in_onnx_runtime(name: str, source: Source) -> Iterator[Row]:
    """The graphs in ONNX Runtime, one thread."""
    import onnxruntime

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    rng = np.random.default_rng(0)
    for map_, graph in graphs(source, "tsa").items():
        session = onnxruntime.InferenceSession(graph.SerializeToString(), options)
        kind = np.float64 if "double" in session.get_inputs()[0].type else np.float32
        many = source.inputs.drawn(GIVEN[map_], TABLE, rng).astype(kind)
        one = many[:1]
        single = timed_us(session.run, ["value"], {"queries": one})
        table = timed_us(session.run, ["value"], {"queries": many}, queries=TABLE)
        yield Row(name, "ONNX Runtime", map_, single, table)


def in_freia(name: str, source: Source) -> Iterator[Row]:
    """FrEIA built as the paper says, as it is and compiled; its weights are fresh, on which time does not depend."""
    if name != "inn":
        return
    import torch
    from freia import papers_inn

    torch.set_num_threads(1)
    network = papers_inn().eval()
    many = torch.randn(TABLE, 5)
    one = many[:1].clone()
    with torch.no_grad():
        for way, asked in (("FrEIA, eager", network), ("FrEIA, torch.compile", torch.compile(network))):
            for map_, back in (("forward", False), ("inverse", True)):
                single = timed_us(asked, one, rev=back, jac=False)
                table = timed_us(asked, many, rev=back, jac=False, queries=TABLE)
                yield Row("the paper's INN", way, map_, single, table)


# Every way to query a model: takes its name and source, gives rows. A new way is a new function here.
WAYS: list[Callable[[str, Source], Iterator[Row]]] = [in_c, in_onnx_runtime, in_python, in_freia]


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, metavar="processed/<material>")
    parser.add_argument("--split", default="within")
    arguments = parser.parse_args()
    print("| model | way | map | one query, µs | one of 1000, µs |\n|---|---|---|---|---|")
    for name in MODELS:
        try:
            source = opened(arguments.folder / name / f"{arguments.split}-0.model", None, Beside())
        except BadInput as error:
            print(f"left out: {error}", file=sys.stderr)
            continue
        for way in WAYS:
            for row in way(name, source):
                print(row, flush=True)


if __name__ == "__main__":
    main()
