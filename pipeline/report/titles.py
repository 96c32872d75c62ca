"""What the models are called in the reports, and in which order they stand."""


def titles_of(pairs: list[str]) -> dict[str, str]:
    """Models and their titles, in order, from arguments of the form `inn=INN model`."""
    return dict(pair.split("=", 1) for pair in pairs)
