"""What a mismatch looks like, in numbers that ask for no mechanism: the mismatch → its signature."""
