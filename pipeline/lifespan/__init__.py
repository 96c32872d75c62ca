"""How long a string lasts: indicators of its health over strokes, and the strokes left until a limit is passed."""
