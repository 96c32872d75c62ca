"""How things are called and written on any rig: numbers with units, places, tables, sections, and words explained."""
