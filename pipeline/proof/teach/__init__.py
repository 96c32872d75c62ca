"""Teach the judge of the diagnosis: cases by authors, what the search makes of them, and the weights that follow."""
