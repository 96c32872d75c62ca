"""The tolerances that a verdict depends on, in the keys and units of `run.yaml`: shares or lengths."""

import math
import re

from ....ground.units import unit_of
from ...document.content import Verdict
from ..language.quantity import listing, number, quantity
from ..language.vocabulary import Vocabulary

STIFFNESS = "stiffness_n_per_mm"  # no tolerance of run.yaml: calibration moves it freely where it is assumed
KEYS = {"radius_mm": "radius"}  # keys of `tolerance:` in run.yaml that are not the dimension's own name
SHOWN_BY_A_CALIPER_MM = 0.01  # its last digit: nobody measures a radius by hand to less


def stem(name: str) -> str:
    """A dimension without the number of its run: `angle_turns` for `angle_turns_2`."""
    return re.sub(r"_\d+$", "", name)


def key_of(name: str) -> str:
    """The key of `tolerance:` in `run.yaml` of a dimension."""
    return KEYS.get(stem(name), stem(name))


def share(content: Verdict, name: str, words: Vocabulary) -> float | None:
    """The tolerance of a dimension as a share of its value; None where run.yaml gives it in the dimension's unit."""
    sigma = content["evidence"].get("tolerance", {}).get(name)
    nominal = content["parameters"].get(name, {}).get("nominal")
    if not sigma or not nominal or key_of(name) not in words.shares:
        return None
    return float(sigma) / abs(float(nominal))


def said(content: Verdict, name: str, words: Vocabulary) -> str:
    """The tolerance of a dimension: `0.012 mm (3 %)`, `0.5 %`, `1 mm`; nothing where the diagnosis does not hold it."""
    sigma = content["evidence"].get("tolerance", {}).get(name)
    if sigma is None:
        return ""
    part, unit = share(content, name, words), unit_of(stem(name))
    own = quantity(sigma, unit)
    if part is None:
        return own
    return f"{own} ({percent(part)})" if unit not in ("", "1") else percent(part)


def is_default(content: Verdict, name: str, words: Vocabulary) -> bool:
    """Whether a tolerance is the default one, used where run.yaml gives none."""
    if key_of(name) in content["evidence"].get("tolerances_given", []):
        return False
    sigma, part = content["evidence"].get("tolerance", {}).get(name), share(content, name, words)
    usual = words.usual.get(key_of(name))
    return bool(sigma and usual) and math.isclose((sigma if part is None else part) or 0.0, usual or 0.0, rel_tol=1e-6)


def marked(content: Verdict, name: str, words: Vocabulary) -> str:
    """The tolerance of a dimension as `said`, with `default` beside it if run.yaml gives none."""
    tolerance = said(content, name, words)
    if not tolerance or not is_default(content, name, words):
        return tolerance
    return f"{tolerance.removesuffix(')')}, default)" if tolerance.endswith(")") else f"{tolerance} (default)"


def percent(part: float) -> str:
    """A share as run.yaml gives it, in per cent: 3 %, 0.5 %, 1.25 %."""
    return f"{number(100.0 * part, 3)} %"


def in_force(content: Verdict, words: Vocabulary) -> list[str]:
    """All tolerances as a block of `run.yaml`, which of them are shares, and how an assumed stiffness is told.

    Nothing where none is known.
    """
    block: dict[str, float] = {}
    for name, sigma in content["evidence"].get("tolerance", {}).items():
        if key_of(name) in words.usual:
            part = share(content, name, words)
            block.setdefault(key_of(name), sigma if part is None else part)
    if not block:
        return _stiffness(content)
    written = ", ".join(f"{key}: {number(value, 4).replace(',', '')}" for key, value in block.items())
    shares = [key for key in block if key in words.shares]
    what = ""
    if shares:
        are = "are shares" if len(shares) > 1 else "is a share"
        first = number(block[shares[0]], 4)
        what = f" ({listing(shares)} {are} of the value: {first} is {percent(block[shares[0]])})"
    keys_given = content["evidence"].get("tolerances_given", [])
    defaults = [
        key
        for key, value in block.items()
        if key not in keys_given and math.isclose(value, words.usual.get(key, math.nan), rel_tol=1e-6)
    ]
    which = "All" if len(defaults) == len(block) else listing(defaults)
    are = "are defaults" if len(defaults) > 1 else "is a default"
    whence = f" {which} {are}: run.yaml gives no other." if defaults else ""
    return [f"Now in force, as run.yaml writes it: `tolerance: {{{written}}}`{what}.{whence}", *_stiffness(content)]


def _stiffness(content: Verdict) -> list[str]:
    """How run.yaml tells a stiffness that nobody measured; nothing where none was assumed."""
    if not any(stem(name) == STIFFNESS for name in content["evidence"].get("tolerance", {})):
        return []
    told_by = f"write `{STIFFNESS}: VALUE` under `string` in run.yaml"
    return [f"The stiffness is assumed and has no tolerance there. Once you have measured it, {told_by}."]


def doubts(content: Verdict, words: Vocabulary) -> list[str]:
    """The question on a share that stands for fewer mm than a hand can measure: it is likely a length in mm."""
    lines = []
    for name in content["evidence"].get("tolerance", {}):
        part, key = share(content, name, words), key_of(name)
        if part is None or not name.endswith("_mm") or part >= 0.99 * words.shares[key]:
            continue
        nominal = abs(float(content["parameters"][name]["nominal"]))
        if part * nominal >= SHOWN_BY_A_CALIPER_MM:
            continue
        ratio = number(part, 4)
        lines.append(
            f"run.yaml says `tolerance: {{{key}: {ratio}}}`. That is a share: {percent(part)} of {number(nominal, 4)} "
            f"mm, or {quantity(part * nominal, 'mm')}, which takes care to measure by hand. If {ratio} mm was meant, "
            f"write {key}: {number(part / nominal, 3)} and diagnose again. If the share is right, change nothing."
        )
    return lines
