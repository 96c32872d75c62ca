"""The effects that a verdict names: how sure and how large each is, what it does, and what looks like it."""
