"""What the numbers of adopted effects mean, from the library's own data: name, unit and what each does."""

import re
from collections.abc import Sequence

from ..drivers import Drivers
from ..library import mechanisms
from ..problem import Act
from .quantity import listing, number, said_unit
from .vocabulary import Vocabulary

HEAD = (
    "What the numbers under simulation mean, for who looks: nobody needs them to predict. Equations and sources: "
    "docs/physics.md."
)
BRANCH = re.compile(r"(?:^|_)([0-9.]+)_s_")
CHOSEN = "numbers in the equation itself, chosen by the search or fitted"
DOES = {
    "twist": "act on the {motion}",
    "radius": "change the radius, as a share of it",
    "length": "lengthen the {string}",
    "resistance": "are lost where motion is resisted",
    "sensor": "add to the reading",
}  # what coefficients do, by the port that they act at


def multiplied(words: dict[str, str], names: Sequence[str]) -> list[str]:
    """What each word in the names of coefficients multiplies, a line each; of two words at one place the longer one."""
    left, lines = [f"_{name}_" for name in dict.fromkeys(names)], []
    for word, what in sorted(words.items(), key=lambda item: -len(item[0])):
        pattern = re.compile(f"_{re.escape(word)}_".replace(r"\*", "[0-9.]+"))
        if any(pattern.search(name) for name in left):
            lines.append(f"    {word.replace('_*', '')} in a name: it multiplies {what}")
        left = [pattern.sub("_", name) for name in left]
    return lines


def lines(acts: Sequence[Act], drivers: Drivers, words: Vocabulary) -> list[str]:
    """Each effect with its equation, then its coefficients by what they do, then the shape that they were found at."""
    blocks = dict.fromkeys(tuple(_block(act, drivers, words)) for act in acts)  # an effect may act several times
    act_lines = [line for block in blocks for line in block]
    return [HEAD, *act_lines] if act_lines else []


def _block(act: Act, drivers: Drivers, words: Vocabulary) -> list[str]:
    mechanism = mechanisms()[act.id]
    written = [f"  {act.id}: {mechanism.equation}"]
    groups: dict[str, dict[str, float]] = {}
    values = iter(act.coefficients)
    for nonlinear in act.nonlinear:
        for term in mechanism.terms(drivers, nonlinear):
            value = next(values)
            if value:
                unit = said_unit(drivers.units.unit(term.unit))
                what = DOES[term.port].format(motion=words.motion, string=words.string)
                does = f"in {unit}, {what}" if unit else f"as shares, {what}"
                groups.setdefault(does, {})[drivers.units.name(term.name)] = value
    for does, strengths in groups.items():
        each = [f"{name} = {number(value, 3)}" for name, value in strengths.items()]
        written.append(f"    {listing(each)}: {does}")
    held = [name for strengths in groups.values() for name in strengths]
    written += multiplied(mechanism.names, held)
    branch = next((match[1] for name in held if (match := BRANCH.search(name))), None)
    written += (
        [f"    {branch}_s in a name: of the branch with a time constant of {branch} s; so for others"] if branch else []
    )
    fixed = {drivers.units.name(name): value for nonlinear in act.nonlinear for name, value in nonlinear.items()}
    each = [f"{name} = {number(value, 3)}" for name, value in fixed.items()]
    written += [f"    {listing(each)}: {CHOSEN}"] if fixed else []
    return written
