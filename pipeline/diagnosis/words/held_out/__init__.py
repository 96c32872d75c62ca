"""What strokes that no fit has seen say: whether an explanation holds there, and what must be known first."""
