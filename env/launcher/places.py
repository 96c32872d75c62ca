"""Where the environments lie and what they are made from."""

from pathlib import Path

ENV = Path(__file__).resolve().parents[1]
LINK, LOCK, PROFILE, ONE_AT_A_TIME = ENV / ".venv", ENV / "requirements.lock", ENV / "profile", ENV / ".venv.lock"
HELD = "pyvenv.cfg"  # the file that a command holds as long as it works in an environment


def shown(place: Path) -> str:
    """A path as the person sees it from the project's folder."""
    return str(place.relative_to(ENV.parent)) if place.is_relative_to(ENV.parent) else str(place)


def environments() -> list[Path]:
    """Every environment beside the link, whole or not."""
    return [path for path in sorted(ENV.glob(".venv-*")) if path.is_dir() and not path.is_symlink()]
