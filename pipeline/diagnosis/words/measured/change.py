"""By how many per cent a dimension moved from its value in run.yaml, in words."""

from ...document.content import Verdict
from ..language.quantity import number

COUNTS = "`moved by` counts tolerances; in brackets: per cent of the value before."


def percent(content: Verdict, name: str) -> str:
    """By how many per cent a dimension moved, with its sign: `+2 %`; empty where it begins at 0 or did not move."""
    nominal, value = (float(content["parameters"][name][end]) for end in ("nominal", "value"))
    part = 100.0 * (value - nominal) / abs(nominal) if nominal else 0.0
    return f"{'+' if part > 0.0 else ''}{number(part)} %" if part else ""


def in_brackets(content: Verdict, name: str) -> str:
    """The same behind a value, in brackets after a blank; empty where there is none."""
    moved = percent(content, name)
    return f" ({moved})" if moved else ""
