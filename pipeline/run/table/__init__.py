"""A recording of any form → a table of channels in our units."""
