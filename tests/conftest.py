"""Fixtures that every test can use."""

import os
import sys
from collections.abc import Callable, Generator
from pathlib import Path
from typing import Any

import compiled_once
import once
import pandas as pd
import pytest
import yaml
from hypothesis import settings
from made_recording import content, recording

# No test asserts a time: a busy machine is not a failure. The same cases are drawn each time, so that a change fails or
# the next one does, not whoever runs the tests by chance; `pytest --hypothesis-profile explore` draws others.
settings.register_profile("the same", deadline=None, derandomize=True)
settings.register_profile("explore", deadline=None)
settings.load_profile("the same")

# What is compiled is kept, whatever the shell says: else each process compiles all tests, and each program the package.
sys.dont_write_bytecode = False
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)

TESTS = Path(__file__).parent
# Folders whose files take longest, dearest first: begun first, none of them leaves a worker without work at the end.
# The first line is of those that take minutes; of most of them all tests are long.
FIRST = (
    *("cluster", "workflow", "real", "package", "rigs", "run", "settle", "proof"),
    *("diagnosis", "env", "house", "models", "notebook", "export", "pages", "faults", "watch", "capture", "rig"),
)
# Folders whose tests wait most of their time, for ports, processes and silences. Their files are spread among those
# that compute, but for the last fifth: begun one after another, all processes would wait at once, or one at the end.
WAITING = ("capture", "env", "faults", "watch")


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(collector: pytest.Collector) -> Generator[None, pytest.CollectReport, Any]:
    """Let each process read the folders from another one on: in a fresh clone each then compiles a share of the tests.

    Read in one order, they would all compile the same file at the same time, which costs each 20 CPU s.
    """
    report = yield
    if collector.path == TESTS and isinstance(collector, pytest.Dir):
        number = int(os.environ.get("PYTEST_XDIST_WORKER", "gw0").removeprefix("gw"))
        processes = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
        begin = number * len(report.result) // processes
        report.result = [*report.result[begin:], *report.result[:begin]]
    return report


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Put the files of those folders first, and spread those that wait.

    A file's tests stay together and in order, one for all processes.
    """
    folders = {item.path: item.path.relative_to(TESTS).parts[0] for item in items}
    places = {folder: (FIRST.index(folder) if folder in FIRST else len(FIRST), folder) for folder in folders.values()}
    ordered, shares = sorted(folders, key=lambda path: places[folders[path]]), {}
    for waits in (False, True):
        group = [path for path in ordered if (folders[path] in WAITING) == waits]
        until = 0.8 if waits else 1.0
        shares |= {path: (until * (number + 0.5) / len(group), path) for number, path in enumerate(group)}
    items.sort(key=lambda item: shares[item.path])


def pytest_sessionstart(session: pytest.Session) -> None:
    """Before there are many processes, begin to compile what all of them need."""
    if session.config.getoption("numprocesses", None) and (process := compiled_once.begin()):
        session.config.add_cleanup(lambda: (process.terminate(), process.wait()))


def pytest_sessionfinish(session: pytest.Session) -> None:
    """At the end of all processes, which the one without a worker's name sees last, remove what they shared."""
    if "PYTEST_XDIST_WORKER" not in os.environ:
        once.forget(session.config._tmp_path_factory.getbasetemp())


@pytest.fixture
def make_run(tmp_path: Path) -> Callable[..., Path]:
    """Write a run folder under tmp_path/raw and return it; `samples` and `text` replace its recording and run.yaml."""

    def make(name: str, samples: pd.DataFrame | None = None, suffix: str = ".parquet", **changes: Any) -> Path:
        folder = tmp_path / "raw" / name
        folder.mkdir(parents=True)
        (folder / "run.yaml").write_text(yaml.safe_dump(content(name, **changes)))
        table = recording() if samples is None else samples
        path = folder / f"recording{suffix}"
        if suffix == ".parquet":
            table.to_parquet(path, index=False)
        else:
            table.to_csv(path, index=False)
        return folder

    return make
