"""Ids of physics outside the library of known physics: of mechanisms and of concealed effects."""


def is_outside(id_: str) -> bool:
    """Whether the beginning of an id says that it is outside every library of known physics."""
    return id_.startswith("x_")
