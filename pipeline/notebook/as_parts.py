"""A recording in memory has no files: the complaints about its run.yaml and samples, said of the arguments."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..ground.errors import BadInput

MOTION = {"motion": "Recording.simulate: motion"}
PARTS = {"run.yaml": "Recording.of: description", "samples": "Recording.of: samples", **MOTION}


@contextmanager
def as_parts(folder: Path, is_read: bool = False) -> Iterator[None]:
    """Say of an argument what a program says of a file in a run's folder; of a run that `is_read` those are files."""
    try:
        yield
    except BadInput as error:
        path, parts = Path(error.file), MOTION if is_read else PARTS
        if path.parent != folder or path.name not in parts:
            raise
        problem, mend = error.problem, error.mend
        if not is_read:
            problem, mend = (words.replace("run.yaml", "the description") for words in (problem, mend))
        raise BadInput(parts[path.name], error.field, problem, mend) from error
