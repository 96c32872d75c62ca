"""The library's own data → docs/physics.md: each mechanism's equation, what it follows and what tells it apart.

`python -m pipeline.diagnosis.words.physics_page > docs/physics.md` makes the page anew after a change of the library.
"""

import argparse

from ...ground.errors import program
from ...ground.outside_library import is_outside
from ...ground.words.glossary import MEANING
from ..mechanisms.interface import Mechanism
from ..mechanisms.library import mechanisms

HEAD = """# The physics that a simulator may leave out

Made from the library itself by `python -m pipeline.diagnosis.words.physics_page > docs/physics.md`: edit the
mechanism's file, not this page. A mechanism is a class of laws. Its equation is the kind; the engine fits sums of such
terms, so that nearby laws in print go by the same name. How names are chosen: [diagnosis.md](diagnosis.md). How a
mechanism is added:
`CONTRIBUTING.md`.

The twisted string without any of these, as the paper has it:
`x = L - d`, `L = sqrt(d^2 + y^2)`, `y = b + r theta`, `sin a = y/L`, `tan a = y/d`.

The load enters in one place. It stretches the string, and with a separator the radius falls as it does at constant
volume: `r = r0 sqrt(l / (l + F/K))`, `l` being the length of a string (`length_mm`). The stretch itself does not move
the reading: that is `axial_elasticity`. Without a measured stiffness a usual one is taken, and calibration moves it.
A pair without separator has `x = l - sqrt(l^2 - (r theta)^2)`, and no load in it.

| symbol | what | unit |
|---|---|---|
| `theta` | twist of the motor; `theta_s` is what the string sees of it, `theta'` the twist after play | rad |
| `x` | displacement (contraction); `x_m` is what the sensor reads, `dx` what an effect adds | mm |
| `d`, `b`, `L` | torsion zone, separator, length of the twisted string | mm |
| `r` | radius of the string; `r_e` is the one that acts | mm |
| `a` | helix angle | rad |
| `F`, `K` | load; stiffness of the string | N, N/mm |
| `c`, `t`, `T` | worked strokes; time; temperature (in `max T`: tension) | -, s, °C |

Worked strokes are counted by work, which grows only while the string winds: it is the load, or a power of it, times the
displacement that this winding adds. Unwinding, holds and rests add none.
"""
OWN = (
    "A mechanism that begins with `x_` is a stand-in, or belongs to a rig that is no string: alone it names no physics "
    "of a string."
)


def page() -> str:
    """The whole page, in Markdown."""
    named = [mechanism for id_, mechanism in mechanisms().items() if not is_outside(id_)]
    others = [mechanism for id_, mechanism in mechanisms().items() if is_outside(id_)]
    parts = [HEAD, *map(entry, named), f"## Beside the strings\n\n{OWN}\n", *map(entry, others)]
    return "\n".join(parts)


def entry(mechanism: Mechanism) -> str:
    """A mechanism's section."""
    rows = {
        "equation": ", or ".join(f"`{each}`" for each in (mechanism.equation, *mechanism.variants.values())),
        "follows": mechanism.driver,
        "may be taken for": mechanism.confused_with,
        "told apart by": mechanism.told_apart_by,
        "source": mechanism.source,
    }
    lines = [f"- {name}: {value}" for name, value in rows.items() if value]
    lines += [f"- `{word}` in a coefficient's name: it multiplies {what}" for word, what in mechanism.names.items()]
    meaning = MEANING.get(mechanism.id, "")
    return "\n".join([f"## {mechanism.id}", "", f"{meaning[:1].upper()}{meaning[1:]}", "", *lines, ""])


@program
def main() -> None:
    """Command line: print the page."""
    argparse.ArgumentParser(prog="python -m pipeline.diagnosis.words.physics_page", description=__doc__).parse_args()
    print(page(), end="")


if __name__ == "__main__":
    main()
