"""The titles of the models in the reports, and their order."""

from ...ground.errors import BadInput


def titles_of(pairs: list[str]) -> dict[str, str]:
    """Models and their titles, in order, from arguments of the form `inn=INN model`."""
    for pair in pairs:
        if "=" not in pair:
            raise BadInput("--titles", pair or "the empty one", "has no =", "write it as inn='INN model'")
    return dict(pair.split("=", 1) for pair in pairs)
