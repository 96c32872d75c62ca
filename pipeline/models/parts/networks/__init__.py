"""What the networks are made of, and how they are trained."""
