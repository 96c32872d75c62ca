"""Where an imported run came from, as comments of its run.yaml."""

from pathlib import Path

from ..ground.stored.files import sha256

PROJECT = Path(__file__).resolve().parents[2]


def origin(file: Path, mapping: Path) -> str:
    """The origin of a run as comments of YAML: both files and their check sums; the project's own by its place."""
    origins = (("imported from", file), ("through the mapping", mapping))
    return "".join(f"# {what} {str(_shown(path))!a}, sha256 {sha256(path)}\n" for what, path in origins)


def _shown(path: Path) -> Path:
    return path.relative_to(PROJECT) if path.is_relative_to(PROJECT) else path
