"""A motion that nobody has recorded, and where it leaves what was."""
