"""A run's newest verdict anywhere in reports/: alone, together with others, or in a step of settle."""

import contextlib
import os
import re
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

from ..ground.words.verdict_text import headline
from .reports_of_run import names_in, newest_first, page_of, text_of

HEAD = 4096  # bytes of a diagnosis.json, whose first key says of which runs it is
RUNS = re.compile(r'^\{\s*"run"\s*:\s*(\[[^\]]*\]|"[^"]*")')
QUOTED = re.compile(r'"([^"]*)"')
FILE = "diagnosis.json"


@lru_cache(maxsize=4096)
def _runs_of(path: Path, _changed_ns: int) -> tuple[str, ...]:
    """The runs that a diagnosis is of."""
    with contextlib.suppress(OSError), open(path, encoding="utf-8", errors="replace") as file:
        if match := RUNS.match(file.read(HEAD)):
            return tuple(QUOTED.findall(match[1]))
    return ()


def _joint(reports: Path) -> Iterator[Path]:
    """The possible places of a diagnosis of several runs, or of a step of settle."""
    for name in names_in(reports):
        yield reports / name / FILE
        for below in names_in(reports / name):
            yield reports / name / below / FILE
            if name == "settle":
                yield from (reports / name / below / step / FILE for step in names_in(reports / name / below))


def _dated(paths: Iterator[Path]) -> list[tuple[int, Path]]:
    dated = []
    for path in paths:
        with contextlib.suppress(OSError):
            dated.append((os.stat(path).st_mtime_ns, path))
    return dated


def newest_verdict(reports: Path, run: str) -> dict[str, str] | None:
    """The first words of a run's newest verdict, its page as a path below reports/, and its runs, in words."""
    own = _dated(iter(newest_first(reports, run, FILE)))
    joint = [(changed, path) for changed, path in _dated(_joint(reports)) if run in _runs_of(path, changed)]
    for changed, path in sorted({*own, *joint}, reverse=True):
        if verdict := headline(text_of(path.parent / "verdict.txt")):
            page = page_of(path.parent).relative_to(reports).as_posix()
            return {"verdict": verdict, "page": page, "of": _of(path, _runs_of(path, changed), run)}
    return None


def _of(path: Path, runs: tuple[str, ...], run: str) -> str:
    """The step of a diagnosis, and its other runs; empty for a diagnosis of this run alone."""
    step = path.parent.name
    words = [f"{run} in step {step.removeprefix('step-')} of settle"] if re.fullmatch(r"step-\d+", step) else []
    others = [each for each in runs if each != run]
    words += [f"together with {' and '.join(others)}"] if others else []
    return ", ".join(words)
