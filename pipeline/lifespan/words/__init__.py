"""The statements on a string's life, in sentences."""
