"""Bad input, said so that a person can mend it."""

import functools
import sys
from collections.abc import Callable
from pathlib import Path


class BadInput(Exception):
    """Input that cannot be used: which file, which field, what is wrong and how to mend it."""

    def __init__(self, file: Path | str, field: str, problem: str, mend: str) -> None:
        super().__init__(f"{file}: {field}: {problem}. Mend: {mend}.")
        self.file, self.field, self.problem, self.mend = str(file), field, problem, mend


def program(main: Callable[[], int | None]) -> Callable[[], None]:
    """Turn a `main` into a command: exit 0 when done, 2 on bad input with one line that names the mend."""

    @functools.wraps(main)
    def command() -> None:
        try:
            status = main()
        except BadInput as error:
            print(f"error: {error}", file=sys.stderr)
            status = 2
        sys.exit(status or 0)

    return command
