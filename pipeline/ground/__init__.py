"""The base of all other rooms: errors, files, checked tables, units, the paper's equations."""
