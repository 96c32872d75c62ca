"""What is said of a string's life, in sentences."""
