"""One run: what its folder says, its recording in whatever form, its samples checked at the door, and its strokes."""
