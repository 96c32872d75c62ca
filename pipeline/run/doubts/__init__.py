"""Unlikely contents of a recording or its description: questions and refusals before it is used."""
