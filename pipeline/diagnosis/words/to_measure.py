"""The dimensions to measure again: what run.yaml says, what fits best, how to measure, and then what."""

from typing import Any

from .dimensions import assumed, exactness, far_moved, from_to, name_of, tolerance_keys
from .error_table import aligned
from .tolerances import stem
from .vocabulary import Vocabulary

HEAD = ["dimension", "run.yaml says", "fits best", "measure to"]


def table(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """Each dimension that calibration moved far, the farthest first, with how it is measured below it."""
    moved = sorted(far_moved(content).items(), key=lambda item: -abs(item[1]))
    rows = []
    for name, _ in moved:
        nominal, value = from_to(content, name)
        said = f"nothing ({nominal} is assumed)" if assumed(name) else nominal
        rows.append([name_of(name), said, value, f"{exactness(content, name)} or better"])
    head, *lines = aligned([HEAD, *rows])
    found = [head]
    for (name, _), line in zip(moved, lines, strict=True):
        how = words.measured.get(stem(name))
        found += [line, *([f"    {how}"] if how else [])]
    return found


def consequences(content: dict[str, Any], then: str) -> list[str]:
    """What to do with what was measured; `then` is what to do where nothing changed."""
    moved = far_moved(content)
    where = ", ".join(f"{key}: …" for key in tolerance_keys(moved))
    exact = (
        f"- the same value, but more exactly: write how exactly (`tolerance: {{{where}}}`, see details.txt under "
        "Dimensions), and diagnose again;"
    )
    gain = " (a gain as `scale`, see details.txt)" if any(stem(name) == "scale" for name in moved) else ""
    return [
        f"- another value: write it into run.yaml{gain}, and diagnose again: this verdict can change;",
        *([exact] if where else []),
        f"- the same as before, for all: leave run.yaml as it is, and {then}. Then physics that the library lacks may "
        "have moved them; no percentage covers that.",
    ]
