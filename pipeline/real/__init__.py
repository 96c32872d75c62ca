"""Public recordings of rigs that nobody here built: found, imported, diagnosed, and set beside black boxes."""
