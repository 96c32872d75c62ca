"""A motion that nobody has recorded, and its parts outside the recorded range."""
