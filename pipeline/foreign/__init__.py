"""The import of a foreign recording, beside the readers: its clock mended, its axes separated, a mapping drafted."""
