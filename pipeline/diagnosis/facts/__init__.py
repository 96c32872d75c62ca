"""The numbers that the verdict rests on: sizes, places, loops, look-alikes, and what would have been seen."""
