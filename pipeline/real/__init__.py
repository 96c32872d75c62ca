"""Public recordings of rigs that others built: found, imported, diagnosed, and compared with black boxes."""
