"""What a model is asked with, in a notebook: the complaints of a program's options, said of a function's arguments."""

import json
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

from ..ground.errors import BadInput, not_installed
from ..models.interface import names

OPTION = re.compile(r"--(\w)")


@contextmanager
def as_arguments() -> Iterator[None]:
    """Say of an argument what a program says of its option of that name, and of a package that is not installed."""
    try:
        yield
    except ModuleNotFoundError as error:
        if (lacking := not_installed(error)) is None:
            raise
        raise lacking from error
    except BadInput as error:
        if not error.file.startswith("--"):
            raise
        argument, mend = OPTION.sub(r"\1", error.file), OPTION.sub(r"\1", error.mend)
        raise BadInput(argument, error.field, error.problem, mend) from error


def settings_in_json(name: str, settings: Mapping[str, object]) -> str:
    """A model's settings as the JSON that programs take; raises BadInput for a name of none, or a value of no JSON."""
    if name not in names():
        raise BadInput("model", "name", f"is {name!r}", f"give one of model_names(): {', '.join(names())}")
    try:
        return json.dumps(settings)
    except TypeError as error:
        raise BadInput("settings", name, str(error), "give numbers, texts, true or false, or lists of these") from None
