"""Earlier verdicts on fewer of the same runs, in words: this one, from more data, replaces them and may differ."""

from pathlib import Path
from typing import cast

from ....ground.errors import BadInput
from ....ground.outside_library import is_outside
from ...document.bounds import of_later_run
from ...document.content import Verdict
from ...document.effects_named import Dimension, MechanismEntry
from ...prediction.simulation import read_diagnosis
from ..language.quantity import listing, percent
from ..measured.dimensions import from_to, name_of

USUAL = Path("reports/diagnosis")
OF_ONE = "are they of one string, mounted and measured alike?"
MOST = 2  # earlier verdicts that are told; dimensions of one of them
NOTHING = 0.5  # of its tolerance: a dimension that differs by less is the same


def sentences(content: Verdict, folders: list[Path], out: Path) -> list[str]:
    """A sentence for each earlier verdict on some of the runs, the one on most runs first.

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
                f"Before, the verdict on {alone} alone ({place}) {_said(before)}. "
                f"{_replaced(before, content)}{_dropped(before, content)}"
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


def _replaced(before: Verdict, content: Verdict) -> str:
    """The remark on an earlier verdict beside this one, in a sentence."""
    alone = before.get("verdict") == "explained"
    if alone and content["verdict"] == "unknown":
        return f"Alone it was explained, together the runs are not: {OF_ONE}"
    stand_ins = [id_ for id_ in _names(content) if is_outside(id_) and id_ not in _names(before)]
    if alone and stand_ins:
        return f"Alone it was explained without {listing(stand_ins)}, which is no physics of the library: {OF_ONE}"
    return "This one rests on more data and replaces it."


def _dropped(before: Verdict, content: Verdict) -> str:
    """The names and dimensions of an earlier verdict that this one drops, in a sentence; else nothing."""
    named, now = _names(before), _names(content)
    tied = {id_ for ids in content.get("alternatives", []) for id_ in ids}
    gone = [id_ for id_ in named if id_ not in now]
    parts = [f"does not name {listing([id_ for id_ in gone if id_ not in tied], 'or')}"] if set(gone) - tied else []
    if set(gone) & tied:
        parts.append(f"has {listing([id_ for id_ in gone if id_ in tied])} only in another likely explanation")
    parts += [f"has a {name_of(name)} of {now_is}, not {was}" for name, was, now_is in _moved(before, content)]
    return f" This one {listing(parts)}." if parts else ""


def _moved(before: Verdict, content: Verdict) -> list[tuple[str, str, str]]:
    """Dimensions whose intervals in two verdicts do not overlap, if clearly apart: name, old value, new value."""
    apart = []
    for name, sigma in content["evidence"].get("tolerance", {}).items():
        was, now = (each.get("parameters", {}).get(name) for each in (before, content))
        if was is None or now is None or of_later_run(name) or not (_whole(was) and _whole(now)):
            continue
        gap = max(now["low"] - was["high"], was["low"] - now["high"])
        if gap > 0.0 and abs(now["value"] - was["value"]) > NOTHING * sigma:
            spelled = {name: {**was, "nominal": now["nominal"]}}
            earlier = cast(Verdict, {"parameters": spelled, "evidence": content["evidence"]})
            apart.append((name, from_to(earlier, name)[1], from_to(content, name)[1]))
    return apart[:MOST]


def _whole(dimension: Dimension) -> bool:
    """Whether a dimension has a value with its interval."""
    return all(isinstance(dimension.get(key), int | float) for key in ("value", "low", "high"))


def _names(content: Verdict) -> list[str]:
    """The ids of what a verdict names."""
    listed = content.get("mechanisms")
    return [str(entry["id"]) for entry in (listed if isinstance(listed, list) else []) if isinstance(entry, dict)]


def _said(content: Verdict) -> str:
    """The names of a verdict, the likeliest first; its word where it names nothing."""
    listed = content.get("mechanisms")
    named = listed if isinstance(listed, list) else []
    entries = [entry for entry in named if isinstance(entry, dict) and "id" in entry]
    if not entries:
        return f"was {content.get('verdict', 'another')}"
    return f"named {listing([_sure(entry) for entry in sorted(entries, key=lambda entry: -_share(entry))])}"


def _sure(entry: MechanismEntry) -> str:
    return f"{entry['id']} ({percent(_share(entry))})" if _share(entry) else str(entry["id"])


def _share(entry: MechanismEntry) -> float:
    share = entry.get("confidence")
    return float(share) if isinstance(share, int | float) else 0.0
