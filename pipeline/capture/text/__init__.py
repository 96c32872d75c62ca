"""Rigs that print lines of numbers: what each line is, and what its columns are."""
