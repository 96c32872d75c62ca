"""A recording in whatever form → a table of channels in our units."""
