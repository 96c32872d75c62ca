"""The explanations that were weighed: how probable each is, why others are less likely, and what is left unnamed."""
