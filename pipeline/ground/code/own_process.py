"""A process of its own for each item of a list: its memory is free again for the next item."""

import multiprocessing
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from typing import TypeVar

from ..command import HOUSE

Item = TypeVar("Item")
Result = TypeVar("Result")


def each_alone(
    work: Callable[..., Result],
    items: Sequence[Item],
    *arguments: object,
    jobs: int = 1,
    preload: Sequence[str] = (HOUSE,),
) -> Iterator[Result]:
    """The result of `work(item, *arguments)` for each item, in order, each in a fresh process, `jobs` at a time.

    One item is worked on in this process. `preload` are modules that each process finds imported, where the system
    can do that; the program itself is none, for a process runs it anew. An error of `work` is raised here.
    """
    if len(items) < 2:
        yield from (work(item, *arguments) for item in items)
        return
    ways = multiprocessing.get_all_start_methods()
    context = multiprocessing.get_context("forkserver" if "forkserver" in ways else "spawn")
    if "forkserver" in ways:
        context.set_forkserver_preload(list(preload))
    with ProcessPoolExecutor(max(jobs, 1), context, max_tasks_per_child=1) as pool:
        waiting = [pool.submit(work, item, *arguments) for item in items]
        for future in waiting:
            yield future.result()
