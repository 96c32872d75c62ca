"""A recording with its simulator, with any mechanisms in it, and the fit of both, with intervals."""
