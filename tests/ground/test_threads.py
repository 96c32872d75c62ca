"""One process, one thread of linear algebra, whoever starts it: no variable changes a byte."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from first_few import first_few
from models.made_dataset import made_dataset

from pipeline import ONE_THREAD
from pipeline.ground.stored import schemas

ROOT = Path(__file__).parents[2]
COUNT = "from threadpoolctl import threadpool_info; print({one['num_threads'] for one in threadpool_info()})"


def run(*words: object, threads: str | None = None) -> str:
    """Output of a Python of its own, whose environment names a number of threads, or none."""
    environment = {name: value for name, value in os.environ.items() if name not in ONE_THREAD}
    environment |= {"OMP_NUM_THREADS": threads, "OPENBLAS_NUM_THREADS": threads} if threads else {}
    command = [sys.executable, *map(str, words)]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize(
    ("first", "threads"),
    first_few(
        [
            ("pipeline.predict", None),
            ("numpy, scipy.linalg, pipeline", "4"),
            ("pipeline.diagnose", "4"),
            ("pipeline.models.cinn", "4"),
        ],
        2,
    ),
)
def test_every_library_has_one_thread(first: str, threads: str | None) -> None:
    assert run("-c", f"import {first}; import numpy, scipy.linalg; {COUNT}", threads=threads) == "{1}\n"


@pytest.mark.long
def test_a_trained_model_has_the_same_bytes_whatever_the_variable(tmp_path: Path) -> None:
    dataset = tmp_path / "dataset.parquet"
    schemas.write(made_dataset(300, 4), schemas.DATASET, dataset)
    for model, settings in (("spline", '{"steps": 4}'), ("polynomial", "{}")):
        outputs = set()
        for threads in (None, "1", "4"):
            out = tmp_path / str(threads)
            words = ("--model", model, "--settings", settings, "--split", "within", "--out-model", out / "model")
            run("-m", "pipeline.stages.train", dataset, *words, "--out-predictions", out / "p.parquet", threads=threads)
            outputs.add(((out / "model").read_bytes(), (out / "p.parquet").read_bytes()))
        assert len(outputs) == 1, model
