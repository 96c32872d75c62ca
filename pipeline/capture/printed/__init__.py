"""Rigs that print lines of numbers: the kind of each line, and the meaning of the columns."""
