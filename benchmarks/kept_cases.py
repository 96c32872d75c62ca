"""Cases that are measured one by one, each kept in a file at once: what the file has is not measured again."""

import json
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any


def kept_cases(drawn: Iterable[Any], file: Path, measured: Callable[[Any], dict[str, Any]]) -> list[dict[str, Any]]:
    """A line of each case in the file, and of each drawn one that was not in it, which is measured and added.

    A case is known by its `author`, `seed` and `effect`, as `settled_ties.Case` has them.
    """
    lines = [json.loads(line) for line in file.read_text().splitlines()] if file.is_file() else []
    known = {(line["author"], line["seed"], line["effect"]) for line in lines}
    for case in drawn:
        if (case.author, case.seed, case.effect) not in known:
            lines.append(measured(case))
            with file.open("a") as to_file:
                print(json.dumps(lines[-1]), file=to_file)
    return lines
