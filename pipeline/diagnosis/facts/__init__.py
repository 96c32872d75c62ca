"""What the verdict rests on, in numbers: sizes, places, loops, look-alikes, and what would have been seen."""
