"""Ids of physics that the library of known physics does not hold: of mechanisms and of concealed effects."""


def is_outside(id_: str) -> bool:
    """Whether an id says by its beginning that no list of known physics holds it."""
    return id_.startswith("x_")
