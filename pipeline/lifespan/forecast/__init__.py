"""Indicators over strokes → laws, futures, and the strokes left until a limit is passed."""
