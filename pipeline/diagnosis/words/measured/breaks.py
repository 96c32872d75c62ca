"""Changes in the break between two runs that are diagnosed together: they are told, and are no effect."""

from ...document.bounds import HOME_REACH, of_later_run
from ...document.content import Verdict
from ..language.quantity import listing, number
from .dimensions import LEAVES
from .tolerances import stem

MAY = 0.98  # of that reach, from which more may have changed
WHY = (
    "A string hung anew or of another radius, a motor homed or switched off, and lost counts do that alike. No run "
    "shows it happen, so it is taken as the motor's zero, and no effect is named for it"
)
MORE = "This is as far as the zero may go: another string, or another rig, is more likely. Diagnose the runs apart"


def changed(content: Verdict) -> list[str]:
    """The remark that the motor's zero moved in a later run by more than its tolerance; else nothing."""
    runs, tolerance = content["run"], content["evidence"].get("tolerance", {})
    own = {name: abs(entry["value"]) for name, entry in content["parameters"].items() if of_later_run(name)}
    moved = {name: turns / tolerance[stem(name)] for name, turns in own.items() if tolerance.get(stem(name))}
    far = {name: sigma for name, sigma in moved.items() if sigma > LEAVES}
    if not far or isinstance(runs, str):
        return []
    each = [f"in {runs[int(name.rpartition('_')[2]) - 1]} by {_turns(content, name)}" for name in far]
    ends = [WHY, *([MORE] if max(far.values()) >= MAY * HOME_REACH else [])]
    return [f"Between the runs the twist changed, {listing(each)}. {'. '.join(ends)}."]


def _turns(content: Verdict, name: str) -> str:
    value = number(content["parameters"][name]["value"], 2)
    return f"{value} turn{'s' * (value != '1')}"
