"""A recording with its simulator and any mechanisms in it, and the fit of these, with intervals."""
