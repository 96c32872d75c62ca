"""What an earlier verdict on fewer of the same runs said, in words: more data replace it, which a reader must know."""

from pathlib import Path

from ..ground.errors import BadInput
from .content import Part, Verdict
from .simulation import read_diagnosis
from .words.quantity import listing, percent

USUAL = Path("reports/diagnosis")
MOST = 2  # earlier verdicts that are told


def sentences(content: Verdict, folders: list[Path], out: Path) -> list[str]:
    """A sentence for each earlier verdict on some of the runs alone, of most runs first; nothing where none is found.

    Looked through are the folder `out`, which a new verdict overwrites, what is in and beside it, and the usual place.
    """
    now, lines = _runs(content), dict[frozenset[str], str]()
    if len(now) < 2:
        return []
    beside = [place / folder.resolve().name for place in (out, out.parent, USUAL) for folder in folders]
    for place in (out, *beside):
        before = _read(place / "diagnosis.json")
        if before is not None and _runs(before) < now and _runs(before) not in lines:
            alone = listing(sorted(_runs(before)))
            lines[_runs(before)] = (
                f"Before, the verdict on {alone} alone ({place}) {_said(before)}. This one rests on more data and "
                "replaces it."
            )
    return [lines[runs] for runs in sorted(lines, key=lambda runs: -len(runs))[:MOST]]


def _read(path: Path) -> Verdict | None:
    """A diagnosis.json; None where there is none, or none that can be read."""
    try:
        return read_diagnosis(path) if path.is_file() else None
    except (BadInput, OSError):
        return None


def _runs(content: Verdict) -> frozenset[str]:
    """The runs that a verdict is on."""
    runs = content["run"]
    return frozenset([runs] if isinstance(runs, str) else map(str, runs))


def _said(content: Verdict) -> str:
    """What a verdict named, the likeliest first; its word where it named nothing."""
    listed = content.get("mechanisms")
    known = listed if isinstance(listed, list) else []
    entries = [entry for entry in known if isinstance(entry, dict) and "id" in entry]
    if not entries:
        return f"was {content.get('verdict', 'another')}"
    return f"named {listing([_sure(entry) for entry in sorted(entries, key=lambda entry: -_share(entry))])}"


def _sure(entry: Part) -> str:
    return f"{entry['id']} ({percent(_share(entry))})" if _share(entry) else str(entry["id"])


def _share(entry: Part) -> float:
    share = entry.get("confidence")
    return float(share) if isinstance(share, int | float) else 0.0
