"""Readings of each stroke → the indicators of a string's health, and which strokes may be compared."""
