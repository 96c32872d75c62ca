"""The warning that a diagnosis was made of another string or rig than the run that is simulated with it."""

from ....ground.units import unit_of
from ..language.quantity import listing, number, said_unit
from ..language.vocabulary import Vocabulary


def warning(
    run: str, runs: list[str], dimensions: dict[str, tuple[float, float]], names: tuple[str, str] | None,
    words: Vocabulary,
) -> str:  # fmt: skip
    """The warning that `run` is of another rig than `runs`, by dimensions and names; nothing where it is not."""
    of, what = listing(runs), "string" if words.twisted else "rig"
    signs = [f"it names the string {names[1]}, and {of} {names[0]}"] if names else []
    if dimensions:
        changes = [
            f"{_name(name)} {number(own, 6)} {said_unit(unit_of(name))}".rstrip() + f" ({number(before, 6)} there)"
            for name, (before, own) in dimensions.items()
        ]
        signs.append(f"its run.yaml has {listing(changes)}")
    if not signs:
        return ""
    return (
        f"{run} is of another {what} than {of}, of which the diagnosis is: {'; '.join(signs)}. A diagnosis holds for "
        f"its own {what}. Mend: diagnose {run} itself, or correct its run.yaml"
    )


def _name(parameter: str) -> str:
    """A dimension without its unit: `torsion zone` for `torsion_zone_mm`."""
    return parameter.removesuffix(f"_{unit_of(parameter).lower().replace('/', '_per_')}").replace("_", " ")
