"""What was recorded, of a material and of each of its strings: a question lies inside, or is told beyond what."""
